// Answers to counts that a made-up simulator produced from known truths: how often the intervals contain the truth,
// what is said where nothing can be told, and whether the p-value of the fit is uniform. They depend neither on threads
// nor on interruptions.

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <vector>

#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>

#include "rocking/studies/infer/infer.hpp"
#include "support/false_alarms.hpp"
#include "support/made_up_campaign.hpp"
#include "support/split_mix.hpp"

namespace infer_coverage {
namespace {

using namespace rocking;
using support::Campaign;
using support::Dependence;
using support::SplitMix;

/// Probability that an event of probability `p` happens at most `count` times.
double at_most(std::size_t count, std::size_t trials, double p) {
  return boost::math::cdf(boost::math::binomial(static_cast<double>(trials), p), static_cast<double>(count));
}

double at_least(std::size_t count, std::size_t trials, double p) { return at_most(trials - count, trials, 1.0 - p); }

struct Answers {
  std::size_t covered = 0;  ///< intervals, of all unknowns
  std::size_t both = 0;     ///< intervals that reach both bounds
  std::vector<double> p_values = {};
};

Answers answers(const Campaign& campaign, std::size_t number, std::uint64_t seed) {
  SplitMix random(seed);
  Answers answers;
  for (std::size_t set = 0; set < number; ++set) {
    const Inference found = infer_unknowns(support::made_up_question(campaign, random), {});
    for (std::size_t k = 0; k < campaign.truth.size(); ++k) {
      const UnknownAnswer& unknown = found.answer.value().unknowns[k];
      answers.covered += unknown.interval.low <= campaign.truth[k] && campaign.truth[k] <= unknown.interval.high;
      answers.both += unknown.reaches == ReachedBound::both;
    }
    answers.p_values.push_back(found.answer.value().fit.p_value);
  }
  return answers;
}

constexpr std::size_t sets = 60;

const Answers& sharp_answers(double truth) {
  static std::map<double, Answers> known;
  const auto place = known.find(truth);
  if (place != known.end()) return place->second;
  return known[truth] = answers({.truth = {truth}, .dependence = Dependence::sharp}, sets, 1);
}

/// One of the truths lies on a bound.
constexpr std::array truths{0.0, 0.35, 0.8};

TEST(InferredIntervals, CoverTheTruthAsOftenAsTheySay) {
  support::FalseAlarms alarms;
  std::size_t all = 0;
  for (const double truth : truths) {
    const std::size_t covered = sharp_answers(truth).covered;
    all += covered;
    EXPECT_GT(at_most(covered, sets, 0.93), alarms.level()) << truth << ": " << covered << " of " << sets;
  }
  EXPECT_GT(at_most(all, truths.size() * sets, 0.93), alarms.level()) << all;
}

constexpr std::size_t sets_with_many_tests = 100;

const Answers& as_many_tests_as_realisations() {
  static const Answers found = answers(
      {.truth = {0.35}, .dependence = Dependence::sharp, .tests = 100, .realisations = 100}, sets_with_many_tests, 2);
  return found;
}

TEST(InferredIntervals, CoverTheTruthAlsoWhereTestsAreAsManyAsRealisations) {
  support::FalseAlarms alarms;
  const std::size_t covered = as_many_tests_as_realisations().covered;
  EXPECT_GT(at_most(covered, sets_with_many_tests, 0.93), alarms.level()) << covered;
}

// Where errors were taken larger than they are, to be safe for intervals, it was above 0.5 in 94 of 100 data sets.
TEST(InferredFit, HasAPValueThatIsNotMuchTooLargeWhereTestsAreAsManyAsRealisations) {
  support::FalseAlarms alarms;
  const auto& p_values = as_many_tests_as_realisations().p_values;
  const auto large = static_cast<std::size_t>(std::ranges::count_if(p_values, [](double p) { return p > 0.5; }));
  EXPECT_GT(at_least(large, sets_with_many_tests, 0.6), alarms.level()) << large;
}

TEST(InferredFit, HasAPValueThatIsAboutUniform) {
  support::FalseAlarms alarms;
  std::size_t small = 0;
  std::size_t large = 0;
  for (const double truth : truths) {
    for (const double p : sharp_answers(truth).p_values) {
      small += p <= 0.1;
      large += p > 0.5;
    }
  }
  const std::size_t all = truths.size() * sets;
  EXPECT_GT(at_least(small, all, 0.13), alarms.level()) << small;
  EXPECT_GT(at_most(small, all, 0.07), alarms.level()) << small;
  EXPECT_GT(at_most(large, all, 0.4), alarms.level()) << large;
  EXPECT_GT(at_least(large, all, 0.6), alarms.level()) << large;
}

InferenceSetting question(const Campaign& campaign, std::uint64_t seed) {
  SplitMix random(seed);
  return support::made_up_question(campaign, random);
}

TEST(InferredFit, IsBadWhereNoValueExplainsTheCounts) {
  InferenceSetting impossible = question({.truth = {0.35}, .dependence = Dependence::sharp}, 3);
  for (TestedCondition& condition : impossible.tests.conditions) condition.counts = {0, 0, 10};
  const Inference found = infer_unknowns(impossible, {});
  EXPECT_EQ(found.answer.value().fit.p_value, 0.001);
}

TEST(InferredFit, IsPerfectWhereTheCountsAreTheOnlyOnes) {
  for (std::uint64_t tests = 3; tests < 11; ++tests) {
    InferenceSetting certain = question({.truth = {0.35}}, 4);
    for (TestedCondition& condition : certain.tests.conditions) condition.counts = {tests, 0, 0};
    certain.simulate = [](const std::vector<std::vector<double>>& points) {
      return CountsAtPoints(points.size(), std::vector<std::vector<std::uint64_t>>(3, {400, 0, 0}));
    };
    const InferenceAnswer answer = infer_unknowns(certain, {}).answer.value();
    EXPECT_EQ(answer.fit.p_value, 1.0) << tests;
    EXPECT_EQ(answer.unknowns[0].reaches, ReachedBound::both);
  }
}

TEST(InferredIntervals, ReachBothBoundsWhereNothingCanBeTold) {
  const Answers found = answers({.truth = {0.35}, .dependence = Dependence::none}, 100, 5);
  EXPECT_GE(found.both, 95U);
}

TEST(InferredIntervals, DoNotReachBothBoundsWhereMuchCanBeTold) {
  for (const double truth : truths) EXPECT_EQ(sharp_answers(truth).both, 0U) << truth;
}

/// All numbers of an answer.
std::vector<double> numbers(const Inference& found) {
  std::vector<double> numbers;
  for (const infer::DesignPoint& point : found.design) numbers.insert(numbers.end(), point.at.begin(), point.at.end());
  const InferenceAnswer& answer = found.answer.value();
  for (const UnknownAnswer& unknown : answer.unknowns) {
    numbers.insert(numbers.end(), {unknown.estimate, unknown.interval.low, unknown.interval.high});
    if (unknown.posterior) numbers.insert(numbers.end(), {unknown.posterior->mean, unknown.posterior->median});
  }
  for (const infer::RegionPoint& point : answer.region) numbers.push_back(point.likelihood_ratio);
  for (const CandidateGain& gain : answer.candidates) numbers.push_back(gain.region);
  numbers.insert(numbers.end(), {answer.region_limit, answer.log_likelihood, answer.fit.statistic, answer.fit.p_value});
  return numbers;
}

InferenceSetting of_two_unknowns() {
  InferenceSetting two = question({.truth = {0.35, 0.6}}, 6);
  two.unknowns[1].prior = Normal{.mean = 0.5, .sigma = 0.2};
  two.tests.candidates.push_back(std::move(two.tests.conditions.back()));
  two.tests.conditions.pop_back();
  two.tests.candidates.back().counts.clear();
  return two;
}

TEST(InferredAnswer, HasTheSameBitsOverThreads) {
  const InferenceSetting two = of_two_unknowns();
  EXPECT_EQ(numbers(infer_unknowns(two, {}, {.threads = 1})), numbers(infer_unknowns(two, {}, {.threads = 3})));
}

TEST(InferredAnswer, IsTheSameAfterInterruptions) {
  InferenceSetting two = of_two_unknowns();
  const Inference whole = infer_unknowns(two, {});
  std::atomic<bool> stop = false;
  int calls = 0;
  const auto simulate = two.simulate;
  two.simulate = [&](const std::vector<std::vector<double>>& points) {
    if (++calls % 2 == 0) stop = true;
    return simulate(points);
  };
  Inference found;
  for (int part = 0; part < 100; ++part) {
    stop = false;
    const std::size_t before = found.design.size();
    found = infer_unknowns(two, {.earlier = found.design}, {.stop = base::StopRequest(&stop)});
    if (found.end == InferEnd::settled) break;
    EXPECT_EQ(found.end, InferEnd::stopped);
    EXPECT_GT(found.design.size(), before);
  }
  EXPECT_GT(calls, 4);
  EXPECT_EQ(numbers(found), numbers(whole));
}

TEST(InferredAnswer, IsTheSameAfterAnInterruptionWhileItIsWorkedOut) {
  const InferenceSetting two = of_two_unknowns();
  std::atomic<bool> stop = false;
  std::uint64_t made_up = 0;
  const Inference part = infer_unknowns(
      two, {}, {.threads = 2, .stop = base::StopRequest(&stop), .on_part = [&] { stop = ++made_up >= 20; }});
  EXPECT_EQ(part.end, InferEnd::stopped);
  EXPECT_FALSE(part.answer.has_value());
  EXPECT_LE(made_up, 21U) << "two threads";
  made_up = 0;
  const Inference whole = infer_unknowns(two, {.earlier = part.design}, {.on_part = [&] { ++made_up; }});
  EXPECT_EQ(made_up, made_up_sets(two));
  EXPECT_EQ(whole.design.size(), part.design.size());
  EXPECT_EQ(numbers(whole), numbers(infer_unknowns(two, {})));
}

TEST(InferredAnswer, StopsWhenTheTimeIsOver) {
  InferenceSetting one = question({.truth = {0.35}}, 7);
  double now = 0.0;
  const auto simulate = one.simulate;
  one.simulate = [&](const std::vector<std::vector<double>>& points) {
    now += 10.0;
    return simulate(points);
  };
  const auto found = infer_unknowns(one, {.seconds = 35.0, .elapsed_seconds = [&] { return now; }});
  EXPECT_EQ(found.end, InferEnd::out_of_time);
  EXPECT_EQ(found.design.size(), 16U);  // of 8, 4 and 4 points
  EXPECT_TRUE(found.answer.has_value());
}

}  // namespace
}  // namespace infer_coverage
