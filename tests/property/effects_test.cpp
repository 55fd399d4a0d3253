// Effects alone and combined. Every combination of fluctuations with every kind of base motion runs. An effect that a
// scene does not ask for is not computed: bits and counts stay the same.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/input/read_experiment.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "support/excitation.hpp"
#include "support/experiment_text.hpp"
#include "support/split_mix.hpp"

namespace rocking {
namespace {

using support::SplitMix;

enum class BaseMotion { harmonic, recorded, recorded_with_vertical, recorded_with_zero_vertical };

/// Ten seconds of strong excitation at three cycles per second, all cycles different, with occasional jumps.
std::string record_text(BaseMotion base) {
  SplitMix draw(7);
  std::string text;
  for (int i = 0; i <= 500; ++i) {
    const double horizontal = draw.uniform(12.0, 18.0) * std::sin(0.38 * i);
    const double vertical = base == BaseMotion::recorded_with_vertical ? draw.uniform(-2.0, 2.0) : 0.0;
    const int place = i % 50 == 49 ? i - 1 : i;
    text += std::to_string(0.02 * place) + " " + std::to_string(horizontal);
    text += base == BaseMotion::recorded ? "\n" : " " + std::to_string(vertical) + "\n";
  }
  return text;
}

/// The effects of a scene. Static and kinetic friction fluctuate only if there is friction, the amplitude only under
/// harmonic excitation; the reader refuses the rest.
struct Combination {
  BaseMotion base = BaseMotion::harmonic;
  bool friction = false;
  bool static_friction = false;
  bool kinetic_friction = false;
  bool restitution = false;
  bool amplitude = false;

  [[nodiscard]] bool is_random() const { return static_friction || kinetic_friction || restitution || amplitude; }

  [[nodiscard]] std::string name() const {
    std::string text = "base " + std::to_string(static_cast<int>(base));
    if (friction) text += ", friction";
    if (static_friction) text += ", mu_s";
    if (kinetic_friction) text += ", mu_k";
    if (restitution) text += ", e";
    if (amplitude) text += ", A_h";
    return text;
  }
};

std::vector<Combination> all_combinations() {
  std::vector<Combination> all;
  for (const BaseMotion base : {BaseMotion::harmonic, BaseMotion::recorded, BaseMotion::recorded_with_vertical}) {
    for (unsigned bits = 0; bits < 32; ++bits) {
      const Combination one{.base = base,
                            .friction = (bits & 1U) != 0,
                            .static_friction = (bits & 2U) != 0,
                            .kinetic_friction = (bits & 4U) != 0,
                            .restitution = (bits & 8U) != 0,
                            .amplitude = (bits & 16U) != 0};
      if (!one.friction && (one.static_friction || one.kinetic_friction)) continue;
      if (base != BaseMotion::harmonic && one.amplitude) continue;
      all.push_back(one);
    }
  }
  return all;
}

Json document_of(const Combination& combination) {
  Json document = support::least_experiment();
  document["horizon"] = {{"transient_periods", 10}, {"sampled_periods", 20}};
  document["excitation"] = {{"amplitude", 7.0}, {"frequency_ratio", 10.0}};
  if (combination.base != BaseMotion::harmonic) {
    document["excitation"] = {{"kind", "recorded"}, {"file", "pulses.txt"}, {"frequency_ratio", 10.0}};
    document["excitation"]["columns"] = {"time", "horizontal"};
    if (combination.base != BaseMotion::recorded) document["excitation"]["columns"].push_back("vertical");
  }
  if (combination.friction) document["friction"] = {{"static", 0.40}, {"kinetic", 0.35}};
  if (combination.static_friction) document["fluctuation"]["static_friction"] = {{"sigma", 0.03}};
  if (combination.kinetic_friction) document["fluctuation"]["kinetic_friction"] = {{"sigma", 0.03}};
  if (combination.restitution) document["fluctuation"]["restitution"] = {{"sigma", 0.05}};
  if (combination.amplitude) document["fluctuation"]["amplitude"] = {{"sigma", 0.2}};
  return document;
}

Condition condition_of(const Json& document, BaseMotion base) {
  const auto file = [base](const std::string&, std::size_t) { return record_text(base); };
  return experiment_in(document.dump(), {}, {.files = file}).conditions.at(0);
}

Condition condition_of(const Combination& combination) {
  return condition_of(document_of(combination), combination.base);
}

constexpr std::uint64_t seed = 0x2012;

std::uint64_t count_of(const OperationCounts& operations, dynamics::EventKind kind) {
  return operations.events[static_cast<std::size_t>(kind)];
}

TEST(EveryCombination, OfEffectsRunsToItsEnd) {
  EXPECT_EQ(all_combinations().size(), 40U);
  for (const Combination& combination : all_combinations()) {
    const testing::ScopedTrace trace(__FILE__, __LINE__, combination.name());
    const Condition condition = condition_of(combination);
    for (std::uint64_t realisation = 0; realisation < 4; ++realisation) {
      const RealisationResult result = realise(condition, seed, realisation);
      EXPECT_NE(result.termination, dynamics::Termination::painleve);
      EXPECT_NE(result.termination, dynamics::Termination::stopped);
      EXPECT_EQ(result.contradictions, 0U);
      EXPECT_EQ(result.strobe.size() == 30U, result.termination == dynamics::Termination::reached_horizon);
      for (const auto& point : result.strobe) {
        ASSERT_TRUE(std::isfinite(point.tilt) && std::isfinite(point.tilt_rate) && std::isfinite(point.slip_rate));
      }
    }
  }
}

TEST(EveryCombination, CountsWorkForTheEffectsThatItHasAndNoneForTheOthers) {
  for (const Combination& combination : all_combinations()) {
    const testing::ScopedTrace trace(__FILE__, __LINE__, combination.name());
    const RealisationResult result = realise(condition_of(combination), seed, 1);
    const OperationCounts& operations = result.operations;
    EXPECT_EQ(operations.static_friction_draws > 0, combination.static_friction);
    EXPECT_EQ(operations.kinetic_friction_draws > 0, combination.kinetic_friction);
    EXPECT_EQ(operations.restitution_draws > 0, combination.restitution);
    EXPECT_EQ(operations.amplitude_draws > 0, combination.amplitude);
    EXPECT_EQ(operations.initial_draws, 0U);
    EXPECT_EQ(operations.slip_steps > 0, combination.friction);
    EXPECT_EQ(count_of(operations, dynamics::EventKind::slip_start) > 0, combination.friction);
    EXPECT_EQ(operations.ground_motion_segments > 0, combination.base != BaseMotion::harmonic);
    EXPECT_TRUE(operations.exponent_periods == 0 || combination.base == BaseMotion::harmonic);
    EXPECT_GT(count_of(operations, dynamics::EventKind::impact_stick) +
                  count_of(operations, dynamics::EventKind::impact_slip),
              9U);
    const auto& clamps = result.clamps;
    EXPECT_TRUE(clamps.kinetic_at_static == 0 || combination.static_friction || combination.kinetic_friction);
    EXPECT_EQ(clamps.kinetic_at_zero + clamps.static_at_zero + clamps.restitution + clamps.amplitude_at_zero, 0U);
  }
}

/// Compares all bits of two realisations, and their classification.
void expect_same(const Condition& one, const Condition& other) {
  for (std::uint64_t realisation = 0; realisation < 2; ++realisation) {
    const RealisationResult a = realise(one, seed, realisation);
    const RealisationResult b = realise(other, seed, realisation);
    ASSERT_EQ(digest_of(a, 0), digest_of(b, 0));
    EXPECT_EQ(to_string(a.classification.mode), to_string(b.classification.mode));
    EXPECT_EQ(a.classification.reason, b.classification.reason);
    EXPECT_EQ(a.classification.margin, b.classification.margin);
    EXPECT_EQ(a.operations.steps, b.operations.steps);
    EXPECT_EQ(a.losses_of_contact, b.losses_of_contact);
    const Trajectory p = trajectory_of(one, seed, realisation, 30);
    const Trajectory q = trajectory_of(other, seed, realisation, 30);
    ASSERT_EQ(p.events.size(), q.events.size());
    for (std::size_t i = 0; i < p.events.size(); ++i) {
      ASSERT_EQ(p.events[i].kind, q.events[i].kind) << i;
      ASSERT_EQ(p.events[i].tau, q.events[i].tau) << i;
      ASSERT_EQ(p.events[i].tilt_rate, q.events[i].tilt_rate) << i;
      ASSERT_EQ(p.events[i].slip, q.events[i].slip) << i;
      ASSERT_EQ(p.events[i].slip_rate, q.events[i].slip_rate) << i;
    }
  }
}

TEST(EveryCombination, HasTheSameBitsWithASigmaOfZeroForWhatDoesNotFluctuate) {
  for (const Combination& combination : all_combinations()) {
    const testing::ScopedTrace trace(__FILE__, __LINE__, combination.name());
    Json document = document_of(combination);
    Json& fluctuation = document["fluctuation"];
    if (fluctuation.is_null()) fluctuation = Json::object();
    if (!fluctuation.contains("restitution")) fluctuation["restitution"] = {{"sigma", 0.0}};
    if (combination.base == BaseMotion::harmonic && !combination.amplitude) fluctuation["amplitude"] = {{"sigma", 0.0}};
    if (combination.friction && !combination.static_friction) fluctuation["static_friction"] = {{"sigma", 0.0}};
    if (combination.friction && !combination.kinetic_friction) {
      fluctuation["kinetic_friction"] = {{"relative_sigma", 0.0}, {"refreshes_per_period", 50}};
    }
    expect_same(condition_of(combination), condition_of(document, combination.base));
  }
}

// A friction of 5 is never exceeded on these bases, and kinetic friction is then never used.
TEST(EveryCombination, HasTheSameBitsWithFrictionThatNeverGivesWayAsWithNone) {
  for (const Combination& combination : all_combinations()) {
    if (!combination.friction) continue;
    const testing::ScopedTrace trace(__FILE__, __LINE__, combination.name());
    Json with = document_of(combination);
    with["friction"] = {{"static", 5.0}, {"kinetic", 1.0}};
    Json without = with;
    without.erase("friction");
    if (without.contains("fluctuation")) {
      without["fluctuation"].erase("static_friction");
      without["fluctuation"].erase("kinetic_friction");
    }
    const Condition condition = condition_of(with, combination.base);
    expect_same(condition, condition_of(without, combination.base));
    const OperationCounts operations = realise(condition, seed, 0).operations;
    EXPECT_EQ(operations.slip_steps, 0U);
    EXPECT_EQ(operations.kinetic_friction_draws, 0U);
    EXPECT_EQ(operations.static_friction_draws, combination.static_friction ? 1U : 0U) << "the value at the start";
  }
}

TEST(EveryCombination, HasTheSameBitsWithAVerticalMotionOfZeroAsWithNone) {
  for (Combination combination : all_combinations()) {
    if (combination.base != BaseMotion::recorded) continue;
    const testing::ScopedTrace trace(__FILE__, __LINE__, combination.name());
    const Condition without = condition_of(combination);
    combination.base = BaseMotion::recorded_with_zero_vertical;
    const Condition with = condition_of(combination);
    EXPECT_TRUE(support::recorded(with.scene).ground_motion->has_vertical);
    EXPECT_FALSE(support::recorded(without.scene).ground_motion->has_vertical);
    expect_same(without, with);
  }
}

TEST(EveryEffect, ChangesWhatTheBlockDoes) {
  for (const Combination& combination : all_combinations()) {
    if (!combination.is_random()) continue;
    const testing::ScopedTrace trace(__FILE__, __LINE__, combination.name());
    Combination still = combination;
    still.static_friction = still.kinetic_friction = still.restitution = still.amplitude = false;
    EXPECT_NE(digest_of(realise(condition_of(combination), seed, 1), 0),
              digest_of(realise(condition_of(still), seed, 1), 0));
  }
}

}  // namespace
}  // namespace rocking
