// Probabilities of rare overturning: the same on any number of threads, cut off by time, and resumed.

#include "rocking/studies/rare/rare.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <variant>

#include <gtest/gtest.h>

#include "rocking/realisation/realisation_result.hpp"
#include "rocking/rocking.hpp"
#include "rocking/studies/rare/typical_paths.hpp"
#include "support/excitation.hpp"
#include "support/rare_scenes.hpp"

namespace {

using rocking::Condition;
using rocking::Experiment;
using rocking::rare_probabilities;
using rocking::RareEstimate;
using rocking::support::rare::drawn_once;
using rocking::support::rare::fluctuating;

constexpr std::uint64_t rare_seed = 0x2012;

Experiment experiment_of(const Condition& condition) {
  return {.title = "", .seed = rare_seed, .conditions = {condition}, .canonical_text = "{}"};
}

TEST(RareProbabilities, AreTheSameOnAnyNumberOfThreads) {
  const Experiment experiment = experiment_of(fluctuating());
  const auto on = [&](unsigned threads) {
    return rare_probabilities(experiment,
                              {.event = {rocking::EventName::tilt, 0.4}, .relative_error = 0.5, .particles = 20},
                              {.threads = threads})
        .front();
  };
  const RareEstimate one = on(1);
  const RareEstimate three = on(3);
  EXPECT_EQ(one.probability, three.probability);
  EXPECT_EQ(one.work, three.work);
}

// lib/docs/draws.md: what is drawn under a record of a suite follows its seed.
TEST(RareProbabilities, FollowTheSeedOfTheRecord) {
  const rocking::RareQuestion question{
      .event = {rocking::EventName::tilt, 0.4}, .relative_error = 0.5, .particles = 20};
  Experiment experiment = experiment_of(fluctuating());
  const RareEstimate plain = rare_probabilities(experiment, question).front();
  constexpr std::uint64_t stream = 0xfedcba9876543210;
  experiment.conditions.front().record_stream = stream;
  EXPECT_NE(rare_probabilities(experiment, question).front().probability, plain.probability);
  experiment.seed ^= stream;
  EXPECT_EQ(rare_probabilities(experiment, question).front().probability, plain.probability);
}

// The pilot runs of this seed give a grid that takes motions from rest for likely to overturn: of 1000 particles, none, one
// or two had descendants with the event, and the relative error asked for needed 1500 repetitions.
TEST(RareGrid, IsDrawnAnewWhereFewAncestorsHaveTheEvent) {
  const Experiment experiment = rocking::parse_experiment(
      R"({"format": "rocking.experiment/1", "block": {"width_m": 0.189, "height_m": 1.037},
          "excitation": {"kind": "harmonic", "amplitude": 6.6047, "frequency_ratio": 14.18},
          "fluctuation": {"amplitude": {"sigma": 0.7067029}},
          "horizon": {"transient_periods": 10, "sampled_periods": 30}, "realisations": 100, "seed": "0x2"})",
      "");
  const RareEstimate found = rare_probabilities(experiment, {.event = {}, .relative_error = 0.2}).front();
  EXPECT_GE(found.ancestors, 40U);
  EXPECT_EQ(found.diagnosis, rocking::RareDiagnosis::none);
  EXPECT_LE(found.repetitions.size(), 20U);
  EXPECT_LE(found.interval.low, 3.78e-7);
  EXPECT_GE(found.interval.high, 3.78e-7);
}

// It classifies nothing, so that strobe points at another phase each time do no harm.
TEST(RareProbabilities, AreEstimatedUnderAVerticalMotionOfAnyFrequency) {
  Condition condition = fluctuating();
  rocking::support::harmonic(condition.scene).vertical =
      rocking::VerticalHarmonic{.amplitude = 0.5, .frequency_ratio = 7.3};
  const RareEstimate found =
      rare_probabilities(experiment_of(condition),
                         {.event = {rocking::EventName::tilt, 0.4}, .relative_error = 0.5, .particles = 20})
          .front();
  EXPECT_GT(*found.probability, 0.0);
}

// A block that always reaches the tilt: 1, and no error.
TEST(RareProbabilities, AreOneWhereTheEventIsCertain) {
  const auto found =
      rare_probabilities(experiment_of(drawn_once()), {.event = {rocking::EventName::tilt, 0.0}, .particles = 20});
  EXPECT_EQ(found.front().probability, 1.0);
  EXPECT_EQ(found.front().interval.high, 1.0);
}

// Large weights are rare: fewer repetitions may be without one, and their spread too small.
TEST(RareProbabilities, HaveAtLeast64RepetitionsOfImportanceSamplingThatHasSeenTheEvent) {
  const rocking::RareQuestion question{
      .event = {rocking::EventName::tilt, 0.6}, .relative_error = 1.0, .particles = 20};
  for (const auto& [condition, least] : {std::pair{fluctuating(), 16U}, std::pair{drawn_once(), 64U}}) {
    const RareEstimate found = rare_probabilities(experiment_of(condition), question).front();
    EXPECT_GT(found.probability, 0.0);
    EXPECT_EQ(found.repetitions.size(), least);
    EXPECT_EQ(found.end, rocking::RareEnd::precise);
  }
}

double largest_tilt(const rocking::rare::Path& path) {
  double largest = 0.0;
  for (const auto& period : path.tilts) {
    for (const double tilt : period) largest = std::max(largest, std::abs(tilt));
  }
  return largest;
}

Condition weakly_shaken(Condition condition) {
  std::get<rocking::Harmonic>(condition.scene.excitation).amplitude = 2.5;
  return condition;
}

/// The draws of a path in the form in which a realisation takes them (lib/docs/draws.md).
rocking::random::DrawHistory draws_of(const rocking::rare::Path& path) {
  namespace random = rocking::random;
  random::DrawHistory draws;
  for (const auto& given : path.given) {
    const auto found = std::ranges::find(random::source_names, given.source);
    draws.given.push_back(
        {static_cast<random::Source>(found - random::source_names.begin() + 1), given.number, given.index});
  }
  for (const auto& branch : path.branches) {
    random::FirstUnused from{};
    std::ranges::copy(branch.from, from.begin());
    draws.branches.push_back({.number = branch.number, .from = from});
  }
  return draws;
}

// Their draws make them again, to the bit, and they have the event.
TEST(RarePaths, AreMadeAgainByTheirDraws) {
  for (const Condition& condition : {weakly_shaken(fluctuating()), weakly_shaken(drawn_once())}) {
    const Experiment experiment = experiment_of(condition);
    const rocking::ResponseEvent event{rocking::EventName::tilt, 0.8};
    const RareEstimate found =
        rare_probabilities(experiment, {.event = event, .relative_error = 0.9, .particles = 60}).front();
    EXPECT_LT(*found.probability, 0.05);
    EXPECT_GE(found.paths.size(), 3U);
    const rocking::rare::BlockPaths paths{.condition = &condition, .seed = rare_seed, .event = event, .halt = {}};
    for (const auto& path : found.paths) {
      const auto again = rocking::rare::path_of(paths, path.number, draws_of(path));
      EXPECT_EQ(again.tilts, path.tilts);
      EXPECT_GT(largest_tilt(path), 0.77);
    }
  }
}

// The committor of a good grid is near the probability: from rest, where the trajectories begin.
TEST(RareCommittor, IsNearTheProbabilityAtTheStart) {
  Condition condition = weakly_shaken(fluctuating());
  std::get<rocking::Harmonic>(condition.scene.excitation).amplitude = 1.5;
  condition.scene.friction.reset();
  condition.scene.fluctuation = {.amplitude = 0.4};
  const RareEstimate found =
      rare_probabilities(experiment_of(condition), {.event = {rocking::EventName::tilt, 0.8}, .particles = 100})
          .front();
  ASSERT_TRUE(found.committor);
  const double from_rest = found.committor->rows.at(30).at(30);
  EXPECT_LT(*found.probability, 0.1);
  EXPECT_GT(from_rest, *found.probability / 3.0);
  EXPECT_LT(from_rest, *found.probability * 3.0);
}

// Where many particles of the first pilot run have the event, a repetition is a share of realisations.
TEST(RarePlainSampling, IsChosenWhereTheEventIsFrequent) {
  const Condition condition = fluctuating();
  const RareEstimate found =
      rare_probabilities(experiment_of(condition),
                         {.event = {rocking::EventName::tilt, 0.5}, .relative_error = 0.5, .particles = 50})
          .front();
  EXPECT_EQ(found.method, rocking::RareMethod::plain_sampling);
  EXPECT_FALSE(found.committor);
  EXPECT_LT(found.pilot_work, 1001.0);
  for (const std::uint64_t repetition : {1U, 7U}) {
    int events = 0;
    for (std::uint64_t i = 0; i < 50; ++i) {
      const std::uint64_t number =
          rocking::rare::number_of({.repetition = repetition, .stage = 0, .particle = i, .move = 0});
      events += rocking::realise(condition, rare_seed, number).peaks.tilt > 0.5 ? 1 : 0;
    }
    EXPECT_EQ(found.repetitions.at(repetition - 1).estimate, events / 50.0);
  }
}

// A clock that advances at each look.
struct Looks {
  std::atomic<int> count{0};
  rocking::Execution on_threads(unsigned threads) {
    return {.threads = threads, .elapsed_seconds = [this] { return static_cast<double>(count++); }};
  }
};

TEST(RareTimeLimit, HoldsForAllConditionsTogetherAndKeepsWhatIsFinished) {
  Experiment experiment = experiment_of(fluctuating());
  experiment.conditions.assign(3, experiment.conditions.front());
  rocking::RareQuestion question{
      .event = {rocking::EventName::tilt, 0.4}, .relative_error = 0.05, .particles = 20, .seconds = 1e9};
  Looks unhurried;
  const auto all = rare_probabilities(experiment, question, unhurried.on_threads(1));
  for (const unsigned threads : {1U, 3U}) {
    for (const double share : {1e-9, 0.001, 0.01, 0.1, 0.3, 0.9}) {
      Looks looks;
      const double seconds = share * unhurried.count;
      question.seconds = seconds;
      const auto found = rare_probabilities(experiment, question, looks.on_threads(threads));
      // Each thread sees the end a few times in each condition.
      EXPECT_LE(looks.count, seconds + 1.0 + 4.0 * 3.0 * threads) << share;
      ASSERT_EQ(found.size(), 3U);
      // Several threads may look a tenth less often in all, and the paths take the last tenth.
      if (share < 0.9) {
        EXPECT_EQ(found.back().end, rocking::RareEnd::out_of_time) << share;
      }
      for (std::size_t i = 0; i < found.size(); ++i) {
        const auto& repetitions = found[i].repetitions;
        for (std::size_t k = 0; k < repetitions.size(); ++k) {
          EXPECT_EQ(repetitions[k].estimate, all[i].repetitions.at(k).estimate) << share << ", condition " << i;
        }
        EXPECT_EQ(found[i].probability.has_value(), !repetitions.empty()) << share;
        const bool is_whole = found[i].interval.low == 0.0 && found[i].interval.high == 1.0;
        EXPECT_EQ(is_whole, repetitions.size() < 8) << share << ", " << repetitions.size();
        EXPECT_EQ(found[i].diagnosis == rocking::RareDiagnosis::few_repetitions, repetitions.size() < 8) << share;
      }
    }
  }
}

TEST(RareProbabilities, GoOnFromEarlierRepetitions) {
  for (const Condition& condition : {fluctuating(), drawn_once()}) {
    const Experiment experiment = experiment_of(condition);
    const rocking::RareQuestion question{
        .event = {rocking::EventName::tilt, 0.6}, .relative_error = 0.05, .particles = 20};
    const RareEstimate all = rare_probabilities(experiment, question).front();
    rocking::RareQuestion more = question;
    more.earlier = {all};
    more.earlier.front().repetitions.resize(5);
    const RareEstimate resumed = rare_probabilities(experiment, more).front();
    EXPECT_EQ(resumed.probability, all.probability);
    EXPECT_EQ(resumed.repetitions.size(), all.repetitions.size());
    EXPECT_EQ(resumed.work, all.work);
  }
}

}  // namespace
