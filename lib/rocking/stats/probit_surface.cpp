#include "rocking/stats/probit_surface.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "rocking/stats/probit.hpp"
#include "rocking/stats/suite_bootstrap.hpp"

namespace rocking::stats {
namespace {

using Terms = std::array<bool, 4>;
using SurfaceVector = Eigen::Vector4d;
using SurfaceMatrix = Eigen::Matrix4d;

constexpr Terms all_terms{true, true, true, true};
constexpr Terms additive_terms{true, true, true, false};
/// Where the likelihood has no maximum, Newton's steps do not become small.
constexpr int most_surface_steps = 60;

/// The log-likelihood with its derivatives.
struct SurfaceLikelihood {
  double value = 0.0;
  SurfaceVector slope = SurfaceVector::Zero();
  SurfaceMatrix information = SurfaceMatrix::Zero();  ///< minus the second derivatives
  std::vector<SurfaceVector> of_record;               ///< first derivatives, of weight 1
};

SurfaceLikelihood likelihood(const std::vector<SurfaceCounts>& counts, const std::vector<double>& weights,
                             const Terms& free, const SurfaceVector& at) {
  SurfaceLikelihood sum;
  sum.of_record.assign(weights.size(), SurfaceVector::Zero());
  for (const SurfaceCounts& point : counts) {
    const double weight = weights[point.record];
    if (weight == 0.0) continue;
    SurfaceVector terms(1.0, point.u, point.v, point.u * point.v);
    for (int i = 0; i < 4; ++i) terms[i] *= free[static_cast<std::size_t>(i)] ? 1.0 : 0.0;
    for (const bool happened : {true, false}) {
      const double trials = happened ? point.happened : point.did_not;
      if (trials == 0.0) continue;
      const ProbitTerm term = probit_term(happened, at.dot(terms));
      sum.value += weight * trials * term.value;
      sum.slope += weight * trials * term.slope * terms;
      sum.information += weight * trials * term.curvature * terms * terms.transpose();
      sum.of_record[point.record] += trials * term.slope * terms;
    }
  }
  return sum;
}

/// The Cholesky decomposition of the part of a symmetric matrix that belongs to `terms`.
class PartOfTerms {
 public:
  PartOfTerms(const SurfaceMatrix& matrix, const Terms& terms) {
    SurfaceMatrix part = SurfaceMatrix::Identity();
    for (int i = 0; i < 4; ++i) {
      keep_[i] = terms[static_cast<std::size_t>(i)] ? 1.0 : 0.0;
      if (keep_[i] != 0.0) scale_[i] = 1.0 / std::sqrt(matrix(i, i));
    }
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < i; ++j) part(i, j) = part(j, i) = keep_[i] * keep_[j] * matrix(i, j) * scale_[i] * scale_[j];
    }
    if (scale_.allFinite()) cholesky_.compute(part);
    constexpr double least_pivot = 1e-10;  // of 1
    is_regular_ = scale_.allFinite() && cholesky_.vectorD().minCoeff() > least_pivot;
  }

  [[nodiscard]] bool is_regular() const { return is_regular_; }

  /// The inverse times a vector, zero where no term is.
  [[nodiscard]] SurfaceVector solve(const SurfaceVector& right) const {
    const SurfaceVector scaled = keep_.cwiseProduct(scale_).cwiseProduct(right);
    return scale_.cwiseProduct(SurfaceVector(cholesky_.solve(scaled)));
  }

 private:
  SurfaceVector keep_, scale_ = SurfaceVector::Ones();
  Eigen::LDLT<SurfaceMatrix> cholesky_;
  bool is_regular_ = false;
};

/// A maximum of the likelihood, and the covariance of the coefficients of records that are drawn independently.
struct Maximum {
  SurfaceVector at;
  double log_likelihood = 0.0;
  SurfaceMatrix covariance = SurfaceMatrix::Zero();
};

Maximum maximum_at(const SurfaceVector& at, const SurfaceLikelihood& here, const PartOfTerms& information,
                   const std::vector<double>& weights) {
  Maximum found{.at = at, .log_likelihood = here.value};
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const SurfaceVector influence = information.solve(here.of_record[i]);
    found.covariance += weights[i] * influence * influence.transpose();
  }
  return found;
}

/// By Newton's method on a concave function: a step is halved until the likelihood increases. Near the maximum, where
/// rounding would hide the increase, full steps are taken.
std::optional<Maximum> maximum(const std::vector<SurfaceCounts>& counts, const std::vector<double>& weights,
                               const Terms& free, const SurfaceVector& start) {
  SurfaceVector at = start;
  SurfaceLikelihood here = likelihood(counts, weights, free, at);
  for (int step = 0; step < most_surface_steps; ++step) {
    const PartOfTerms information(here.information, free);
    if (!information.is_regular()) return std::nullopt;
    SurfaceVector change = information.solve(here.slope);
    if (change.cwiseAbs().maxCoeff() <= 1e-9 * (1.0 + at.cwiseAbs().maxCoeff())) {
      return maximum_at(at, here, information, weights);
    }
    const bool is_near = here.slope.dot(change) < 1e-6;
    SurfaceLikelihood next = likelihood(counts, weights, free, at + change);
    while (!is_near && !(next.value > here.value) && change.cwiseAbs().maxCoeff() > 1e-9) {  // also true for NaN
      change *= 0.5;
      next = likelihood(counts, weights, free, at + change);
    }
    at += change;
    here = std::move(next);
  }
  return std::nullopt;
}

/// Of the differences of the coefficients from `values`; absent where the covariance is singular.
std::optional<double> wald(const Maximum& maximum, const SurfaceVector& values, const Terms& tested) {
  const PartOfTerms covariance(maximum.covariance, tested);
  if (!covariance.is_regular()) return std::nullopt;
  const SurfaceVector difference = maximum.at - values;
  return difference.dot(covariance.solve(difference));
}

/// A model with its bootstrap samples, absent where the likelihood has no maximum.
struct Model {
  Maximum whole;
  std::vector<std::optional<Maximum>> samples;

  [[nodiscard]] SurfaceTest test(const Terms& tested) const {
    SurfaceTest found;
    const auto statistic = wald(whole, SurfaceVector::Zero(), tested);
    if (!statistic) return found;
    found.wald = *statistic;
    for (const auto& sample : samples) {
      const auto about = sample ? wald(*sample, whole.at, tested) : std::nullopt;
      found.samples += about ? 1 : 0;
      found.as_large += about && *about >= *statistic ? 1 : 0;
    }
    if (static_cast<double>(found.samples) >= least_share_with_law * static_cast<double>(samples.size())) {
      found.p_value = static_cast<double>(found.as_large + 1) / static_cast<double>(found.samples + 1);
    }
    return found;
  }
};

std::optional<Model> model_of(const std::vector<SurfaceCounts>& counts, const std::vector<std::vector<double>>& samples,
                              const Terms& free, const base::ManyParts& how) {
  const std::vector<double> equal(std::ranges::max(counts, {}, &SurfaceCounts::record).record + 1, 1.0);
  const auto whole = maximum(counts, equal, free, SurfaceVector::Zero());
  if (!whole) return std::nullopt;
  Model model{.whole = *whole, .samples = {}};
  model.samples.resize(samples.size());
  base::for_each_part(how, samples.size(),
                      [&](std::size_t i) { model.samples[i] = maximum(counts, samples[i], free, whole->at); });
  return model;
}

SurfaceCoefficients coefficients_of(const Maximum& maximum) {
  return {maximum.at[0], maximum.at[1], maximum.at[2], maximum.at[3]};
}

}  // namespace

std::optional<ProbitSurface> probit_surface(const std::vector<SurfaceCounts>& counts,
                                            const std::vector<std::vector<double>>& samples,
                                            const base::ManyParts& how) {
  auto taken = model_of(counts, samples, additive_terms, how);
  if (!taken) return std::nullopt;
  ProbitSurface found;
  found.second = taken->test({false, false, true, false});
  if (auto whole = model_of(counts, samples, all_terms, how)) {
    found.interaction = whole->test({false, false, false, true});
    found.has_interaction = found.interaction->p_value && *found.interaction->p_value <= surface_significance;
    if (found.has_interaction) taken = std::move(whole);
  }
  found.coefficients = coefficients_of(taken->whole);
  found.log_likelihood = taken->whole.log_likelihood;
  for (const auto& sample : taken->samples) {
    if (sample) found.samples.push_back(coefficients_of(*sample));
  }
  return found;
}

}  // namespace rocking::stats
