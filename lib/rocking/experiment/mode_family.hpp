#pragma once

#include <cstdint>
#include <map>

#include "rocking/section/response_mode.hpp"
#include "rocking/stats/family.hpp"

namespace rocking::experiment {

/// Realisations of a condition, by response mode.
using ModeTally = std::map<section::ResponseMode, std::uint64_t>;

/// Whether a response mode is one of those that every condition is asked about, whatever its data: (1,1), (1,3), chaotic,
/// overturned, rest, unresolved. The other (m,n) are told of where they occur.
[[nodiscard]] bool is_foreseen(const section::ResponseMode& mode);

/// The family of all response modes, about which statements are to hold at once.
[[nodiscard]] stats::Family mode_family(double confidence);

/// A tally as counts of that family.
[[nodiscard]] stats::CategoryCounts category_counts(const ModeTally& tally);

}  // namespace rocking::experiment
