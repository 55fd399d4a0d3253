#pragma once

#include <cstdint>
#include <vector>

#include "rocking/ensemble/mode_family.hpp"
#include "rocking/ensemble/result.hpp"
#include "rocking/stats/mean_share.hpp"

namespace rocking {

/// What the count of a mode may be where `without_answer` of the unresolved realisations ended before their horizon.
[[nodiscard]] stats::CountBounds bounds_of(const section::ResponseMode& mode, const stats::Proportion& counted,
                                           std::uint64_t without_answer);

/// Probabilities of the listed modes with their intervals, for a fixed number of realisations >= 1. `confidence` in (0,
/// 1). The intervals cover every mode that the realisations without an answer may have; those of Sison and Glaz, which
/// belong to one list of counts, are absent then.
[[nodiscard]] std::vector<ModeEstimate> estimate_modes(const ModeTally& listed, double confidence,
                                                       std::uint64_t without_answer = 0);

}  // namespace rocking
