#include "rocking/stats/fragility.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <boost/math/distributions/normal.hpp>

#include "rocking/base/error.hpp"
#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {
namespace {

constexpr int most_steps = 100;

// A slope that is not significantly positive, or a dispersion of powers of ten, is reported as no law: its median would
// be arbitrary.
constexpr double least_standard_errors = 2.0;
constexpr double largest_dispersion = 10.0;

/// Contribution of one trial to the log-likelihood, as a function of eta = a + b u.
struct Term {
  double value = 0.0;
  double slope = 0.0;      ///< first derivative
  double curvature = 0.0;  ///< minus the second derivative: >= 0
};

/// ln Phi(eta) and its derivatives; for a trial without the event those at -eta, with the opposite slope.
Term term_of(bool happened, double eta) {
  const double side = happened ? 1.0 : -1.0;
  const double z = side * eta;
  const double value = log_normal_cdf(z);
  const double hazard = std::exp(-0.5 * z * z - value) / std::sqrt(2.0 * std::numbers::pi);
  return {.value = value, .slope = side * hazard, .curvature = std::max(0.0, hazard * (z + hazard))};
}

/// A symmetric 2 x 2 matrix.
struct Matrix {
  double aa = 0.0, ab = 0.0, bb = 0.0;

  void add_square(double a, double b, double weight) {
    aa += weight * a * a;
    ab += weight * a * b;
    bb += weight * b * b;
  }
  [[nodiscard]] Matrix inverse() const {
    const double determinant = aa * bb - ab * ab;
    return {.aa = bb / determinant, .ab = -ab / determinant, .bb = aa / determinant};
  }
  [[nodiscard]] std::array<double, 2> times(double a, double b) const { return {aa * a + ab * b, ab * a + bb * b}; }
};

struct Likelihood {
  double value = 0.0;
  double a = 0.0, b = 0.0;  ///< first derivatives
  Matrix information;       ///< minus the second derivatives
};

struct Level {
  double u = 0.0;
  double happened = 0.0;
  double did_not = 0.0;
};

Likelihood likelihood_at(const std::vector<Level>& levels, double a, double b) {
  Likelihood sum;
  for (const Level& level : levels) {
    for (const bool happened : {true, false}) {
      const double trials = happened ? level.happened : level.did_not;
      if (trials == 0.0) continue;
      const Term term = term_of(happened, a + b * level.u);
      sum.value += trials * term.value;
      sum.a += trials * term.slope;
      sum.b += trials * term.slope * level.u;
      sum.information.add_square(1.0, level.u, trials * term.curvature);
    }
  }
  return sum;
}

/// The (a, b) of the maximum likelihood, which must exist. A Newton step is halved until the likelihood increases. Near
/// the maximum, where rounding would hide the increase, full steps are taken; the method converges there without
/// halving.
std::array<double, 2> largest_likelihood(const std::vector<Level>& levels) {
  double a = 0.0;
  double b = 0.0;
  Likelihood here = likelihood_at(levels, a, b);
  for (int step = 0; step < most_steps; ++step) {
    const auto [da, db] = here.information.inverse().times(here.a, here.b);
    const bool is_near = here.a * da + here.b * db < 1e-6;
    double length = 1.0;
    Likelihood there = likelihood_at(levels, a + da, b + db);
    while (!is_near && !(there.value > here.value) && length > 1e-9) {  // also true for NaN
      length *= 0.5;
      there = likelihood_at(levels, a + length * da, b + length * db);
    }
    a += length * da;
    b += length * db;
    here = there;
    if (std::max(std::abs(da), std::abs(db)) <= 1e-13 * (1.0 + std::abs(a) + std::abs(b))) break;
  }
  return {a, b};
}

std::vector<Level> counted(const std::vector<IntensityLevel>& levels, double centre) {
  std::vector<Level> counts;
  for (const IntensityLevel& level : levels) {
    const Proportion found = proportion_at(level);
    counts.push_back({.u = std::log(level.intensity) - centre,
                      .happened = static_cast<double>(found.successes),
                      .did_not = static_cast<double>(found.trials - found.successes)});
  }
  return counts;
}

bool are_one_intensity(const std::vector<Level>& levels) {
  return std::all_of(levels.begin(), levels.end(), [&](const Level& level) { return level.u == levels.front().u; });
}

/// Whether the likelihood has a maximum, and if not, why. The slope at the maximum may still be negative.
FragilityOutcome outcome_of(const std::vector<Level>& levels) {
  // The lowest and highest level with an event, and the lowest and highest level without one.
  double first = INFINITY, last = -INFINITY, first_not = INFINITY, last_not = -INFINITY;
  for (const Level& level : levels) {
    if (level.happened > 0.0) {
      first = std::min(first, level.u);
      last = std::max(last, level.u);
    }
    if (level.did_not > 0.0) {
      first_not = std::min(first_not, level.u);
      last_not = std::max(last_not, level.u);
    }
  }
  if (last < first) return FragilityOutcome::never_happened;
  if (last_not < first_not) return FragilityOutcome::always_happened;
  if (last_not <= first && first_not < last) return FragilityOutcome::separated;
  if (last <= first_not) return FragilityOutcome::does_not_rise;
  return FragilityOutcome::fitted;
}

std::size_t trial_numbers(const std::vector<IntensityLevel>& levels) {
  std::size_t numbers = 0;
  for (const IntensityLevel& level : levels) numbers = std::max(numbers, level.happened.size());
  return numbers;
}

/// Derivatives of the log-likelihood of a trial number by (a, b), summed over the levels.
struct Score {
  double a = 0.0, b = 0.0;
};

std::vector<Score> scores_of(const std::vector<IntensityLevel>& levels, const LognormalFragility& law) {
  std::vector<Score> scores(trial_numbers(levels));
  for (const IntensityLevel& level : levels) {
    const double u = std::log(level.intensity) - law.centre;
    for (std::size_t j = 0; j < level.happened.size(); ++j) {
      const double slope = term_of(level.happened[j], law.intercept + law.slope * u).slope;
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
Matrix evidence(const std::vector<Score>& scores) {
  Matrix sum;
  for (const Score& score : scores) sum.add_square(score.a, score.b, 1.0);
  const auto numbers = static_cast<double>(scores.size());
  const double correction = numbers / (numbers - 1.0);
  return {.aa = correction * sum.aa, .ab = correction * sum.ab, .bb = correction * sum.bb};
}

/// The product bread filling bread.
Matrix sandwich(const Matrix& bread, const Matrix& filling) {
  const auto [pa, pb] = filling.times(bread.aa, bread.ab);
  const auto [qa, qb] = filling.times(bread.ab, bread.bb);
  return {
      .aa = bread.aa * pa + bread.ab * pb, .ab = bread.aa * qa + bread.ab * qb, .bb = bread.ab * qa + bread.bb * qb};
}

double normal_quantile(double confidence) {
  return quantile(complement(boost::math::normal_distribution<double>(), 0.5 * (1.0 - confidence)));
}

/// exp(logarithm), with the interval given by the variance of the logarithm.
Bounded by_logarithm(double logarithm, double variance, double confidence) {
  const double reach = normal_quantile(confidence) * std::sqrt(std::max(0.0, variance));
  return {.value = std::exp(logarithm),
          .interval = {.low = std::exp(logarithm - reach), .high = std::exp(logarithm + reach)}};
}

}  // namespace

Proportion proportion_at(const IntensityLevel& level) {
  return {.successes = static_cast<std::uint64_t>(std::count(level.happened.begin(), level.happened.end(), true)),
          .trials = level.happened.size()};
}

double LognormalFragility::probability(double intensity) const {
  return normal_cdf(intercept + slope * (std::log(intensity) - centre));
}

Interval LognormalFragility::band(double intensity, double confidence) const {
  const double u = std::log(intensity) - centre;
  const double variance = covariance.aa + 2.0 * u * covariance.ab + u * u * covariance.bb;
  const double reach = normal_quantile(confidence) * std::sqrt(std::max(0.0, variance));
  const double eta = intercept + slope * u;
  return {.low = normal_cdf(eta - reach), .high = normal_cdf(eta + reach)};
}

Bounded LognormalFragility::median(double confidence) const {
  // d(-a/b) = (-da + (a/b) db)/b
  const double ratio = intercept / slope;
  const double variance =
      (covariance.aa - 2.0 * ratio * covariance.ab + ratio * ratio * covariance.bb) / (slope * slope);
  return by_logarithm(centre - ratio, variance, confidence);
}

Bounded LognormalFragility::dispersion(double confidence) const {
  return by_logarithm(-std::log(slope), covariance.bb / (slope * slope), confidence);
}

FragilityFit fit_lognormal(const std::vector<IntensityLevel>& levels) {
  ROCKING_EXPECT(!levels.empty());
  LognormalFragility law;
  for (const IntensityLevel& level : levels) {
    ROCKING_EXPECT(level.intensity > 0.0 && !level.happened.empty());
    law.centre += std::log(level.intensity) / static_cast<double>(levels.size());
  }
  const std::vector<Level> counts = counted(levels, law.centre);
  if (are_one_intensity(counts) || trial_numbers(levels) < 2) {
    return {.outcome = FragilityOutcome::too_little, .law = std::nullopt};
  }
  if (const FragilityOutcome outcome = outcome_of(counts); outcome != FragilityOutcome::fitted) {
    return {.outcome = outcome, .law = std::nullopt};
  }
  const auto [a, b] = largest_likelihood(counts);
  law.intercept = a;
  law.slope = b;
  if (!(b > 1.0 / largest_dispersion)) return {.outcome = FragilityOutcome::does_not_rise, .law = std::nullopt};
  const std::vector<Score> scores = scores_of(levels, law);
  if (are_on_a_line(scores)) return {.outcome = FragilityOutcome::no_scatter, .law = std::nullopt};
  const Matrix found = sandwich(likelihood_at(counts, a, b).information.inverse(), evidence(scores));
  law.covariance = {.aa = found.aa, .ab = found.ab, .bb = found.bb};
  if (!(b > least_standard_errors * std::sqrt(found.bb))) {
    return {.outcome = FragilityOutcome::does_not_rise, .law = std::nullopt};
  }
  return {.outcome = FragilityOutcome::fitted, .law = law};
}

}  // namespace rocking::stats
