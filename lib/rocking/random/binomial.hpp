#pragma once

#include <cstdint>

#include "rocking/random/draws.hpp"

namespace rocking::random {

/// The number of successes in `trials` <= 10^9 independent trials with the same probability, 0 to 1.
///
/// Takes three of the engine's numbers on average; the time does not grow with the trials. The same bits on every
/// machine. The relative error of the probability of an outcome is about trials 2^-52.
/// Source: Hormann (1993), The generation of binomial random variates, J. Stat. Comput. Simul. 46, 101-110, algorithm
/// BTRS; inversion where fewer than ten successes or failures are expected.
[[nodiscard]] std::uint64_t binomial(PhiloxEngine& bits, std::uint64_t trials, double probability);

}  // namespace rocking::random
