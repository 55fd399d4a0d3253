#pragma once

#include <cstdint>

#include "rocking/experiment/experiment.hpp"

namespace rocking::report {

/// Strobe periods that a run under a record takes by default: until the record ends, and the block has come to rest.
///
/// A slender block whose energy is u^2 of that which it has at its balance takes 2 artanh(u) from one impact to the next,
/// in units of 1/p, and each impact turns u into delta u. Started just short of balance, u = 0.999, it takes 7.6 for the
/// first hop and (pi^2/4)/(1 - delta) for all others together, if delta is near 1. Taken here: 8 + 4/(1 - abs(delta)) with
/// delta = 1 - (3/2)(1 + e) sin^2(psi), the mean of e, and at most 4008.
/// Source: Housner (1963), BSSA 53(2) 403-417, Eqs. 5 and 10 (half period and decay), summed.
[[nodiscard]] std::int64_t periods_under_record(const experiment::Scene& scene);

}  // namespace rocking::report
