// What a fragility curve states, and how often it is right: the lognormal function with its intervals and its test, the
// isotonic estimate, and the levels, in simulated experiments whose probabilities are known.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/stats/lack_of_fit.hpp"
#include "rocking/stats/normal_law.hpp"
#include "rocking/stats/probit.hpp"
#include "rocking/studies/fragility/fragility.hpp"
#include "support/false_alarms.hpp"
#include "support/split_mix.hpp"

namespace fragility {
namespace {

using namespace rocking;
using namespace rocking::stats;
using support::SplitMix;

/// Whether a realisation has one normal number for all levels (a capacity), one for each level, or half of both.
enum class Numbers : std::uint8_t { independent, common, half };

struct Truth {
  std::vector<double> intensities;
  std::vector<double> probabilities;
};

std::vector<IntensityLevel> experiment(const Truth& truth, std::size_t realisations, Numbers numbers,
                                       SplitMix& random) {
  std::vector<IntensityLevel> levels;
  std::vector<double> limits;  // of the normal number
  for (std::size_t i = 0; i < truth.intensities.size(); ++i) {
    levels.push_back({.intensity = truth.intensities[i], .happened = std::vector<bool>(realisations)});
  }
  for (std::size_t j = 0; j < realisations; ++j) {
    const double shared = random.normal();
    for (std::size_t i = 0; i < levels.size(); ++i) {
      double z = shared;
      if (numbers == Numbers::independent) z = random.normal();
      if (numbers == Numbers::half) z = std::sqrt(0.5) * (shared + random.normal());
      levels[i].happened[j] = normal_cdf(z) < truth.probabilities[i];
    }
  }
  return levels;
}

bool holds(const Interval& interval, double truth) { return interval.low <= truth && truth <= interval.high; }

std::string in_words(Numbers numbers) {
  switch (numbers) {
    case Numbers::independent: return "independent";
    case Numbers::common: return "common";
    case Numbers::half: break;
  }
  return "half common";
}

std::string per_cent(int count, int of) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "%.1f", of > 0 ? 100.0 * count / of : 0.0);
  return text.data();
}

void expect_in_documents(const std::string& row) {
  static const std::string document = [] {
    std::ifstream stream(ROCKING_SOURCE_DIR "/reports/evidence/intervals.md");
    return std::string{std::istreambuf_iterator<char>(stream), {}};
  }();
  EXPECT_NE(document.find(row), std::string::npos) << row;
}

/// How far a count lies below `share` of `of`, in standard deviations.
double shortfall(int count, int of, double share) {
  return (share * of - count) / std::sqrt(share * (1.0 - share) * of);
}

struct Lognormal {
  std::string name;
  std::vector<double> intensities;
  double median, dispersion;
  std::size_t realisations;
  Numbers numbers;
  double at_least;  ///< coverage that every interval has

  [[nodiscard]] double probability(double intensity) const {
    return normal_cdf(std::log(intensity / median) / dispersion);
  }
  [[nodiscard]] Truth truth() const {
    Truth truth{.intensities = intensities, .probabilities = {}};
    for (const double intensity : intensities) truth.probabilities.push_back(probability(intensity));
    return truth;
  }
};

std::vector<double> hundredths() {
  std::vector<double> intensities;
  for (int i = 0; i <= 20; ++i) intensities.push_back(1.0 + 0.01 * i);
  return intensities;
}

const std::vector<double> seven{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0};
const std::vector<double> low{1.0, 1.25, 1.5, 1.75, 2.0};

const std::vector<Lognormal>& lognormal_experiments() {
  using enum Numbers;
  static const std::vector<Lognormal> experiments{
      {"about the median", seven, 3.0, 0.4, 100, independent, 0.95},
      {"about the median", seven, 3.0, 0.4, 100, half, 0.95},
      {"about the median", seven, 3.0, 0.4, 100, common, 0.95},
      {"about the median", seven, 3.0, 0.4, 20, independent, 0.94},
      {"about the median", seven, 3.0, 0.4, 20, common, 0.91},
      {"hundredths", hundredths(), 1.1, 0.05, 12, common, 0.91},
      {"nearly sharp", hundredths(), 1.1, 0.004, 100, common, 0.94},
      {"rare", low, 4.0, 0.35, 1000, independent, 0.94},
      {"rare", low, 4.0, 0.35, 1000, common, 0.90},
      {"very rare", low, 4.0, 0.35, 200, common, 0.90},
  };
  return experiments;
}

constexpr int runs = 1000;

/// Intervals of a fit that contain the truth: median, dispersion, band at the first and at the last level.
using Holding = std::array<bool, 4>;

Holding holding(const LognormalFragility& law, const Lognormal& known) {
  const double first = known.intensities.front(), last = known.intensities.back();
  return {holds(law.median(0.95).interval, known.median), holds(law.dispersion(0.95).interval, known.dispersion),
          holds(law.band(first, 0.95), known.probability(first)), holds(law.band(last, 0.95), known.probability(last))};
}

struct Coverage {
  int fitted = 0;
  std::array<int, 4> covered{};
};

using Remake = std::function<LognormalFragility(const LognormalFragility&, const std::vector<IntensityLevel>&)>;

/// `remake`: what replaces the law before its intervals are looked at.
Coverage coverage(const Lognormal& known, const Remake& remake) {
  SplitMix random(2012);
  Coverage found;
  for (int run = 0; run < runs; ++run) {
    const auto levels = experiment(known.truth(), known.realisations, known.numbers, random);
    const auto law = fit_lognormal(levels).law;
    if (!law) continue;
    ++found.fitted;
    const Holding held = holding(remake(*law, levels), known);
    for (std::size_t i = 0; i < held.size(); ++i) found.covered[i] += held[i] ? 1 : 0;
  }
  return found;
}

TEST(FragilityIntervals, CoverTheTruthAsOftenAsTheDocumentsSay) {
  support::FalseAlarms alarms;
  for (const Lognormal& known : lognormal_experiments()) {
    const Coverage found = coverage(known, [](const LognormalFragility& law, const auto&) { return law; });
    std::string row = "| " + known.name + " | " + std::to_string(known.realisations) + " | " + in_words(known.numbers) +
                      " | " + per_cent(found.fitted, runs) + " |";
    for (const int count : found.covered) {
      EXPECT_LT(shortfall(count, found.fitted, known.at_least), alarms.score()) << row;
      row += ' ' + per_cent(count, found.fitted) + " |";
    }
    expect_in_documents(row);
  }
}

/// The covariance if every outcome were independent of every other, as most programs have it.
LognormalFragility as_if_independent(const LognormalFragility& law, const std::vector<IntensityLevel>& levels) {
  std::vector<ProbitCounts> counts;
  for (const IntensityLevel& level : levels) {
    const Proportion found = proportion_at(level);
    counts.push_back({.u = std::log(level.intensity) - law.centre,
                      .happened = static_cast<double>(found.successes),
                      .did_not = static_cast<double>(found.trials - found.successes)});
  }
  const SymmetricMatrix inverse = probit_likelihood(counts, law.intercept, law.slope).information.inverse();
  LognormalFragility other = law;
  other.covariance = {.aa = inverse.aa, .ab = inverse.ab, .bb = inverse.bb};
  return other;
}

TEST(FragilityIntervalsOfIndependentOutcomes, AreTooNarrowSoThisTestCanSee) {
  support::FalseAlarms alarms;
  const Lognormal& known = lognormal_experiments()[2];
  const Coverage found = coverage(known, as_if_independent);
  EXPECT_GT(shortfall(found.covered[0], found.fitted, known.at_least), alarms.score());
}

struct Tested {
  int fitted = 0;
  int rejected = 0;  ///< at 5 %
};

Tested tested(const Truth& truth, std::size_t realisations, Numbers numbers, int experiments) {
  SplitMix random(2012);
  Tested found;
  for (int run = 0; run < experiments; ++run) {
    const auto levels = experiment(truth, realisations, numbers, random);
    const auto law = fit_lognormal(levels).law;
    if (!law) continue;
    ++found.fitted;
    const LackOfFit test = lack_of_fit(levels, *law, 99, [&random](std::uint64_t, std::uint64_t) {
      const double which = random.uniform();
      return std::array{which, random.uniform()};
    });
    if (test.p_value <= 0.05) ++found.rejected;
  }
  return found;
}

TEST(FragilityTest, RejectsATrueLawAsOftenAsTheDocumentsSay) {
  support::FalseAlarms alarms;
  constexpr int experiments = 300;
  const auto size = [&](const Lognormal& known, double at_most) {
    const Tested found = tested(known.truth(), known.realisations, known.numbers, experiments);
    EXPECT_LT(shortfall(found.fitted - found.rejected, found.fitted, 1.0 - at_most), alarms.score()) << known.name;
    expect_in_documents("| " + known.name + " | " + std::to_string(known.realisations) + " | " +
                        in_words(known.numbers) + " | " + per_cent(found.rejected, found.fitted) + " |");
  };
  for (const std::size_t which : {0U, 1U, 2U, 3U, 4U, 6U}) size(lognormal_experiments()[which], 0.05);
}

/// Two capacities, 40 and 60 % of the realisations.
Truth two_capacities() {
  Truth truth{.intensities = seven, .probabilities = {}};
  for (const double intensity : seven) {
    truth.probabilities.push_back(0.4 * normal_cdf(std::log(intensity / 2.0) / 0.1) +
                                  0.6 * normal_cdf(std::log(intensity / 6.0) / 0.15));
  }
  return truth;
}

TEST(FragilityTest, RejectsTwoCapacitiesThatALognormalFunctionCannotDescribe) {
  support::FalseAlarms alarms;
  for (const Numbers numbers : {Numbers::independent, Numbers::common}) {
    const Tested found = tested(two_capacities(), 100, numbers, 200);
    EXPECT_LT(shortfall(found.rejected, found.fitted, 0.9), alarms.score());
  }
}

/// What whole curves state about a truth.
struct Stated {
  std::string name;
  Truth truth;
  std::size_t realisations;
  Numbers numbers;
};

std::vector<Stated> other_experiments() {
  using enum Numbers;
  Truth sharp{.intensities = hundredths(), .probabilities = std::vector<double>(21, 0.0)};
  std::fill(sharp.probabilities.begin() + 9, sharp.probabilities.end(), 1.0);
  Truth again = sharp;
  for (const std::size_t i : {4U, 5U, 10U, 13U}) again.probabilities[i] = 1.0 - sharp.probabilities[i];
  Truth nearly = again;
  for (double& p : nearly.probabilities) p = p > 0.5 ? 0.99 : 0.01;
  const Truth falls{.intensities = seven, .probabilities = {0.02, 0.3, 0.7, 0.4, 0.8, 0.6, 0.97}};
  return {{"sharp", sharp, 12, common},
          {"sharp, not monotone", again, 12, common},
          {"nearly sharp, not monotone", nearly, 12, half},
          {"nearly sharp, not monotone", nearly, 100, independent},
          {"not monotone", falls, 20, common},
          {"not monotone", falls, 100, common},
          {"two capacities", two_capacities(), 100, common},
          {"two capacities", two_capacities(), 100, independent}};
}

constexpr int curves_of_each = 100;

struct Statements {
  int laws = 0, isotonic = 0;
  int exact = 0, levels = 0;  ///< intervals of a level alone that cover, and all of them
  int simultaneous = 0;       ///< curves whose simultaneous intervals all cover: also the band of the isotonic estimate
};

void count(const FragilityCurve& curve, const Truth& truth, Statements& found) {
  bool all = true;
  for (std::size_t i = 0; i < curve.levels.size(); ++i) {
    const FragilityLevel& level = curve.levels[i];
    const double p = truth.probabilities[i];
    ++found.levels;
    found.exact += holds(level.exact, p) ? 1 : 0;
    all = all && holds(level.simultaneous, p);
  }
  found.laws += curve.law ? 1 : 0;
  found.isotonic += curve.levels.front().isotonic ? 1 : 0;
  found.simultaneous += all ? 1 : 0;
}

TEST(FragilityCurves, StateNothingFalseMoreOftenThanTheDocumentsSay) {
  support::FalseAlarms alarms;
  for (const Stated& known : other_experiments()) {
    SplitMix random(2012);
    Statements found;
    for (int run = 0; run < curves_of_each; ++run) {
      const auto levels = experiment(known.truth, known.realisations, known.numbers, random);
      count(fragility_curve(levels, 0.95, static_cast<std::uint64_t>(run)), known.truth, found);
    }
    const std::string row = "| " + known.name + " | " + std::to_string(known.realisations) + " | " +
                            in_words(known.numbers) + " | " + per_cent(found.laws, curves_of_each) + " | " +
                            per_cent(found.isotonic, curves_of_each) + " | " + per_cent(found.exact, found.levels) +
                            " | " + per_cent(found.simultaneous, curves_of_each) + " |";
    expect_in_documents(row);
    EXPECT_LT(shortfall(curves_of_each - found.laws, curves_of_each, 0.95), alarms.score()) << row;
    EXPECT_LT(shortfall(found.simultaneous, curves_of_each, 0.95), alarms.score()) << row;
  }
}

}  // namespace
}  // namespace fragility
