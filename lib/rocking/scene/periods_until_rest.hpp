#pragma once

#include <cstdint>

#include "rocking/scene/experiment.hpp"

namespace rocking {

/// Default number of strobe periods of a run under a base motion that ends: until it ends and the block has come to
/// rest.
///
/// A slender block whose energy is u^2 of that at its balance takes the time 2 artanh(u), in units of 1/p, from one
/// impact to the next; each impact changes u to delta u. From just below balance, u = 0.999, the first hop takes 7.6.
/// All others together take at most (pi^2/4)/(1 - delta), its limit for delta to 1. The function uses
/// 8 + 4/(1 - abs(delta)) with delta = 1 - (3/2)(1 + e) sin^2(psi) and the mean of e. The 4 in place of 2.47 leaves room
/// for impacts that lose less than the mean, down to 0.62 of the loss. A loss below 1e-3 counts as 1e-3, at most 4008 in
/// all: with e = 0 that of a block more slender than 39 to 1. Source: Housner (1963), BSSA 53(2) 403-417, Eqs. 5 and 10
/// (half period and decay), summed.
[[nodiscard]] std::int64_t periods_until_rest(const Scene& scene);

}  // namespace rocking
