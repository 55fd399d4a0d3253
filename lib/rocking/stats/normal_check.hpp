#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rocking/stats/interval.hpp"
#include "rocking/stats/moments.hpp"
#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {

/// Counts of a sample in equal bins, with the counts expected under a normal law. Numbers outside the bins are counted
/// in `below` and `above`. Bin k is [edges[k], edges[k + 1]).
struct Histogram {
  std::vector<double> edges;  ///< bins + 1 of them, ascending
  std::vector<std::uint64_t> counts;
  std::vector<double> expected;  ///< n (F(upper edge) - F(lower edge))
  std::uint64_t below = 0;
  std::uint64_t above = 0;  ///< numbers >= the last edge
  double expected_below = 0.0;
  double expected_above = 0.0;
};

/// `bins` >= 1 equal bins from mean - reach sigma to mean + reach sigma; reach > 0.
[[nodiscard]] Histogram normal_histogram(std::span<const double> sample, const NormalLaw& law, std::size_t bins,
                                         double reach);

/// Number of values of a sample farther from the mean than `sigmas` standard deviations.
struct TailCount {
  double sigmas = 0.0;
  Proportion beyond;      ///< abs(x - mean) > sigmas sigma, out of all
  double expected = 0.0;  ///< n erfc(sigmas/sqrt 2)
  double p_value = 1.0;   ///< exact, two-sided
};

/// Counts beyond 3, 4 and 5 sigma. Faults of samplers appear there first, and tests of the whole law are least
/// sensitive there.
[[nodiscard]] std::array<TailCount, 3> normal_tails(std::span<const double> sample, const NormalLaw& law);

/// A test of fit: how far the sample is from the law, and how probable that or more is under the law.
struct TestOfFit {
  double statistic = 0.0;
  double p_value = 1.0;
};

/// The samples to be checked: one sample, and two samples of equal length that should be independent of it, or are empty.
struct NormalSamples {
  std::span<const double> sample;
  std::span<const double> of_next_realisation;
  std::span<const double> of_next_source;
};

/// A moment and its two-sided p-value under the law.
struct MomentTest {
  Moment moment;
  double p_value = 1.0;
};

/// Probability that the moment of a normal sample is this near to the value of the law.
struct Nearness {
  double distance = 0.0;     ///< largest abs(moment - value of the law)
  double probability = 0.0;  ///< probability of at most this distance
};

/// A shape parameter: skewness (0 for a normal law) or kurtosis (3).
struct ShapeTest {
  MomentTest test;
  /// For the distance 0.01, "no more than 0.01" in Jeong & Yang (2012), and for the observed distance.
  std::array<Nearness, 2> nearness;
  /// Value of a law that is not normal. Its moments are tested for large samples only.
  std::optional<double> of_law = std::nullopt;
};

struct CorrelationTest {
  std::string between;  ///< as in lib/docs/formats.md: `members_of_a_pair`, `lag_1`, `neighbouring_sources`, ...
  MomentTest test;
};

/// All checks of a sample that should consist of independent draws from N(mean, sigma^2).
struct NormalCheck {
  NormalLaw law;
  std::uint64_t n = 0;
  MomentTest mean;                ///< exact
  MomentTest standard_deviation;  ///< exact
  ShapeTest skewness;
  ShapeTest kurtosis;
  std::vector<CorrelationTest> correlations;  ///< with p-values that hold for large samples
  TestOfFit dagostino_pearson;
  TestOfFit anderson_darling;
  TestOfFit kolmogorov_smirnov;
  std::array<TailCount, 3> tails;
  Histogram histogram;
};

/// Absent if all numbers are equal. Needs at least 20 numbers.
[[nodiscard]] std::optional<NormalCheck> check_normal(const NormalSamples& samples, const NormalLaw& law);

/// The same against the normal law with the mean and the standard deviation of the sample, with the p-values of
/// Anderson-Darling and Kolmogorov-Smirnov for a law of the numbers themselves. Absent likewise, and if the standard
/// deviation is below 1e-70 or above 1e70.
[[nodiscard]] std::optional<NormalCheck> check_own_law(std::span<const double> sample);

/// All p-values, in the order of the members.
[[nodiscard]] std::vector<double> p_values_of(const NormalCheck& check);

/// The smallest of several p-values.
struct SmallestPValue {
  double value = 1.0;
  std::size_t tests = 0;     ///< number of p-values
  double probability = 1.0;  ///< that the smallest of as many independent uniform p-values is at most `value`
};

/// The smallest of p_values_of. Its probability is an approximation: the tests are not independent.
///
///     P(min <= p) = 1 - (1 - p)^tests
[[nodiscard]] SmallestPValue smallest_p_value(const NormalCheck& check);

/// Whether the sample is incompatible with the law: a p-value below 1e-6 among those that are accurate so far out.
/// These are mean and standard deviation of a normal law, Anderson-Darling, Kolmogorov-Smirnov and tails; from 1000
/// numbers on also the correlations, except those of squares.
///
/// For a sample from the law the probability is below 2e-5: 14 p-values, where those of correlations are 1.2 times too
/// small at n = 1000.
[[nodiscard]] bool is_refuted(const NormalCheck& check);

}  // namespace rocking::stats
