// A surface over two measures: known coefficients, and tests of its terms.

#include <cmath>

#include <boost/math/distributions/binomial.hpp>
#include <gtest/gtest.h>

#include "rocking/stats/normal_law.hpp"
#include "rocking/stats/probit_surface.hpp"
#include "support/false_alarms.hpp"
#include "support/split_mix.hpp"

namespace rocking {
namespace {

using stats::ProbitSurface;
using stats::SurfaceCoefficients;
using stats::SurfaceCounts;
using support::SplitMix;

/// Records with a v of their own at five levels of u. Beside both, a number of the record decides: trials under a record are
/// not independent. Over all records the probability is that of the coefficients.
struct MadeUpSurface {
  std::size_t records = 40;
  SurfaceCoefficients truth{};
  double of_record = 0.5;
  int trials = 20;

  [[nodiscard]] std::vector<SurfaceCounts> drawn(SplitMix& random) const {
    std::vector<SurfaceCounts> counts;
    for (std::size_t record = 0; record < records; ++record) {
      const double v = 0.5 * random.normal(), own = of_record * random.normal();
      for (const double u : {-0.7, -0.35, 0.0, 0.35, 0.7}) {
        const double probit = std::hypot(1.0, of_record) * stats::surface_probit(truth, u, v) + own;
        const double probability = stats::normal_cdf(probit);
        SurfaceCounts& point = counts.emplace_back(SurfaceCounts{.u = u, .v = v, .record = record});
        for (int j = 0; j < trials; ++j) ++(random.uniform() < probability ? point.happened : point.did_not);
      }
    }
    return counts;
  }
};

ProbitSurface fitted(const MadeUpSurface& made, std::uint64_t first, std::size_t samples = 199) {
  SplitMix random(first);
  const std::vector<SurfaceCounts> counts = made.drawn(random);
  std::vector<std::vector<double>> weights(samples, std::vector<double>(made.records, 0.0));
  for (auto& sample : weights) {
    for (std::size_t i = 0; i < made.records; ++i) {
      ++sample[static_cast<std::size_t>(random.uniform() * static_cast<double>(made.records))];
    }
  }
  return stats::probit_surface(counts, weights).value();
}

TEST(SurfaceFit, FindsTheCoefficientsOfALargeSuite) {
  support::FalseAlarms alarms;
  const MadeUpSurface made{.records = 400, .truth = {0.2, 2.0, 1.0, 2.0}};
  const ProbitSurface found = fitted(made, 1);
  ASSERT_TRUE(found.has_interaction);
  EXPECT_EQ(found.interaction->as_large, 0U);
  EXPECT_EQ(found.second.as_large, 0U);
  for (std::size_t i = 0; i < 4; ++i) {
    double mean = 0.0, squares = 0.0;
    const auto& samples = found.samples;
    for (const SurfaceCoefficients& sample : samples) mean += sample[i] / static_cast<double>(samples.size());
    for (const SurfaceCoefficients& sample : samples) squares += (sample[i] - mean) * (sample[i] - mean);
    const double error = std::sqrt(squares / static_cast<double>(samples.size() - 1));
    EXPECT_LT(error, 0.2) << i;
    EXPECT_LT(std::abs(found.coefficients[i] - made.truth[i]), alarms.score() * error) << i;
  }
}

/// Suites whose p-value is at most 5 %, and at most 50 %.
struct Small {
  int of_twentieth = 0, of_half = 0;
  void add(double p) {
    of_twentieth += p <= 0.05 ? 1 : 0;
    of_half += p <= 0.5 ? 1 : 0;
  }
};

// The record decides beside both measures: if the trials counted as independent, most p-values would be small.
TEST(SurfaceTests, HavePValuesThatAreAboutUniformWhereThereIsNothing) {
  support::FalseAlarms alarms;
  constexpr int made_up = 400;
  Small second, interaction;
  for (int i = 0; i < made_up; ++i) {
    const auto first = 2026 + 7919 * static_cast<std::uint64_t>(i);
    second.add(fitted({.truth = {0.2, 2.0, 0.0, 0.0}}, first, 99).second.p_value.value());
    interaction.add(fitted({.truth = {0.2, 2.0, 1.0, 0.0}}, first + 1, 99).interaction->p_value.value());
  }
  const auto at_most = [](int count, double share) {
    const boost::math::binomial_distribution<double> law(made_up, share);
    return count == 0 ? 1.0 : cdf(complement(law, count - 1));
  };
  const auto at_least = [](int count, double share) {
    return cdf(boost::math::binomial_distribution<double>(made_up, share), count);
  };
  for (const Small& found : {second, interaction}) {
    EXPECT_GT(at_most(found.of_twentieth, 0.06), alarms.level()) << found.of_twentieth;
    EXPECT_GT(at_least(found.of_half, 0.45), alarms.level()) << found.of_half;
  }
}

}  // namespace
}  // namespace rocking
