#include "rocking/stats/fragility.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "rocking/base/error.hpp"
#include "rocking/stats/normal_law.hpp"
#include "rocking/stats/probit.hpp"

namespace rocking::stats {
namespace {

// A slope that is not significantly positive, or a dispersion of powers of ten, is reported as no law: its median would
// be arbitrary.
constexpr double least_confidence = 0.95;
constexpr double largest_dispersion = 10.0;

std::vector<ProbitCounts> counted(const std::vector<IntensityLevel>& levels, double centre) {
  std::vector<ProbitCounts> counts;
  for (const IntensityLevel& level : levels) {
    const Proportion found = proportion_at(level);
    counts.push_back({.u = std::log(level.intensity) - centre,
                      .happened = static_cast<double>(found.successes),
                      .did_not = static_cast<double>(found.trials - found.successes)});
  }
  return counts;
}

bool are_one_intensity(const std::vector<ProbitCounts>& counts) {
  return std::all_of(counts.begin(), counts.end(),
                     [&](const ProbitCounts& level) { return level.u == counts.front().u; });
}

/// Whether at every level all trials have one outcome.
bool vary_nowhere(const std::vector<ProbitCounts>& counts) {
  return std::all_of(counts.begin(), counts.end(),
                     [](const ProbitCounts& level) { return level.happened == 0.0 || level.did_not == 0.0; });
}

/// Whether the likelihood has a maximum, and if not, why. The slope at the maximum may still be negative.
FragilityOutcome outcome_of(const std::vector<ProbitCounts>& counts) {
  switch (shape_of(counts)) {
    case ProbitShape::never_happened: return FragilityOutcome::never_happened;
    case ProbitShape::always_happened: return FragilityOutcome::always_happened;
    case ProbitShape::rising_step: return FragilityOutcome::separated;
    case ProbitShape::falling_step: return FragilityOutcome::does_not_rise;
    case ProbitShape::has_maximum: break;
  }
  return vary_nowhere(counts) ? FragilityOutcome::no_scatter : FragilityOutcome::fitted;
}

/// Derivatives of the log-likelihood of a trial number by (a, b), summed over the levels.
struct Score {
  double a = 0.0, b = 0.0;
};

std::vector<Score> scores_of(const std::vector<IntensityLevel>& levels, const LognormalFragility& law) {
  std::vector<Score> scores(trial_numbers(levels));
  for (const IntensityLevel& level : levels) {
    const double u = std::log(level.intensity) - law.centre;
    const std::array<double, 2> slopes{probit_term(false, law.intercept + law.slope * u).slope,
                                       probit_term(true, law.intercept + law.slope * u).slope};
    for (std::size_t j = 0; j < level.happened.size(); ++j) {
      const double slope = slopes[level.happened[j] ? 1 : 0];
      scores[j].a += slope;
      scores[j].b += slope * u;
    }
  }
  return scores;
}

/// Whether the scores lie on one line: all equal, or two different values, as if trials differ at one level only. Their
/// covariance is then singular, and some interval of the law would have width 0. Equal trials have bitwise equal
/// scores.
bool are_on_a_line(const std::vector<Score>& scores) {
  const auto from_first = [&scores](const Score& score) {
    return Score{.a = score.a - scores.front().a, .b = score.b - scores.front().b};
  };
  const auto length = [](const Score& score) { return std::hypot(score.a, score.b); };
  Score longest;
  for (const Score& score : scores) {
    if (length(from_first(score)) > length(longest)) longest = from_first(score);
  }
  // Rounding changes the direction of a difference of scores by about 1e-16 times their size; levels that differ by a
  // millionth change it by more than this.
  constexpr double least_sine = 1e-9;
  return std::all_of(scores.begin(), scores.end(), [&](const Score& score) {
    const Score other = from_first(score);
    return std::abs(longest.a * other.b - longest.b * other.a) <= least_sine * length(longest) * length(other);
  });
}

/// Sum of the squares of the scores, with the correction for a small number of them.
SymmetricMatrix evidence(const std::vector<Score>& scores) {
  SymmetricMatrix sum;
  for (const Score& score : scores) sum.add_square(score.a, score.b, 1.0);
  const auto numbers = static_cast<double>(scores.size());
  const double correction = numbers / (numbers - 1.0);
  return {.aa = correction * sum.aa, .ab = correction * sum.ab, .bb = correction * sum.bb};
}

/// The product bread filling bread.
SymmetricMatrix sandwich(const SymmetricMatrix& bread, const SymmetricMatrix& filling) {
  const auto [pa, pb] = filling.times(bread.aa, bread.ab);
  const auto [qa, qb] = filling.times(bread.ab, bread.bb);
  return {
      .aa = bread.aa * pa + bread.ab * pb, .ab = bread.aa * qa + bread.ab * qb, .bb = bread.ab * qa + bread.bb * qb};
}

/// Number of trial numbers whose outcomes differ from the most frequent ones.
std::size_t differing_numbers(const std::vector<IntensityLevel>& levels) {
  std::map<std::vector<bool>, std::size_t> times;
  const std::size_t numbers = trial_numbers(levels);
  std::size_t most = 0;
  for (std::size_t j = 0; j < numbers; ++j) {
    std::vector<bool> outcomes;
    for (const IntensityLevel& level : levels) {
      outcomes.push_back(j < level.happened.size());
      outcomes.push_back(j < level.happened.size() && level.happened[j]);
    }
    most = std::max(most, ++times[outcomes]);
  }
  return numbers - most;
}

}  // namespace

Proportion proportion_at(const IntensityLevel& level) {
  return {.successes = static_cast<std::uint64_t>(std::count(level.happened.begin(), level.happened.end(), true)),
          .trials = level.happened.size()};
}

std::size_t trial_numbers(const std::vector<IntensityLevel>& levels) {
  std::size_t numbers = 0;
  for (const IntensityLevel& level : levels) numbers = std::max(numbers, level.happened.size());
  return numbers;
}

double LognormalFragility::probability(double intensity) const {
  return normal_cdf(intercept + slope * (std::log(intensity) - centre));
}

Interval LognormalFragility::band(double intensity, double confidence) const {
  const double u = std::log(intensity) - centre;
  const double variance = covariance.aa + 2.0 * u * covariance.ab + u * u * covariance.bb;
  const double reach = two_sided_t_quantile(confidence, degrees_of_freedom) * std::sqrt(std::max(0.0, variance));
  const double eta = intercept + slope * u;
  return {.low = normal_cdf(eta - reach), .high = normal_cdf(eta + reach)};
}

// (a + b u)^2 <= q^2 var(a + b u), a quadratic in u: c u^2 + 2 h u + k <= 0.
Bounded LognormalFragility::median(double confidence) const {
  const double q = two_sided_t_quantile(confidence, degrees_of_freedom);
  const double c = slope * slope - q * q * covariance.bb;
  const double h = intercept * slope - q * q * covariance.ab;
  const double k = intercept * intercept - q * q * covariance.aa;
  Bounded found{.value = std::exp(centre - intercept / slope),
                .interval = {.low = 0.0, .high = std::numeric_limits<double>::infinity()}};
  if (!(c > 0.0)) return found;
  const double root = std::sqrt(std::max(0.0, h * h - c * k));
  found.interval = {.low = std::exp(centre + (-h - root) / c), .high = std::exp(centre + (-h + root) / c)};
  return found;
}

Bounded LognormalFragility::dispersion(double confidence) const {
  const double reach = two_sided_t_quantile(confidence, degrees_of_freedom) * std::sqrt(covariance.bb) / slope;
  return {.value = 1.0 / slope, .interval = {.low = std::exp(-reach) / slope, .high = std::exp(reach) / slope}};
}

FragilityFit fit_lognormal(const std::vector<IntensityLevel>& levels, double confidence) {
  ROCKING_EXPECT(!levels.empty());
  LognormalFragility law;
  for (const IntensityLevel& level : levels) {
    ROCKING_EXPECT(level.intensity > 0.0 && !level.happened.empty());
    law.centre += std::log(level.intensity) / static_cast<double>(levels.size());
  }
  if (std::ranges::any_of(levels, [](const IntensityLevel& level) { return level.unresolved > 0; })) {
    return {.outcome = FragilityOutcome::unresolved, .law = std::nullopt};
  }
  const std::vector<ProbitCounts> counts = counted(levels, law.centre);
  if (are_one_intensity(counts) || trial_numbers(levels) < 2) {
    return {.outcome = FragilityOutcome::too_little, .law = std::nullopt};
  }
  if (const FragilityOutcome outcome = outcome_of(counts); outcome != FragilityOutcome::fitted) {
    return {.outcome = outcome, .law = std::nullopt};
  }
  const auto [a, b] = most_likely_line(counts);
  law.intercept = a;
  law.slope = b;
  if (!(b > 1.0 / largest_dispersion)) return {.outcome = FragilityOutcome::does_not_rise, .law = std::nullopt};
  const std::vector<Score> scores = scores_of(levels, law);
  if (are_on_a_line(scores)) return {.outcome = FragilityOutcome::no_scatter, .law = std::nullopt};
  const SymmetricMatrix found = sandwich(probit_likelihood(counts, a, b).information.inverse(), evidence(scores));
  law.covariance = {.aa = found.aa, .ab = found.ab, .bb = found.bb};
  law.degrees_of_freedom = static_cast<double>(differing_numbers(levels)) - 1.0;
  const double reach = two_sided_t_quantile(std::max(confidence, least_confidence), law.degrees_of_freedom);
  if (!(b > reach * std::sqrt(found.bb))) return {.outcome = FragilityOutcome::does_not_rise, .law = std::nullopt};
  return {.outcome = FragilityOutcome::fitted, .law = law};
}

}  // namespace rocking::stats
