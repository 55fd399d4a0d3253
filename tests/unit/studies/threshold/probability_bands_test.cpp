// Bands of a probability that is known at every value.

#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/base/stop_request.hpp"
#include "rocking/studies/threshold/bands.hpp"
#include "rocking/studies/threshold/study.hpp"
#include "support/split_mix.hpp"

namespace rocking {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

double normal_law(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

/// Realisations with a probability that depends on the value. Those of one seed have the same draws at every value, as those
/// of a scene.
template <class Probability>
TrialsAt trials_of(Probability probability, std::uint64_t seed) {
  return [probability, seed](std::size_t place, double value) -> Trials {
    return [share = probability(value), first = 1'000'003 * (seed * 100 + place)](std::uint64_t realisation) {
      return support::SplitMix(first + realisation).uniform(0.0, 1.0) < share;
    };
  };
}

ThresholdQuestion question_for(double probability, double accuracy, std::uint64_t realisations = 20'000) {
  return {.of = "/excitation/amplitude",
          .from = 1.0,
          .to = 10.0,
          .probability = probability,
          .steps = 10,
          .accuracy = accuracy,
          .realisations = realisations};
}

/// P = Phi((x - 4)/0.5) up to 7.5, and 0 from there on.
double rises_and_falls(double x) { return x < 7.5 ? normal_law((x - 4.0) / 0.5) : 0.0; }

TEST(ProbabilityBands, CoverTheValueOfTheProbability) {
  constexpr int repetitions = 200;
  int missed = 0;
  for (std::uint64_t seed = 0; seed < repetitions; ++seed) {
    const ThresholdQuestion question = question_for(0.16, 0.05);
    const auto found = bands_by_probability(1, question, trials_of(rises_and_falls, seed), {}).front();
    ASSERT_THAT(found.edges, SizeIs(2));
    const ThresholdEdge& rises = found.edges[0];
    const ThresholdEdge& falls = found.edges[1];
    EXPECT_TRUE(rises.begins_band());
    EXPECT_FALSE(falls.begins_band());
    EXPECT_LE(rises.happens.value - rises.stands.value, 0.05 * rises.happens.value);
    const double right = 4.0 + 0.5 * -0.994457883;
    missed += rises.stands.value < right && right < rises.happens.value ? 0 : 1;
    EXPECT_TRUE(falls.happens.value < 7.5 && 7.5 <= falls.stands.value);
  }
  EXPECT_LE(missed, repetitions / 20);  // at most 5 %, and in fact fewer: the intervals of all values hold at once
}

TEST(ProbabilityBands, AreTheSameOnAnyNumberOfThreads) {
  const ThresholdQuestion question = question_for(0.5, 0.02);
  RunOptions threads;
  threads.threads = 5;
  const auto one = bands_by_probability(3, question, trials_of(rises_and_falls, 7), {});
  const auto five = bands_by_probability(3, question, trials_of(rises_and_falls, 7), threads);
  for (std::size_t place = 0; place < 3; ++place) {
    EXPECT_EQ(one[place].bands, five[place].bands);
    EXPECT_EQ(one[place].edges[0].happens.counts.trials, five[place].edges[0].happens.counts.trials);
  }
}

TEST(ProbabilityBands, AreWiderWithFewRealisations) {
  const auto width = [](std::uint64_t realisations) {
    const ThresholdQuestion question = question_for(0.5, 1e-3, realisations);
    const auto found = bands_by_probability(1, question, trials_of(rises_and_falls, 3), {}).front();
    EXPECT_LT(found.edges[0].stands.value, 4.0);
    EXPECT_GT(found.edges[0].happens.value, 4.0);
    return found.edges[0].happens.value - found.edges[0].stands.value;
  };
  EXPECT_GT(width(200), 3.0 * width(20'000));
}

TEST(ProbabilityBands, SayWhereTheProbabilityIsNotTold) {
  const ThresholdQuestion question = question_for(0.5, 0.02, 500);
  const auto flat = [](double x) { return x < 5.0 ? 0.5 : 1.0; };
  const auto found = bands_by_probability(1, question, trials_of(flat, 1), {}).front();
  EXPECT_THAT(found.edges, IsEmpty());
  EXPECT_THAT(found.without_answer, SizeIs(5)) << "1, 1.9, 2.8, 3.7 and 4.6";
  EXPECT_TRUE(found.begins_inside());
  const auto nowhere = bands_by_probability(1, question, trials_of([](double) { return 0.5; }, 1), {}).front();
  EXPECT_THAT(nowhere.bands, IsEmpty());
  EXPECT_THAT(nowhere.without_answer, SizeIs(11));
}

TEST(ProbabilityBands, AreToldAsIntervals) {
  const ThresholdQuestion question = question_for(0.5, 0.02);
  ThresholdStudy study{.question = question, .conditions = {{.parameters = {}, .found = {}}}};
  study.conditions[0].found = bands_by_probability(1, question, trials_of(rises_and_falls, 1), {}).front();
  const std::string text = threshold_table(study);
  EXPECT_THAT(text, HasSubstr("overturns with a probability above 50 % from [3.9"));
  EXPECT_THAT(text, HasSubstr("] on, not from [7.4"));
  study.conditions[0].found = {};
  EXPECT_THAT(threshold_table(study), HasSubstr("overturns with a probability above 50 % nowhere for amplitude"));
}

TEST(ProbabilityBands, CanBeStopped) {
  std::atomic<bool> stop{true};
  RunOptions options;
  options.stop_requested = &stop;
  EXPECT_THROW(
      static_cast<void>(bands_by_probability(1, question_for(0.5, 0.02), trials_of(rises_and_falls, 1), options)),
      base::Stopped);
}

}  // namespace
}  // namespace rocking
