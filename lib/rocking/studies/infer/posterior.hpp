#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "rocking/studies/infer/survey.hpp"

namespace rocking::infer {

/// Likelihood times prior on the smallest lattice around all points that have weight. Without any prior: the likelihood
/// on the lattice of the survey.
struct Posterior {
  Lattice lattice;
  Eigen::VectorXd weights;  ///< of the points, with sum 1
};

/// The part of the unit cube in which the priors may have weight.
///
/// Throws base::InputError if a prior has none in the range of its unknown.
[[nodiscard]] Window reach_of_priors(const std::vector<Unknown>& unknowns);

/// `models`: of the tested conditions; `found`: their survey. Throws base::Stopped if it is asked to stop.
[[nodiscard]] Posterior posterior_of(const std::vector<ShareModel>& models, const Counts& counts,
                                     const std::vector<Unknown>& unknowns, const Survey& found,
                                     base::StopRequest stop = {});

/// Mean, median and interval with equal tails of an unknown.
[[nodiscard]] UnknownPosterior summary(const Posterior& posterior, const std::vector<Unknown>& unknowns,
                                       std::size_t unknown, double confidence);

}  // namespace rocking::infer
