// Tests and intervals for paired trials, from the sum of the probabilities of all outcomes: without simulation there is
// no false alarm.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/stats/paired.hpp"
#include "rocking/text/number_text.hpp"

namespace paired {
namespace {

using namespace rocking::stats;
using IntervalMaker = Interval (*)(const PairedCounts&, double);

/// The sabotaged twin: the textbook interval difference +- z standard errors.
Interval wald(const PairedCounts& counts, double confidence) {
  EXPECT_EQ(confidence, 0.95);
  const double deviation = std::sqrt(variance_reduction(counts).paired / static_cast<double>(counts.trials()));
  const double difference = paired_difference(counts);
  return {difference - 1.959963984540054 * deviation, difference + 1.959963984540054 * deviation};
}

/// The relevant part of an outcome: b and c of n, the number of orders that lead to them, and a value computed from
/// them.
template <class Value>
struct Outcome {
  double b;
  double c;
  double rest;
  double log_orders;
  Value value;
};

template <class Maker>
auto all_outcomes(std::uint64_t n, Maker maker) {
  std::vector<Outcome<decltype(maker(PairedCounts{}))>> outcomes;
  for (std::uint64_t b = 0; b <= n; ++b) {
    for (std::uint64_t c = 0; b + c <= n; ++c) {
      const std::array parts{static_cast<double>(b), static_cast<double>(c), static_cast<double>(n - b - c)};
      double log_orders = std::lgamma(static_cast<double>(n) + 1.0);
      for (const double part : parts) log_orders -= std::lgamma(part + 1.0);
      const PairedCounts counts{.both = 0, .first_only = b, .second_only = c, .neither = n - b - c};
      outcomes.push_back({parts[0], parts[1], parts[2], log_orders, maker(counts)});
    }
  }
  return outcomes;
}

/// Probability of the outcomes for which `counts` holds, if a trial falls on the first side only with probability p and
/// on the second only with probability q. Powers of 0 are 1 for exponent 0.
template <class Outcomes, class Predicate>
double probability(const Outcomes& outcomes, double p, double q, Predicate counts) {
  const double log_p = std::log(p), log_q = std::log(q), log_rest = std::log(1.0 - p - q);
  double sum = 0.0;
  for (const auto& outcome : outcomes) {
    if (!counts(outcome.value)) continue;
    sum += std::exp(outcome.log_orders + outcome.b * log_p + outcome.c * log_q + outcome.rest * log_rest);
  }
  return sum;
}

/// Calls the function for p and q on a grid of sixtieths, and for some small values.
template <class Function>
void for_all_probabilities(Function function) {
  for (int i = 1; i < 60; ++i) {
    for (int j = 1; i + j < 60; ++j) function(i / 60.0, j / 60.0);
  }
  for (const double p : {1e-4, 1e-3, 0.01}) {
    for (const double q : {1e-4, 1e-3, 0.01}) function(p, q);
  }
}

struct Coverage {
  double least = 1.0;
  double mean = 0.0;
};

Coverage coverage(IntervalMaker maker, std::uint64_t n) {
  const auto outcomes = all_outcomes(n, [&](const PairedCounts& counts) { return maker(counts, 0.95); });
  Coverage found;
  int points = 0;
  for_all_probabilities([&](double p, double q) {
    const double d = p - q;
    const auto covers = [d](const Interval& interval) { return interval.low <= d && d <= interval.high; };
    const double covered = probability(outcomes, p, q, covers);
    found.least = std::min(found.least, covered);
    found.mean += covered;
    ++points;
  });
  found.mean /= points;
  return found;
}

TEST(PairedDifferenceExact, CoversTheTruthAtLeastAsOftenAsItPromises) {
  for (const std::uint64_t n : {1U, 2U, 5U, 10U, 30U})
    EXPECT_GE(coverage(&paired_difference_exact, n).least, 0.95) << n;
}

TEST(PairedDifferenceScore, CoversTheTruthAboutAsOftenAsItPromisesOnTheAverage) {
  EXPECT_NEAR(coverage(&paired_difference_score, 10).mean, 0.95, 0.02);
  EXPECT_NEAR(coverage(&paired_difference_score, 30).mean, 0.95, 0.01);
  EXPECT_GT(coverage(&paired_difference_score, 30).least, 0.93);
}

TEST(PairedWald, BreaksThePromiseSoThisTestCanSee) {
  EXPECT_LT(coverage(&wald, 30).least, 0.05);
  EXPECT_LT(coverage(&wald, 10).mean, 0.94);
}

/// Largest frequency with which McNemar's test rejects at 5 % although both settings are equal.
double largest_error(std::uint64_t n, double McNemar::*p_value) {
  const auto outcomes = all_outcomes(n, [&](const PairedCounts& counts) { return mcnemar(counts).*p_value; });
  double largest = 0.0;
  for (int i = 1; i < 200; ++i) {
    const double p = 0.5 * i / 200.0;
    largest = std::max(largest, probability(outcomes, p, p, [](double found) { return found <= 0.05; }));
  }
  return largest;
}

TEST(McNemar, RejectsNoMoreOftenThanItsLevelAllows) {
  for (const std::uint64_t n : {5U, 10U, 30U, 60U}) EXPECT_LE(largest_error(n, &McNemar::p_value), 0.05) << n;
}

TEST(McNemarMidP, ExceedsItsLevelByLittle) {
  for (const std::uint64_t n : {10U, 30U, 60U}) {
    EXPECT_LE(largest_error(n, &McNemar::mid_p), 0.055) << n;
    EXPECT_GT(largest_error(n, &McNemar::mid_p), largest_error(n, &McNemar::p_value)) << n;
  }
}

std::string per_cent(double probability) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.2f", 100.0 * probability);
  return text.data();
}

TEST(PairedCoverageTable, InTheDocumentsIsWhatComesOut) {
  std::ifstream stream(ROCKING_SOURCE_DIR "/reports/evidence/intervals.md");
  const std::string document{std::istreambuf_iterator<char>(stream), {}};
  for (const std::uint64_t n : {10U, 30U, 100U}) {
    for (const auto& [name, maker] : {std::pair<const char*, IntervalMaker>{"Wald, paired", &wald},
                                      {"Tango", &paired_difference_score},
                                      {"exact, paired", &paired_difference_exact}}) {
      const auto [least, mean] = coverage(maker, n);
      const std::string row =
          "| " + std::to_string(n) + " | " + name + " | " + per_cent(least) + " | " + per_cent(mean) + " |";
      EXPECT_NE(document.find(row), std::string::npos) << row;
    }
  }
}

}  // namespace
}  // namespace paired
