#include "rocking/stats/mixed_probit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include <boost/math/quadrature/gauss.hpp>

#include "rocking/stats/normal_law.hpp"

namespace rocking::stats {
namespace {

constexpr std::size_t quadrature_nodes = 25;
constexpr std::size_t check_nodes = 11;
constexpr double tolerated_difference = 1e-4;
constexpr double tolerated_share = 1e-8;
/// exp(-40) of its maximum: what lies beyond changes no digit of the integral.
constexpr double negligible_drop = 40.0;

/// From here on Phi differs from 1 by less than the rounding of a likelihood, 3e-17.
constexpr double certain = 8.4;

/// Logarithm of the integrand at z, and sums over the levels of the first and of minus the second derivatives of its
/// terms by eta: times 1, u and u^2.
struct IntegrandTerms {
  double value = 0.0;
  double slope = 0.0, slope_u = 0.0;
  double bend = 0.0, bend_u = 0.0, bend_uu = 0.0;
};

/// One record under one set of parameters.
class RecordIntegrand {
 public:
  RecordIntegrand(std::span<const ProbitCounts> record, const MixedProbitParameters& parameters) : t_(parameters[2]) {
    terms_.reserve(2 * record.size());
    for (const ProbitCounts& level : record) {
      const double fixed = parameters[0] + parameters[1] * level.u;
      const bool has_two = level.happened > 0.0 && level.did_not > 0.0;
      if (level.happened > 0.0) terms_.push_back({1.0, level.happened, fixed, level.u, !has_two});
      if (level.did_not > 0.0) terms_.push_back({-1.0, level.did_not, fixed, level.u, true});
    }
    places_.resize(terms_.size());
    found_.resize(terms_.size());
  }

  [[nodiscard]] IntegrandTerms at(double z) const {
    const double shift = t_ * z;
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      places_[i] = std::min(terms_[i].side * (terms_[i].fixed + shift), certain);
    }
    log_normal_probabilities(places_, found_);
    IntegrandTerms sum{.value = -0.5 * z * z - 0.5 * std::log(2.0 * std::numbers::pi)};
    double slope = 0.0, bend = 0.0;  // of a level
    for (std::size_t i = 0; i < terms_.size(); ++i) {
      const Term& term = terms_[i];
      const double hazard = found_[i].slope;
      const double trials = places_[i] >= certain ? 0.0 : term.trials;
      sum.value += trials * found_[i].value;
      slope += trials * (term.side * hazard);
      bend += trials * std::max(0.0, hazard * (places_[i] + hazard));
      if (!term.ends_level) continue;
      sum.slope += slope;
      sum.slope_u += slope * term.u;
      sum.bend += bend;
      sum.bend_u += bend * term.u;
      sum.bend_uu += bend * term.u * term.u;
      slope = bend = 0.0;
    }
    return sum;
  }

  /// Minus the second derivative by z of the logarithm: at least 1.
  [[nodiscard]] double curvature(const IntegrandTerms& terms) const { return 1.0 + t_ * t_ * terms.bend; }

  /// The z of the largest integrand, whose logarithm is concave.
  [[nodiscard]] double mode() const {
    double z = 0.0;
    IntegrandTerms here = at(z);
    for (int step = 0; step < 100; ++step) {
      double dz = (t_ * here.slope - z) / curvature(here);
      // The rule is exact enough wherever its centre is near the mode.
      if (std::abs(dz) * std::sqrt(curvature(here)) <= 1e-7) break;
      IntegrandTerms there = at(z + dz);
      while (!(there.value >= here.value) && std::abs(dz) > 1e-12) {
        dz *= 0.5;
        there = at(z + dz);
      }
      z += dz;
      here = there;
    }
    return z;
  }

 private:
  /// Trials of one outcome at one level.
  struct Term {
    double side, trials, fixed, u;  // side 1 or -1; fixed: a + b u
    bool ends_level;
  };

  double t_;
  std::vector<Term> terms_;
  mutable std::vector<double> places_;  // of the terms at the last z
  mutable std::vector<LogNormalProbability> found_;
};

/// A node with the integrand, and the logarithm of its contribution to the integral.
struct Contribution {
  double z = 0.0;
  double log_value = 0.0;
  IntegrandTerms terms = {};

  /// `log_weight`: of the node.
  Contribution(const RecordIntegrand& integrand, double node, double log_weight) : z(node), terms(integrand.at(node)) {
    log_value = terms.value + log_weight;
  }
};

double log_sum(const std::vector<Contribution>& parts) {
  double largest = -std::numeric_limits<double>::infinity();
  for (const Contribution& part : parts) largest = std::max(largest, part.log_value);
  double sum = 0.0;
  for (const Contribution& part : parts) sum += std::exp(part.log_value - largest);
  return largest + std::log(sum);
}

/// A rule with the logarithms of weight exp(x^2).
struct HermiteNode {
  double x, log_weight;
};

std::vector<HermiteNode> hermite_nodes(std::size_t nodes) {
  std::vector<HermiteNode> rule;
  for (const QuadratureNode& node : gauss_hermite(nodes)) {
    rule.push_back({node.x, std::log(node.weight) + node.x * node.x});
  }
  return rule;
}

std::vector<Contribution> hermite_contributions(const RecordIntegrand& integrand, double mode, double width,
                                                const std::vector<HermiteNode>& rule) {
  std::vector<Contribution> parts;
  const double scale = std::numbers::sqrt2 * width;
  const double log_scale = std::log(scale);
  for (const HermiteNode& node : rule) {
    const double z = mode + scale * node.x;
    parts.emplace_back(integrand, z, node.log_weight + log_scale);
  }
  return parts;
}

using Legendre = boost::math::quadrature::gauss<double, 15>;

std::vector<Contribution> legendre_contributions(const RecordIntegrand& integrand, double low, double high) {
  std::vector<Contribution> parts;
  const double middle = 0.5 * (low + high);
  const double half = 0.5 * (high - low);
  for (std::size_t i = 0; i < Legendre::abscissa().size(); ++i) {
    const double offset = half * Legendre::abscissa()[i];
    const double log_weight = std::log(half * Legendre::weights()[i]);
    parts.emplace_back(integrand, middle + offset, log_weight);
    if (i > 0) parts.emplace_back(integrand, middle - offset, log_weight);
  }
  return parts;
}

/// Integrates over an interval by halving it; `scale`: logarithm of a first estimate of the whole integral, which may be
/// far too small. At most `most_panels` panels on each side of the mode: beyond that the accuracy is what it is.
class Halving {
 public:
  Halving(const RecordIntegrand& integrand, double scale) : integrand_(integrand), scale_(scale) {}

  void integrate(double low, double high) {
    auto whole = legendre_contributions(integrand_, low, high);
    scale_ = std::max(scale_, log_sum(whole));
    panels_ = 0;
    halve(low, high, std::move(whole), 0);
  }
  [[nodiscard]] std::vector<Contribution> parts() && { return std::move(parts_); }

 private:
  static constexpr int most_halvings = 24;
  static constexpr int most_panels = 60;

  void halve(double low, double high, std::vector<Contribution> whole, int depth) {
    const double middle = 0.5 * (low + high);
    auto left = legendre_contributions(integrand_, low, middle);
    auto right = legendre_contributions(integrand_, middle, high);
    const double coarse = std::exp(log_sum(whole) - scale_);
    const double fine = std::exp(log_sum(left) - scale_) + std::exp(log_sum(right) - scale_);
    scale_ = std::max(scale_, scale_ + std::log(std::max(fine, 1e-300)));
    if (std::abs(fine - coarse) <= tolerated_share * std::max(1.0, fine) || depth == most_halvings ||
        panels_ >= most_panels) {
      parts_.insert(parts_.end(), left.begin(), left.end());
      parts_.insert(parts_.end(), right.begin(), right.end());
      return;
    }
    ++panels_;
    halve(low, middle, std::move(left), depth + 1);
    halve(middle, high, std::move(right), depth + 1);
  }

  const RecordIntegrand& integrand_;
  double scale_;
  int panels_ = 0;
  std::vector<Contribution> parts_;
};

/// How far from the mode, on the side of `direction`, the integrand is negligible.
double reach_of_integrand(const RecordIntegrand& integrand, double mode, double top, double direction) {
  double reach = 1e-3;
  while (integrand.at(mode + direction * reach).value > top - negligible_drop) reach *= 1.5;
  return reach;
}

std::vector<Contribution> contributions_of(const RecordIntegrand& integrand) {
  static const std::vector<HermiteNode> fine = hermite_nodes(quadrature_nodes);
  static const std::vector<HermiteNode> coarse = hermite_nodes(check_nodes);
  const double mode = integrand.mode();
  const IntegrandTerms top = integrand.at(mode);
  const double width = 1.0 / std::sqrt(integrand.curvature(top));
  std::vector<Contribution> parts = hermite_contributions(integrand, mode, width, fine);
  const double total = log_sum(parts);
  const double check = log_sum(hermite_contributions(integrand, mode, width, coarse));
  if (std::abs(total - check) <= tolerated_difference) return parts;
  Halving halving(integrand, total);
  halving.integrate(mode - reach_of_integrand(integrand, mode, top.value, -1.0), mode);
  halving.integrate(mode, mode + reach_of_integrand(integrand, mode, top.value, 1.0));
  return std::move(halving).parts();
}

SmoothFunction likelihood_of(const std::vector<RecordCounts>& records) {
  return
      [&records](const Eigen::VectorXd& at) { return mixed_probit_log_likelihood(records, MixedProbitParameters(at)); };
}

/// Sum over the records of own(r), each by its weight.
template <class Own>
LocalShape weighted_sum(const std::vector<RecordCounts>& records, Own&& own) {
  LocalShape sum{.value = 0.0, .gradient = Eigen::Vector3d::Zero(), .hessian = Eigen::Matrix3d::Zero()};
  for (std::size_t r = 0; r < records.size(); ++r) {
    const double weight = records[r].weight;
    if (weight == 0.0) continue;
    const LocalShape& shape = own(r);
    sum.value += weight * shape.value;
    sum.gradient += weight * shape.gradient;
    sum.hessian += weight * shape.hessian;
  }
  return sum;
}

/// The maximum reached, or that with t = 0 if it is not higher.
Ascent with_boundary(Ascent reached, const std::vector<RecordCounts>& records) {
  constexpr double least_gain = 1e-9;
  const std::vector<ProbitCounts> pooled = pooled_counts(records);
  const auto [a, b] = most_likely_line(pooled);
  if (!(reached.shape.value > probit_likelihood(pooled, a, b).value + least_gain)) {
    const MixedProbitParameters plain(a, b, 0.0);
    return {.at = plain, .shape = mixed_probit_log_likelihood(records, plain), .has_converged = true};
  }
  if (reached.at[2] < 0.0) {
    reached.at[2] = -reached.at[2];
    reached.shape = mixed_probit_log_likelihood(records, MixedProbitParameters(reached.at));
  }
  return reached;
}

}  // namespace

LocalShape record_log_likelihood(std::span<const ProbitCounts> record, const MixedProbitParameters& parameters) {
  const RecordIntegrand integrand(record, parameters);
  const std::vector<Contribution> parts = contributions_of(integrand);
  const double total = log_sum(parts);
  Eigen::Vector3d mean_score = Eigen::Vector3d::Zero();
  Eigen::Matrix3d mean = Eigen::Matrix3d::Zero();
  for (const Contribution& part : parts) {
    const double share = std::exp(part.log_value - total);
    if (share < 1e-16) continue;
    const IntegrandTerms& terms = part.terms;
    const double z = part.z;
    const Eigen::Vector3d score(terms.slope, terms.slope_u, z * terms.slope);
    Eigen::Matrix3d bend;
    bend << terms.bend, terms.bend_u, z * terms.bend,   //
        terms.bend_u, terms.bend_uu, z * terms.bend_u,  //
        z * terms.bend, z * terms.bend_u, z * z * terms.bend;
    mean_score += share * score;
    mean += share * (score * score.transpose() - bend);
  }
  return {.value = total, .gradient = mean_score, .hessian = mean - mean_score * mean_score.transpose()};
}

LocalShape mixed_probit_log_likelihood(const std::vector<RecordCounts>& records,
                                       const MixedProbitParameters& parameters) {
  return weighted_sum(records, [&](std::size_t r) { return record_log_likelihood(records[r].counts, parameters); });
}

MixedProbitStart mixed_probit_start(const std::vector<RecordCounts>& records, const MixedProbitParameters& at) {
  MixedProbitStart start{.at = at, .records = {}};
  for (const RecordCounts& record : records) start.records.push_back(record_log_likelihood(record.counts, at));
  return start;
}

std::vector<ProbitCounts> pooled_counts(const std::vector<RecordCounts>& records) {
  std::map<double, ProbitCounts> pooled;
  for (const RecordCounts& record : records) {
    if (record.weight == 0.0) continue;
    auto near = pooled.begin();  // the levels of a record rise, and are mostly those of the others
    for (const ProbitCounts& level : record.counts) {
      near = pooled.try_emplace(near, level.u);
      ProbitCounts& sum = near->second;
      ++near;
      sum.u = level.u;
      sum.happened += record.weight * level.happened;
      sum.did_not += record.weight * level.did_not;
    }
  }
  std::vector<ProbitCounts> counts;
  for (const auto& [u, level] : pooled) counts.push_back(level);
  return counts;
}

// Every start has the pooled law of the fit without random intercepts.
Ascent most_likely_mixed_probit(const std::vector<RecordCounts>& records) {
  const auto [a, b] = most_likely_line(pooled_counts(records));
  Ascent best;
  for (const double t : {0.3, 1.0, 3.0, 10.0}) {
    const double factor = std::sqrt(1.0 + t * t);
    const MixedProbitParameters start(factor * a, factor * b, t);
    LocalShape shape = mixed_probit_log_likelihood(records, start);
    if (best.at.size() > 0 && !(shape.value > best.shape.value)) continue;
    best = {.at = start, .shape = std::move(shape), .has_converged = false};
  }
  return with_boundary(climb(likelihood_of(records), best.at, std::move(best.shape)), records);
}

Ascent most_likely_mixed_probit(const std::vector<RecordCounts>& records, const MixedProbitStart& start) {
  LocalShape at_start = weighted_sum(records, [&](std::size_t r) -> const LocalShape& { return start.records[r]; });
  return with_boundary(climb(likelihood_of(records), start.at, std::move(at_start)), records);
}

}  // namespace rocking::stats
