#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "rocking/base/many_parts.hpp"
#include "rocking/studies/infer/posterior.hpp"
#include "rocking/studies/infer/question.hpp"
#include "rocking/studies/infer/share_model.hpp"

namespace rocking::infer {

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
