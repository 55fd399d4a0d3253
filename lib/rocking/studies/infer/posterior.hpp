#pragma once

#include "rocking/scene/quantity.hpp"
#include "rocking/studies/infer/share_model.hpp"
#include "rocking/studies/infer/survey.hpp"

namespace rocking::infer {

/// Logarithm of the density of a law at a value, up to a constant; minus infinity outside of it.
///
/// Throws std::invalid_argument for a number and for single values, which have no density.
[[nodiscard]] double log_density(const Quantity& law, double value);

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
                                     const base::ManyParts& how = {});

/// Mean, median and interval with equal tails of an unknown.
[[nodiscard]] UnknownPosterior summary(const Posterior& posterior, const std::vector<Unknown>& unknowns,
                                       std::size_t unknown, double confidence);

/// What `tests` further tests under a candidate condition are expected to gain.
///
/// Truths are drawn from the posterior, tests are made up at each, and the weights are worked out again with these
/// tests. The size of the region is the exponential of the entropy of the weights. Random numbers: of sets from
/// `candidate_sets` on. A set is a part of `how`. Throws base::Stopped if it is asked to stop.
[[nodiscard]] CandidateGain gain_of(const ShareModel& candidate, std::uint64_t tests, const Posterior& posterior,
                                    std::uint64_t seed, const base::ManyParts& how = {});

/// Data sets that gain_of makes up.
inline constexpr std::size_t sets_of_candidate = 200;

}  // namespace rocking::infer
