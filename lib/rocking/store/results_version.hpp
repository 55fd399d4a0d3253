#pragma once

#include <cstdint>
#include <optional>

#include "rocking/store/summary.hpp"

namespace rocking {

/// Number of the last change of this program that changed the bits of the result of any realisation. Increase it with
/// every such change (the digests of tests/golden show one).
///
/// 1: revision 61b81ca.
/// 2: a block that stops slipping slips on where sticking would need N <= 0 but slipping keeps the contact.
inline constexpr std::uint64_t results_version = 2;

/// Whether this program would give the same bits for a realisation stored under the results version `version`. A change
/// that leaves recognisable realisations unchanged identifies them here. `next` is the second realisation of the pair
/// whose first one is `stored`, since the row of the first contains the time at which the two diverged. It is absent if
/// `stored` is a second realisation, or if there is no second one.
///
/// A row of version 1 does not say whether its rerun at a tighter tolerance, or its longer run, lost contact. Such a
/// row is therefore not regarded as the same.
[[nodiscard]] inline bool has_current_bits(const Summary& stored, const std::optional<Summary>& next,
                                           std::uint64_t version) {
  if (version != 1) return version == results_version;
  const bool pair_stayed = !stored.left_ground && !(next && next->left_ground);
  return pair_stayed && !stored.rerun_mode && !stored.long_mode;
}

/// Whether results of this version may differ because of a change that this program knows.
[[nodiscard]] inline bool is_former_version(std::uint64_t version) { return 1 <= version && version < results_version; }

}  // namespace rocking
