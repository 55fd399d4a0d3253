#pragma once

#include <cstdint>
#include <optional>

#include "rocking/experiment/summary.hpp"

namespace rocking::experiment {

/// Number of the last change of this program that changed the bits of some realisation's record. Whoever changes such bits
/// (the digests of tests/golden tell) raises it.
///
/// 1: revision 61b81ca.
/// 2: a block that stops slipping slips on where sticking would need N <= 0 but slipping keeps the contact.
inline constexpr std::uint64_t results_version = 2;

/// Whether this program gives the same bits for a realisation that was stored under results version `version`. A change
/// that leaves recognisable realisations as they were tells here which ones these are. `next` is the second of the pair of which
/// `stored` is the first, since a first one says when the two parted; absent for a second one, and where there is none.
///
/// Of version 1 a row does not say whether its rerun at a tighter tolerance, or its longer run, left the ground: such a row is not
/// taken to be the same.
[[nodiscard]] inline bool has_current_bits(const Summary& stored, const std::optional<Summary>& next, std::uint64_t version) {
  if (version != 1) return version == results_version;
  const bool pair_stayed = !stored.left_ground && !(next && next->left_ground);
  return pair_stayed && !stored.repeat_mode && !stored.long_mode;
}

/// Whether that may differ because of a change that this program knows of.
[[nodiscard]] inline bool is_former_version(std::uint64_t version) { return 1 <= version && version < results_version; }

}  // namespace rocking::experiment
