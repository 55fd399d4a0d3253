#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rocking/stats/histogram.hpp"
#include "rocking/stats/moments.hpp"
#include "rocking/stats/normal_law.hpp"
#include "rocking/stats/normal_tails.hpp"
#include "rocking/stats/test_of_fit.hpp"

namespace rocking::stats {

/// The samples to be checked: one sample, and two samples of equal length that should be independent of each other.
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
  TestOfFit jarque_bera;
  TestOfFit dagostino_pearson;
  TestOfFit anderson_darling;
  TestOfFit kolmogorov_smirnov;
  std::array<TailCount, 3> tails;
  Histogram histogram;
};

/// Absent if all numbers are equal. Needs at least 20 numbers.
[[nodiscard]] std::optional<NormalCheck> check_normal(const NormalSamples& samples, const NormalLaw& law);

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
/// These are mean, standard deviation, Anderson-Darling, Kolmogorov-Smirnov and tails; from 1000 numbers on also the
/// correlations, except those of squares.
///
/// For a sample from the law the probability is below 2e-5: 14 p-values, where those of correlations are 1.2 times too
/// small at n = 1000.
[[nodiscard]] bool is_refuted(const NormalCheck& check);

}  // namespace rocking::stats
