#include "rocking/stats/probit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <boost/math/distributions/normal.hpp>

#include "rocking/base/error.hpp"
#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {
namespace {

constexpr int most_steps = 100;

/// Log-likelihood of a probability of its own at each u.
double saturated(const std::vector<ProbitCounts>& counts) {
  double sum = 0.0;
  for (const ProbitCounts& level : counts) {
    const double trials = level.happened + level.did_not;
    for (const double part : {level.happened, level.did_not}) {
      if (part > 0.0) sum += part * std::log(part / trials);
    }
  }
  return sum;
}

}  // namespace

ProbitTerm probit_term(bool happened, double eta) {
  const double side = happened ? 1.0 : -1.0;
  const double z = side * eta;
  const auto [value, hazard] = log_normal_probability(z);
  return {.value = value, .slope = side * hazard, .curvature = std::max(0.0, hazard * (z + hazard))};
}

ProbitLikelihood probit_likelihood(const std::vector<ProbitCounts>& counts, double a, double b) {
  ProbitLikelihood sum;
  for (const ProbitCounts& level : counts) {
    for (const bool happened : {true, false}) {
      const double trials = happened ? level.happened : level.did_not;
      if (trials == 0.0) continue;
      const ProbitTerm term = probit_term(happened, a + b * level.u);
      sum.value += trials * term.value;
      sum.a += trials * term.slope;
      sum.b += trials * term.slope * level.u;
      sum.information.add_square(1.0, level.u, trials * term.curvature);
    }
  }
  return sum;
}

ProbitShape shape_of(const std::vector<ProbitCounts>& counts) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  // The lowest and highest u with an event, and the lowest and highest u without one.
  double first = infinity, last = -infinity, first_not = infinity, last_not = -infinity;
  for (const ProbitCounts& level : counts) {
    if (level.happened > 0.0) {
      first = std::min(first, level.u);
      last = std::max(last, level.u);
    }
    if (level.did_not > 0.0) {
      first_not = std::min(first_not, level.u);
      last_not = std::max(last_not, level.u);
    }
  }
  if (last < first) return ProbitShape::never_happened;
  if (last_not < first_not) return ProbitShape::always_happened;
  if (last_not <= first && first_not < last) return ProbitShape::rising_step;
  if (last <= first_not) return ProbitShape::falling_step;
  return ProbitShape::has_maximum;
}

// A Newton step is halved until the likelihood increases. Near the maximum, where rounding would hide the increase,
// full steps are taken; the method converges there without halving.
ProbitLine most_likely_line(const std::vector<ProbitCounts>& counts, const ProbitLine& start) {
  auto [a, b] = start;
  ProbitLikelihood here = probit_likelihood(counts, a, b);
  for (int step = 0; step < most_steps; ++step) {
    const auto [da, db] = here.information.inverse().times(here.a, here.b);
    const bool is_near = here.a * da + here.b * db < 1e-6;
    double length = 1.0;
    ProbitLikelihood there = probit_likelihood(counts, a + da, b + db);
    while (!is_near && !(there.value > here.value) && length > 1e-9) {  // also true for NaN
      length *= 0.5;
      there = probit_likelihood(counts, a + length * da, b + length * db);
    }
    a += length * da;
    b += length * db;
    here = there;
    if (std::max(std::abs(da), std::abs(db)) <= 1e-13 * (1.0 + std::abs(a) + std::abs(b))) break;
  }
  return {.a = a, .b = b};
}

double probit_deviance(const std::vector<ProbitCounts>& counts, const ProbitLine& start) {
  if (shape_of(counts) != ProbitShape::has_maximum) return 0.0;
  const auto [a, b] = most_likely_line(counts, start);
  return 2.0 * std::max(0.0, saturated(counts) - probit_likelihood(counts, a, b).value);
}

ProbitInterpolation::ProbitInterpolation(const std::vector<KnownProbability>& points) {
  constexpr double least = 1e-9;  // 0 and 1 have no probit; a curve drawn 1e-9 from them cannot be told apart
  ROCKING_EXPECT(points.size() >= 2);
  const boost::math::normal_distribution<double> normal;
  for (const KnownProbability& point : points) {
    ROCKING_EXPECT(point.intensity > 0.0);
    nodes_.push_back({.logarithm = std::log(point.intensity),
                      .probit = quantile(normal, std::clamp(point.probability, least, 1.0 - least))});
  }
}

double ProbitInterpolation::probability(double intensity) const {
  const double at = std::log(intensity);
  std::size_t next = 1;
  while (next + 1 < nodes_.size() && nodes_[next].logarithm < at) ++next;
  const Node& low = nodes_[next - 1];
  const Node& high = nodes_[next];
  const double part = (at - low.logarithm) / (high.logarithm - low.logarithm);
  return normal_cdf((1.0 - part) * low.probit + part * high.probit);
}

}  // namespace rocking::stats
