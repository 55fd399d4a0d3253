#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "rocking/studies/infer/inference.hpp"
#include "rocking/studies/infer/lattice.hpp"
#include "rocking/studies/infer/share_model.hpp"

namespace rocking::infer {

/// What `tests` further tests under a candidate condition are expected to gain.
///
/// `weights`: of the points of the lattice, with sum 1, the normalised likelihood times the prior. Truths are drawn
/// from them, tests are made up at each, and the weights are worked out again with these tests. The size of the region
/// is the exponential of the entropy of the weights. Random numbers: of sets from `candidate_sets` on.
[[nodiscard]] CandidateGain gain_of(const ShareModel& candidate, std::uint64_t tests, const Lattice& lattice,
                                    const Eigen::VectorXd& weights, std::uint64_t seed);

}  // namespace rocking::infer
