#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "rocking/section/classification.hpp"
#include "rocking/text/json.hpp"
#include "support/split_mix.hpp"

/// Random scenes in which nothing is random along the way, and how a label compares with where the motion goes.
namespace rocking::support {

inline Json labelled_block(SplitMix& draw) {
  const double height = draw.uniform(2.0, 12.0);
  if (draw.below(4) != 0) return {{"width_m", 1.0}, {"height_m", height}};
  const double left = draw.uniform(0.35, 0.65);
  return {{"edges_m", {left, 1.0 - left}}, {"centre_height_m", 0.5 * height}, {"radius_of_gyration_m", 0.32 * height}};
}

/// Half of the scenes lose energy as Housner's block does, half less, down to a ratio of the rates of 0.995. A third slides.
inline Json labelled_scene(std::uint64_t seed, int number) {
  SplitMix draw(seed * 1'000'003ULL + static_cast<std::uint64_t>(number));
  Json scene{{"format", "rocking.experiment/1"}, {"title", "a random scene"}, {"realisations", 1}};
  scene["block"] = labelled_block(draw);
  const double amplitude = std::exp(draw.uniform(0.0, 2.2));
  scene["excitation"] = {{"kind", "harmonic"}, {"amplitude", amplitude}, {"frequency_ratio", draw.uniform(3.0, 20.0)}};
  scene["accuracy"] = {{"tolerance", 1e-12}};
  scene["initial"] = {{"tilt", draw.uniform(-0.6, 0.6)}, {"tilt_rate", draw.uniform(-0.5, 0.5)}};
  const double height = scene["block"].value("height_m", 6.0);
  const double of_housner = 1.0 - 1.5 / (1.0 + height * height);
  if (draw.below(2) == 0) scene["restitution"] = {{"rate_ratio", draw.uniform(std::min(of_housner, 0.98), 0.995)}};
  const double friction = draw.uniform(0.15, 0.6);
  if (draw.below(3) == 0) scene["friction"] = {{"static", friction}, {"kinetic", 0.85 * friction}};
  return scene;
}

/// Whether a label and the truth agree: `right`, `unresolved`, or `wrong` with both. The truth is the name of a response mode, or
/// `none` where the motion comes to no orbit.
inline std::string verdict_on(const section::ResponseMode& label, const std::string& truth) {
  using section::ResponseKind;
  if (label.kind == ResponseKind::unresolved) return "unresolved";
  const bool is_aperiodic = label.kind == ResponseKind::chaotic || label.kind == ResponseKind::quasi_periodic;
  if ((is_aperiodic ? "none" : to_string(label)) == truth) return "right";
  return "wrong: " + to_string(label) + ", truth " + truth;
}

}  // namespace rocking::support
