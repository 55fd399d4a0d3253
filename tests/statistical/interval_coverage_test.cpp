// Coverage of intervals, from the sum of the probabilities of all outcomes: no simulation, no false alarm.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>

#include "rocking/stats/interval.hpp"
#include "rocking/text/number_text.hpp"

namespace {

using namespace rocking::stats;
using IntervalMaker = Interval (*)(const Proportion&, double);

/// The sabotaged twin: the textbook interval estimate +- z sqrt(p (1 - p)/n), whose coverage is known to be too low.
Interval wald(const Proportion& proportion, double confidence) {
  EXPECT_EQ(confidence, 0.95);
  const auto n = static_cast<double>(proportion.trials);
  const double estimate = static_cast<double>(proportion.successes) / n;
  const double half_width = 1.959963984540054 * std::sqrt(estimate * (1.0 - estimate) / n);
  return {estimate - half_width, estimate + half_width};
}

/// Probability that the interval of a count covers the probability `p` behind it.
double coverage(const std::vector<Interval>& interval_of_count, double p) {
  const auto n = static_cast<double>(interval_of_count.size() - 1);
  const boost::math::binomial_distribution<double> law(n, p);
  double covered = 0.0;
  for (std::size_t k = 0; k < interval_of_count.size(); ++k) {
    const Interval& interval = interval_of_count[k];
    if (interval.low <= p && p <= interval.high) covered += pdf(law, static_cast<double>(k));
  }
  return covered;
}

std::vector<Interval> intervals_of_all_counts(IntervalMaker interval, std::uint64_t n, double confidence) {
  std::vector<Interval> all;
  for (std::uint64_t k = 0; k <= n; ++k) all.push_back(interval({k, n}, confidence));
  return all;
}

/// Smallest coverage over all p in (0, 1). Between two interval ends the same counts cover p and the coverage has no
/// minimum inside; therefore the smallest value is just beyond an end.
double least_coverage(IntervalMaker interval, std::uint64_t n, double confidence) {
  const std::vector<Interval> all = intervals_of_all_counts(interval, n, confidence);
  double least = 1.0;
  for (const Interval& ends : all) {
    for (const double p : {ends.low - 1e-9, ends.high + 1e-9}) {
      if (0.0 < p && p < 1.0) least = std::min(least, coverage(all, p));
    }
  }
  return least;
}

double mean_coverage(IntervalMaker interval, std::uint64_t n, double confidence) {
  const std::vector<Interval> all = intervals_of_all_counts(interval, n, confidence);
  constexpr int points = 2000;
  double sum = 0.0;
  for (int i = 0; i < points; ++i) sum += coverage(all, (i + 0.5) / points);
  return sum / points;
}

constexpr std::uint64_t sizes[] = {1, 2, 3, 5, 10, 30, 100, 200};

TEST(ClopperPearson, CoversTheTruthAtLeastAsOftenAsItPromises) {
  for (const std::uint64_t n : sizes) {
    for (const double confidence : {0.5, 0.95, 0.999}) {
      // Stepping 1e-9 beyond the end changes a coverage by no more than 1e-9 n.
      EXPECT_GE(least_coverage(&clopper_pearson, n, confidence), confidence - 1e-9 * static_cast<double>(n)) << n;
    }
  }
}

TEST(ClopperPearson, IsNoWiderThanItsPromiseNeeds) { EXPECT_LT(least_coverage(&clopper_pearson, 200, 0.95), 0.96); }

TEST(Wilson, CoversTheTruthAboutAsOftenAsItPromisesOnTheAverage) {
  for (const std::uint64_t n : {5U, 10U, 30U, 100U, 200U}) {
    EXPECT_NEAR(mean_coverage(&wilson, n, 0.95), 0.95, 0.01) << n;
  }
}

TEST(Wald, BreaksThePromiseSoThisTestCanSee) {
  for (const std::uint64_t n : sizes) {
    EXPECT_LT(least_coverage(&wald, n, 0.95), 0.5) << n;
    EXPECT_LT(mean_coverage(&wald, n, 0.95), 0.95) << n;
  }
}

Interval of_others(const Proportion& proportion, double confidence) {
  return exact_interval(proportion, Family{.prespecified = 6, .confidence = confidence}.of_others());
}

TEST(ExactInterval, MissesNoMoreOftenThanItsSignificanceLevel) {
  for (const std::uint64_t n : sizes) {
    const std::vector<Interval> all = intervals_of_all_counts(&of_others, n, 0.5);
    const Significance significance = Family{.prespecified = 6, .confidence = 0.5}.of_others();
    for (int i = 1; i < 4000; ++i) {
      const double p = i < 1000 ? std::pow(10.0, -0.006 * i) : (i - 1000) / 3000.0 + 1e-4;
      EXPECT_LE(1.0 - coverage(all, p), significance.at(p) + 1e-14) << n << " at " << p;  // the sums' rounding
    }
  }
}

// The former rule: one share for each category that was seen. If there are very many very rare categories, one of them
// is seen more often than not, and its interval begins above its probability.
TEST(SharesByWhatWasSeen, BreakThePromise) {
  constexpr double rare = 5e-6;
  constexpr std::uint64_t n = 200;
  const Interval of_one_seen = bonferroni_clopper_pearson({1, n}, 0.95, 5);
  EXPECT_GT(of_one_seen.low, rare);
  const double none_of_a_thousand = std::pow(1.0 - 1000.0 * rare, static_cast<double>(n));
  EXPECT_LT(none_of_a_thousand, 0.37);  // no more than this is their coverage
  EXPECT_LT(of_others({1, n}, 0.95).low, rare);
}

using Counts = std::array<std::uint64_t, 3>;
using Truth = std::array<double, 3>;
using Intervals = std::array<Interval, 3>;
using SimultaneousMaker = Intervals (*)(const Counts&, double);

std::uint64_t total(const Counts& counts) { return counts[0] + counts[1] + counts[2]; }

template <std::size_t categories>
Intervals bonferroni(const Counts& counts, double confidence) {
  Intervals intervals;
  for (std::size_t i = 0; i < 3; ++i) {
    intervals[i] = bonferroni_clopper_pearson({counts[i], total(counts)}, confidence, categories);
  }
  return intervals;
}

/// The first category prespecified, the others not.
Intervals one_prespecified(const Counts& counts, double confidence) {
  const Family family{.prespecified = 1, .confidence = confidence};
  const std::uint64_t n = total(counts);
  return {exact_interval({counts[0], n}, family.of_prespecified()), exact_interval({counts[1], n}, family.of_others()),
          exact_interval({counts[2], n}, family.of_others())};
}

/// All outcomes of n draws in three categories, each with its intervals and the number of orders that lead to it.
struct Outcome {
  Counts counts;
  Intervals intervals;
  double orders;
};

std::vector<Outcome> all_outcomes(SimultaneousMaker maker, std::uint64_t n, double confidence) {
  std::vector<Outcome> outcomes;
  const auto factorial = [](std::uint64_t k) { return std::tgamma(static_cast<double>(k) + 1.0); };
  for (std::uint64_t a = 0; a <= n; ++a) {
    for (std::uint64_t b = 0; a + b <= n; ++b) {
      const Counts counts{a, b, n - a - b};
      const double orders = factorial(n) / (factorial(a) * factorial(b) * factorial(n - a - b));
      outcomes.push_back({counts, maker(counts, confidence), orders});
    }
  }
  return outcomes;
}

/// Probability that the intervals of all three categories cover at once.
double joint_coverage(const std::vector<Outcome>& outcomes, const Truth& truth) {
  double covered = 0.0;
  for (const auto& [counts, intervals, orders] : outcomes) {
    double probability = orders;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool covers = intervals[i].low <= truth[i] && truth[i] <= intervals[i].high;
      probability *= covers ? std::pow(truth[i], static_cast<double>(counts[i])) : 0.0;
    }
    covered += probability;
  }
  return covered;
}

struct Coverage {
  double least = 1.0;
  double mean = 0.0;
};

/// Over a grid of true probabilities with a spacing of 1/60.
Coverage joint_coverage(SimultaneousMaker maker, std::uint64_t n, double confidence) {
  const std::vector<Outcome> outcomes = all_outcomes(maker, n, confidence);
  Coverage found;
  int points = 0;
  for (int i = 1; i < 60; ++i) {
    for (int j = 1; i + j < 60; ++j, ++points) {
      const double covered = joint_coverage(outcomes, {i / 60.0, j / 60.0, (60 - i - j) / 60.0});
      found.least = std::min(found.least, covered);
      found.mean += covered;
    }
  }
  found.mean /= points;
  return found;
}

// At level 0.6 three intervals can fail to cover at once as often as one of them promises.
TEST(BonferroniClopperPearson, CoversAllTruthsAtOnceAsOftenAsItPromises) {
  EXPECT_GE(joint_coverage(&bonferroni<3>, 10, 0.6).least, 0.6);
  EXPECT_GE(joint_coverage(&bonferroni<3>, 30, 0.95).least, 0.95);
}

TEST(BonferroniClopperPearson, NeedsItsCorrection) { EXPECT_LT(joint_coverage(&bonferroni<1>, 10, 0.6).least, 0.6); }

TEST(Family, CoversAllTruthsAtOnceAlsoOfCategoriesThatWereNotPrespecified) {
  EXPECT_GE(joint_coverage(&one_prespecified, 10, 0.6).least, 0.6);
  EXPECT_GE(joint_coverage(&one_prespecified, 30, 0.95).least, 0.95);
}

std::string per_cent(double probability) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.2f", 100.0 * probability);
  return text.data();
}

/// The rows of the tables in reports/evidence/intervals.md; the first table is for one mode, the second for three at once.
std::vector<std::string> rows_of_documents() {
  std::vector<std::string> rows;
  const auto add = [&rows](const char* name, std::uint64_t n, std::initializer_list<double> values) {
    std::string row = "| " + std::to_string(n) + " | " + name + " |";
    for (const double value : values) row += ' ' + per_cent(value) + " |";
    rows.push_back(row);
  };
  for (const std::uint64_t n : {10U, 50U, 200U, 1000U}) {
    for (const auto& [name, maker] : {std::pair<const char*, IntervalMaker>{"Wald", &wald},
                                      {"Wilson", &wilson},
                                      {"Clopper-Pearson", &clopper_pearson}}) {
      const double at_a_thousandth = coverage(intervals_of_all_counts(maker, n, 0.95), 0.001);
      add(name, n, {least_coverage(maker, n, 0.95), mean_coverage(maker, n, 0.95), at_a_thousandth});
    }
  }
  for (const std::uint64_t n : {10U, 30U}) {
    for (const auto& [name, maker] :
         {std::pair<const char*, SimultaneousMaker>{"Bonferroni, three shares", &bonferroni<3>},
          {"Bonferroni, one prespecified", &one_prespecified}}) {
      const Coverage found = joint_coverage(maker, n, 0.95);
      add(name, n, {found.least, found.mean});
    }
  }
  return rows;
}

TEST(CoverageTable, InTheDocumentsIsWhatComesOut) {
  std::ifstream stream(ROCKING_SOURCE_DIR "/reports/evidence/intervals.md");
  const std::string document{std::istreambuf_iterator<char>(stream), {}};
  for (const std::string& row : rows_of_documents()) EXPECT_NE(document.find(row), std::string::npos) << row;
}

}  // namespace
