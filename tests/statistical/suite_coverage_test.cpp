// How often the intervals of a suite cover the truth, on the program itself: suites of closed form are run, and their
// law is fitted. Measured with all intervals: tests/evidence/suite_coverage.cpp.

#include <array>
#include <cmath>

#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>

#include "rocking/api/run.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/stats/fit_suite.hpp"
#include "rocking/studies/curves/hazard_integral.hpp"
#include "rocking/studies/fragility/fragility.hpp"
#include "support/constant_suite.hpp"
#include "support/false_alarms.hpp"
#include "support/made_up_suite.hpp"
#include "support/suite_by_shares.hpp"

namespace rocking {
namespace {

using stats::SuiteQuantity;
using support::ConstantSuite;
using support::SplitMix;

constexpr int suites = 150;

/// The probability of so many misses or more where `share` of the intervals cover.
double p_value(int misses, int of, double share) {
  const boost::math::binomial_distribution<double> law(of, 1.0 - share);
  return misses == 0 ? 1.0 : cdf(complement(law, misses - 1));
}

stats::SuiteLevels outcomes_of(const Experiment& experiment) {
  const RunResult run = rocking::run(experiment);
  return levels_of_records(stripes_of(experiment, store_of(run)).front().stripes, {});
}

/// Misses of the intervals of median and dispersion.
std::array<int, 2> misses_of_law(const ConstantSuite& suite) {
  const double dispersion = std::hypot(suite.between_records, suite.within_record);
  std::array<int, 2> misses{};
  for (int i = 0; i < suites; ++i) {
    SplitMix random(2026 + 7919 * static_cast<std::uint64_t>(i));
    const stats::SuiteLevels levels = outcomes_of(suite.drawn(random));
    const auto law = stats::fit_suite(levels).law;
    const auto has_missed = [&](SuiteQuantity quantity, double truth) {
      if (!law) return true;
      const stats::Interval interval = profile_interval(levels, *law, quantity, 0.95);
      return truth < interval.low || interval.high < truth;
    };
    misses[0] += has_missed(SuiteQuantity::median, suite.median) ? 1 : 0;
    misses[1] += has_missed(SuiteQuantity::dispersion, dispersion) ? 1 : 0;
  }
  return misses;
}

TEST(SuiteIntervals, CoverTheTruthInRunsOfTheProgram) {
  support::FalseAlarms alarms;
  const auto misses = misses_of_law({.between_records = 0.15});
  EXPECT_GT(p_value(misses[0], suites, 0.93), alarms.level()) << misses[0];
  EXPECT_GT(p_value(misses[1], suites, 0.93), alarms.level()) << misses[1];
}

// The program up to results version 3: the error of what is drawn once is common to all records.
TEST(SuiteIntervalsWithCommonNumbers, AreTooNarrowSoThisTestCanSee) {
  support::FalseAlarms alarms;
  const auto misses = misses_of_law({.between_records = 0.15, .has_common_numbers = true});
  EXPECT_LT(p_value(misses[0], suites, 0.93), alarms.level()) << misses[0];
  EXPECT_LT(p_value(misses[1], suites, 0.93), alarms.level()) << misses[1];
}

/// Misses of the interval of the rate by isotonic shares.
int misses_of_rate(const support::MadeUpSuite& suite) {
  const HazardCurve hazard{.name = "", .intensity = "", .header_line = 0, .points = {{0.05, 6.74e-2}, {2.0, 6.66e-6}}};
  constexpr double uplift = 0.05;
  const LognormalCapacity capacity{.centre = std::log(suite.median),
                                   .dispersion = std::hypot(suite.between_records, suite.within_record)};
  const double truth = rate_of(capacity, pieces_between(hazard, uplift));
  int misses = 0;
  for (int i = 0; i < suites; ++i) {
    SplitMix random(2026 + 7919 * static_cast<std::uint64_t>(i));
    const SuiteCurve curve = support::suite_by_shares(suite.drawn(random), uplift, static_cast<std::uint64_t>(i), 199);
    const stats::Interval interval = annual_rate(curve, hazard).chosen.interval.value();
    misses += truth < interval.low || interval.high < truth ? 1 : 0;
  }
  return misses;
}

TEST(RateByShares, IsCoveredWithMediansWithinAndAboveTheLevels) {
  support::FalseAlarms alarms;
  for (const double median : {0.42, 0.8, 1.5}) {
    for (const std::size_t records : {5U, 10U, 30U}) {
      const int misses = misses_of_rate({.records = records,
                                         .intensities = {0.25, 0.3, 0.35, 0.4, 0.5, 0.6, 0.8},
                                         .trials = 25,
                                         .median = median,
                                         .between_records = 0.5,
                                         .within_record = 0.1,
                                         .capacity = support::TrialCapacity::common});
      EXPECT_GT(p_value(misses, suites, 0.95), alarms.level()) << median << ' ' << records << ": " << misses;
    }
  }
}

}  // namespace
}  // namespace rocking
