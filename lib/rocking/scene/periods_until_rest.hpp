#pragma once

#include <cstdint>

#include "rocking/scene/experiment.hpp"

namespace rocking {

/// Default number of strobe periods of a run under a base motion that ends: until it ends and the block has come to
/// rest.
///
/// A slender block whose energy is u^2 of that at its balance takes the time 2 artanh(u), in units of 1/p, from one
/// impact to the next; each impact changes u to delta u. From just below balance, u = 0.999, the first hop takes 7.6.
/// All others together take (pi^2/4)/(1 - delta) if delta is near 1. The function uses 8 + 4/(1 - abs(delta)) with
/// delta = 1 - (3/2)(1 + e) sin^2(psi) and the mean of e, at most 4008. Source: Housner (1963), BSSA 53(2) 403-417,
/// Eqs. 5 and 10 (half period and decay), summed.
[[nodiscard]] std::int64_t periods_until_rest(const Scene& scene);

}  // namespace rocking
