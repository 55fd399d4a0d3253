// Binomial numbers have the exact probabilities, with many and with few trials, on both sides of the change of method.

#include <cmath>
#include <cstdint>
#include <map>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/chi_squared.hpp>
#include <gtest/gtest.h>

#include "rocking/random/binomial.hpp"
#include "support/false_alarms.hpp"

namespace {

using namespace rocking::random;

/// P-value of a chi-square test of a million numbers. Neighbouring outcomes are taken together until a thousand numbers
/// are expected of them.
double p_value(std::uint64_t trials, double probability) {
  constexpr double draws = 1e6;
  std::map<std::uint64_t, double> counts;
  PhiloxEngine bits(Draws(2026, trials), Source::inference_counts);
  for (int i = 0; i < static_cast<int>(draws); ++i) counts[binomial(bits, trials, probability)] += 1.0;
  const boost::math::binomial law(static_cast<double>(trials), probability);
  const double middle = static_cast<double>(trials) * probability;
  const double reach = 10.0 * std::sqrt(middle * (1.0 - probability)) + 10.0;
  double statistic = 0.0;
  double classes = 0.0;
  double count = 0.0;
  double expected = 0.0;
  double expected_before = 0.0;
  const auto end_class = [&] {
    statistic += std::pow(count - expected, 2) / expected;
    classes += 1.0;
    expected_before += expected;
    count = expected = 0.0;
  };
  for (std::uint64_t k = 0; k <= trials; ++k) {
    const auto outcome = static_cast<double>(k);
    if (const auto found = counts.find(k); found != counts.end()) count += found->second;
    if (std::abs(outcome - middle) <= reach) expected += draws * boost::math::pdf(law, outcome);
    if (expected >= 1000.0 && draws - expected_before - expected >= 1000.0) end_class();
  }
  end_class();
  return boost::math::cdf(boost::math::complement(boost::math::chi_squared(classes - 1.0), statistic));
}

TEST(BinomialDraws, HaveTheExactProbabilities) {
  rocking::support::FalseAlarms alarms;
  struct Case {
    std::uint64_t trials;
    double probability;
  };
  for (const auto& [trials, probability] :
       {Case{12, 0.5}, Case{21, 0.5}, Case{26, 0.4}, Case{101, 0.97}, Case{150, 0.9}, Case{1000, 0.3},
        Case{1'000'000, 4e-6}, Case{1'000'001, 1.1e-5}, Case{1'000'002, 0.3}}) {
    EXPECT_GT(p_value(trials, probability), alarms.level()) << trials << ' ' << probability;
  }
}

}  // namespace
