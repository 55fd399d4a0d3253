#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "rocking/ensemble/result.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/stats/mean_share.hpp"

namespace rocking {

/// The modes with the largest counts, `most` at most, in the order of the modes. Of equal counts the first modes.
[[nodiscard]] std::vector<section::ResponseMode> most_frequent(const ModeTally& tally, std::size_t most);

/// Whether statements are made about a response mode in every condition, whatever its data: (1,1), (1,3), chaotic,
/// overturned, rest, unresolved. Statements about another (m,n) are made only where it occurs.
[[nodiscard]] bool is_prespecified(const section::ResponseMode& mode);

/// The modes that a report lists in every condition, also where they did not occur: (1,1), (1,3), chaotic, overturned.
[[nodiscard]] std::span<const section::ResponseMode> always_listed();

/// The family of all response modes; statements about them hold at once with probability `confidence`.
[[nodiscard]] stats::Family mode_family(double confidence);

/// The share of 1 - confidence that a statement about this mode takes in the family of all modes.
[[nodiscard]] stats::Significance significance_of(const section::ResponseMode& mode, double confidence);

/// The exact interval for the probability of a mode; the intervals of all modes hold at once with probability
/// `confidence`.
[[nodiscard]] stats::Interval simultaneous_interval(const section::ResponseMode& mode, const stats::Proportion& counts,
                                                    double confidence);

/// A tally as counts of that family.
[[nodiscard]] stats::CategoryCounts category_counts(const ModeTally& tally);

/// What the count of a mode may be where `without_answer` of the unresolved realisations ended before their horizon.
[[nodiscard]] stats::CountBounds bounds_of(const section::ResponseMode& mode, const stats::Proportion& counted,
                                           std::uint64_t without_answer);

/// Probabilities of the listed modes with their intervals, for a fixed number of realisations >= 1. `confidence` in (0,
/// 1). The intervals cover every mode that the realisations without an answer may have.
[[nodiscard]] std::vector<ModeEstimate> estimate_modes(const ModeTally& listed, double confidence,
                                                       std::uint64_t without_answer = 0);

/// How often realisations overturned to the left and to the right.
using SideCounts = std::array<std::uint64_t, 2>;

/// The share of 1 - confidence that a statement about overturning to one side takes: half of that of the mode.
[[nodiscard]] stats::Significance significance_of_side(double confidence);

/// Probabilities of overturning to the left and to the right, as estimate_modes gives them where both are modes in place
/// of `overturned`. Their counts add up to that of the mode in `listed`.
[[nodiscard]] std::array<SideEstimate, 2> estimate_sides(const ModeTally& listed, const SideCounts& sides,
                                                         double confidence, std::uint64_t without_answer = 0);

}  // namespace rocking
