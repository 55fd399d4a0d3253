#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rocking/stats/histogram.hpp"
#include "rocking/stats/moments.hpp"
#include "rocking/stats/normal_law.hpp"
#include "rocking/stats/normal_tails.hpp"
#include "rocking/stats/normality.hpp"

namespace rocking::stats {

/// What is examined: a sample, and two of equal length that must have nothing to do with it.
struct NormalSamples {
  std::span<const double> sample;
  std::span<const double> of_next_realisation;
  std::span<const double> of_next_source;
};

/// A moment and the probability of one at least as far out, on either side, under the law.
struct MomentTest {
  Moment moment;
  double p_value = 1.0;
};

/// How often a true normal sample has a moment this near to the law's value.
struct Nearness {
  double distance = 0.0;     ///< abs(moment - value of the law) at most so large
  double probability = 0.0;  ///< has this probability
};

/// A shape parameter: skewness (0 for a normal law) or kurtosis (3).
struct ShapeTest {
  MomentTest test;
  Nearness near;      ///< of 0.01, Jeong & Yang's (2012) "no more than 0.01"
  Nearness observed;  ///< of what was found
};

struct CorrelationTest {
  std::string between;  ///< as in lib/docs/formats.md: `members_of_a_pair`, `lag_1`, `neighbouring_sources`, ...
  MomentTest test;
};

/// Everything that is looked at in a sample that should come from N(mean, sigma^2), independently.
struct NormalCheck {
  NormalLaw law;
  std::uint64_t n = 0;
  MomentTest mean;                ///< exact
  MomentTest standard_deviation;  ///< exact
  ShapeTest skewness;
  ShapeTest kurtosis;
  std::vector<CorrelationTest> correlations;  ///< p-values of large samples
  TestOfFit jarque_bera;
  TestOfFit dagostino_pearson;
  TestOfFit anderson_darling;
  TestOfFit kolmogorov_smirnov;
  std::array<TailCount, 3> tails;
  Histogram histogram;
};

/// Absent where the numbers are all alike. Needs 20 of them or more.
[[nodiscard]] std::optional<NormalCheck> check_normal(const NormalSamples& samples, const NormalLaw& law);

/// All p-values, in the order of the members.
[[nodiscard]] std::vector<double> p_values_of(const NormalCheck& check);

/// Whether the sample is so far from the law that no chance explains it: a p-value below 1e-6 among those that are good
/// so far out (mean, standard deviation, Anderson-Darling, Kolmogorov-Smirnov, tails; from a thousand numbers on also
/// the correlations, but not of squares).
///
/// True of a true normal sample with probability below 2e-5: 14 p-values, those of correlations 1.2 times too small at
/// n = 1000.
[[nodiscard]] bool is_refuted(const NormalCheck& check);

}  // namespace rocking::stats
