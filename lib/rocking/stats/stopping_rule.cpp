#include "rocking/stats/stopping_rule.hpp"

#include <algorithm>
#include <array>

#include "rocking/base/elementary.hpp"
#include "rocking/base/error.hpp"
#include "rocking/stats/outer_end.hpp"

namespace rocking::stats {
namespace {

using base::natural_logarithm;

/// ln Gamma(x) for x > 0, with an error below 2e-14 plus a few roundings: Stirling's series for arguments from 16 on.
/// Its first omitted term, 1/(1188 x^9), is 1.2e-14 at 16.
double log_gamma(double x) {
  double product = 1.0;
  for (; x < 16.0; x += 1.0) product *= x;
  const double y = 1.0 / (x * x);
  const double series = (1.0 / 12.0 - y * (1.0 / 360.0 - y * (1.0 / 1260.0 - y / 1680.0))) / x;
  constexpr double half_log_two_pi = 0.91893853320467274178;
  return (x - 0.5) * natural_logarithm(x) - x + half_log_two_pi + series - natural_logarithm(product);
}

/// ln (Gamma(x + count)/Gamma(x)).
double log_rising_factorial(double x, double count) { return count > 0.0 ? log_gamma(x + count) - log_gamma(x) : 0.0; }

/// exp(x) for x <= 0, relative error about 1e-13: ten squarings of exp(x/1024), whose series has an error of 1e-17 at x
/// =
/// -40. Smaller results are negligible beside 1.
double exponential(double x) {
  if (x < -40.0) return 0.0;
  const double y = x / 1024.0;
  double power = 1.0;
  for (double k = 8.0; k >= 1.0; k -= 1.0) power = 1.0 + y / k * power;
  for (int squaring = 0; squaring < 10; ++squaring) power *= power;
  return power;
}

/// ln B(c p + k, c (1 - p) + n - k)/B(c p, c (1 - p)), the averaged likelihood.
double log_averaged_likelihood(const Proportion& counts, double p, double c) {
  const auto k = static_cast<double>(counts.successes);
  const auto n = static_cast<double>(counts.trials);
  return log_rising_factorial(c * p, k) + log_rising_factorial(c * (1.0 - p), n - k) - log_rising_factorial(c, n);
}

/// 2 ln(1/significance), and the r of the header.
struct Boundary {
  double twice_log;
  double ratio;
};

Boundary boundary_of(double significance) {
  const double twice_log = -2.0 * natural_logarithm(significance);
  return {twice_log, twice_log + natural_logarithm(1.0 + twice_log)};
}

constexpr std::uint64_t first_look = 50;

/// Half-width at p = 1/2 that needs as many trials as the goal does at the probability for which it is tuned: p = 1/2,
/// the worst case, or, for a relative half-width r, p = 1/101, where (1 - p)/(p r^2) is (10/r)^2. The sequence also
/// averages an eighth and a sixty-fourth of that number of trials, which suit p = 0.07 and p = 0.39.
double tuned_half_width(const StoppingGoal& goal) {
  return goal.scale == HalfWidthScale::relative ? 0.05 * goal.half_width : goal.half_width;
}

/// The concentration that is narrowest at the expected end of the run. It depends on the goal only, because the
/// intervals would not be valid if the data determined it.
double concentration_of(const StoppingGoal& goal) {
  const double significance = goal.family.share();
  const double expected = std::min(trials_for(tuned_half_width(goal), significance), static_cast<double>(goal.at_most));
  return concentration_for(expected, significance);
}

}  // namespace

ConfidenceSequence::ConfidenceSequence(double concentration) : concentration_(concentration) {
  ROCKING_EXPECT(concentration > 0.0);
}

double ConfidenceSequence::log_martingale(const Proportion& counts, double p) const {
  ROCKING_EXPECT(counts.successes <= counts.trials);
  ROCKING_EXPECT(0.0 < p && p < 1.0);
  const std::array<double, 3> terms{log_averaged_likelihood(counts, p, concentration_),
                                    log_averaged_likelihood(counts, p, concentration_ / 8.0),
                                    log_averaged_likelihood(counts, p, concentration_ / 64.0)};
  const double largest = std::max({terms[0], terms[1], terms[2]});
  const double average = 0.5 * exponential(terms[0] - largest) + 0.25 * exponential(terms[1] - largest) +
                         0.25 * exponential(terms[2] - largest);
  const auto k = static_cast<double>(counts.successes);
  const auto failures = static_cast<double>(counts.trials - counts.successes);
  return largest + natural_logarithm(average) - k * natural_logarithm(p) - failures * natural_logarithm(1.0 - p);
}

Interval ConfidenceSequence::interval(const Proportion& counts, const Significance& significance) const {
  ROCKING_EXPECT(significance.fixed >= 0.0 && significance.proportional >= 0.0 && 0.0 < significance.at(1.0) &&
                 significance.at(1.0) < 1.0);
  if (counts.trials == 0) return {0.0, 1.0};
  const auto contains = [&](double p) { return log_martingale(counts, p) < -natural_logarithm(significance.at(p)); };
  // At the estimate M is an average of likelihoods over the largest of them, hence at most 1: the interval contains the
  // estimate.
  const double estimate = static_cast<double>(counts.successes) / static_cast<double>(counts.trials);
  Interval interval{0.0, 1.0};
  if (counts.successes > 0 && !contains(nearly_zero)) interval.low = outer_end(estimate, nearly_zero, contains);
  if (counts.successes < counts.trials && !contains(nearly_one))
    interval.high = outer_end(estimate, nearly_one, contains);
  return interval;
}

double concentration_for(double trials, double significance) {
  ROCKING_EXPECT(trials > 0.0 && 0.0 < significance && significance < 1.0);
  return std::max(1.0, trials / boundary_of(significance).ratio);
}

double trials_for(double half_width, double significance) {
  ROCKING_EXPECT(half_width > 0.0 && 0.0 < significance && significance < 1.0);
  const auto [twice_log, ratio] = boundary_of(significance);
  const double squared_boundary = (1.0 + 1.0 / ratio) * (twice_log + natural_logarithm(1.0 + ratio));
  return squared_boundary / (4.0 * half_width * half_width);
}

StoppingRule::StoppingRule(const StoppingGoal& goal) : goal_(goal), sequence_(concentration_of(goal)) {
  ROCKING_EXPECT(0.0 < goal.half_width && goal.half_width < (goal.scale == HalfWidthScale::relative ? 1.0 : 0.5));
  ROCKING_EXPECT(goal.at_most >= 1);
  ROCKING_EXPECT(0.0 < goal.family.confidence && goal.family.confidence < 1.0);
}

std::uint64_t StoppingRule::next_look(std::uint64_t trials) const {
  if (trials < first_look) return std::min(first_look, goal_.at_most);
  const std::uint64_t tens = trials / 10;
  return std::min(10 * (tens + std::max<std::uint64_t>(1, tens / 10)), goal_.at_most);
}

bool StoppingRule::narrow_enough(const CategoryCounts& counts) const {
  ROCKING_EXPECT(counts.prespecified.size() == goal_.family.prespecified);
  const auto prespecified = [&](std::uint64_t k) {
    const Proportion of_category{k, counts.trials};
    return narrow_enough(of_category, interval_of_prespecified(of_category));
  };
  const auto others = [&](std::uint64_t k) {
    const Proportion of_category{k, counts.trials};
    return narrow_enough(of_category, interval_of_others(of_category));
  };
  return std::all_of(counts.prespecified.begin(), counts.prespecified.end(), prespecified) &&
         std::all_of(counts.others.begin(), counts.others.end(), others) && others(0);
}

bool StoppingRule::narrow_enough(const Proportion& counts, const Interval& interval) const {
  const double half_width = 0.5 * (interval.high - interval.low);
  if (goal_.scale == HalfWidthScale::absolute) return half_width <= goal_.half_width;
  const double estimate = static_cast<double>(counts.successes) / static_cast<double>(counts.trials);
  return counts.successes > 0 && half_width <= goal_.half_width * estimate;
}

Interval StoppingRule::interval_of_prespecified(const Proportion& counts) const {
  return sequence_.interval(counts, goal_.family.of_prespecified());
}

Interval StoppingRule::interval_of_others(const Proportion& counts) const {
  return sequence_.interval(counts, goal_.family.of_others());
}

}  // namespace rocking::stats
