#pragma once

#include <cstdint>

namespace rocking {

/// Number of the last change of this program that changed the bits of the result of any realisation. Increase it with
/// every such change (the digests of tests/golden show one). Realisations of different results versions are never mixed.
///
/// 1: revision 61b81ca.
/// 2: a block that stops slipping slips on where sticking would need N <= 0 but slipping keeps the contact.
/// 3: the Lyapunov exponent follows from tangent vectors.
/// 4: the records of a suite have independent random numbers.
inline constexpr std::uint64_t results_version = 4;

}  // namespace rocking
