#pragma once

#include <cstdint>

#include "rocking/experiment/summary.hpp"

namespace rocking::experiment {

/// Number of the last change of this program that changed the bits of some realisation's record. Whoever changes such bits
/// (the digests of tests/golden tell) raises it.
///
/// 1: revision 61b81ca.
/// 2: a block that stops slipping slips on where sticking would need N <= 0 but slipping keeps the contact.
inline constexpr std::uint64_t results_version = 2;

/// Whether this program gives the same bits for a realisation that was stored under results version `version`. A change
/// that leaves recognisable realisations as they were tells here which ones these are.
[[nodiscard]] inline bool has_current_bits(const Summary& stored, std::uint64_t version) {
  if (version == 1) return !stored.left_ground;
  return version == results_version;
}

}  // namespace rocking::experiment
