#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "rocking/studies/cost/cost.hpp"
#include "rocking/studies/cost/measurement.hpp"
#include "support/excitation.hpp"

/// Invented results of a measurement of cost.
namespace rocking::support {

using section::ResponseMode;

inline constexpr ResponseMode one = section::periodic(1, 1);
inline constexpr ResponseMode three = section::periodic(1, 3);

inline Condition condition_of(bool random) {
  Condition condition;
  condition.tolerance = 1e-10;
  condition.realisations = 200;
  if (random) condition.scene.initial.tilt = Normal{.mean = 0.0, .sigma = 1.0};
  return condition;
}

/// An experiment with one condition for each entry of `random`, which says whether the condition is random.
inline Experiment experiment_of(const std::vector<bool>& random) {
  Experiment experiment;
  experiment.canonical_text = "{}";
  for (const bool is_random : random) experiment.conditions.push_back(condition_of(is_random));
  return experiment;
}

/// Three blocks that rock from a random tilt, with this horizon and number of realisations each.
inline Experiment shaken_experiment(Horizon horizon, std::uint64_t realisations) {
  Experiment experiment = experiment_of({true, true, true});
  experiment.seed = 0x2012;
  double amplitude = 3.0;
  for (Condition& condition : experiment.conditions) {
    support::harmonic(condition.scene).amplitude = amplitude += 0.7;
    support::harmonic(condition.scene).frequency_ratio = 10.0;
    condition.scene.initial.tilt = Uniform{.low = -0.4, .high = 0.4};
    condition.horizon = horizon;
    condition.realisations = realisations;
  }
  return experiment;
}

/// A realisation with these response modes at the tolerances, and these errors.
inline MeasuredRealisation realisation(const std::vector<ResponseMode>& modes, double error = 0.0,
                                       std::uint64_t condition = 0) {
  MeasuredRealisation measured{.key = {.condition = condition, .realisation = 0}, .runs = {}};
  for (const ResponseMode& mode : modes) {
    measured.runs.push_back({.mode = mode, .periods = 20, .steps = 100, .error = error, .diverged = false});
  }
  measured.runs.back().error.reset();
  return measured;
}

/// An invented curve: flips of `trials` and steps, by decreasing tolerance; the flips of the floor are among those of
/// all others.
inline std::vector<ToleranceCost> curve_of(const std::vector<std::uint64_t>& flips, std::uint64_t trials,
                                           const std::vector<std::uint64_t>& steps = {}) {
  std::vector<ToleranceCost> curve(flips.size() + 1);
  for (std::size_t i = 0; i < curve.size(); ++i) {
    curve[i].tolerance = std::vector{1e-6, 1e-8, 1e-10, 1e-12, 1e-14}[i];
    curve[i].periods = 1000;
    curve[i].steps = steps.empty() ? std::uint64_t{1000} << i : steps[i];
    if (i == flips.size()) break;
    Departure& departure = curve[i].departure.emplace();
    departure.median_error = 1e-7;
    departure.flips = {.successes = flips[i], .trials = trials};
    departure.flips_interval = stats::clopper_pearson(departure.flips, 0.95);
    if (i + 1 == flips.size()) continue;
    const std::uint64_t floor = std::min(flips[i], flips.back());
    departure.beside_tolerance_sensitivity = stats::PairedCounts{
        .both = floor, .first_only = flips[i] - floor, .second_only = 0, .neither = trials - flips[i]};
    departure.beyond_floor = stats::paired_difference_exact(*departure.beside_tolerance_sensitivity, 0.95);
  }
  return curve;
}

/// Times in proportion to the steps.
inline CostTiming timing_of(const std::vector<ToleranceCost>& curve) {
  CostTiming timing{.seconds_per_period = {}, .realisations = 384, .periods = 64};
  for (const ToleranceCost& cost : curve) {
    timing.seconds_per_period.push_back(1e-6 * static_cast<double>(cost.steps) / static_cast<double>(cost.periods));
  }
  return timing;
}

}  // namespace rocking::support
