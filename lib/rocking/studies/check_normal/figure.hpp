#pragma once

#include "rocking/figures/figure.hpp"
#include "rocking/studies/check_normal/result.hpp"

namespace rocking::analysis {

/// The figure `normal_histogram` of a check of random numbers: counts and the curve of the normal distribution, as in
/// Fig. 2 of Jeong and Yang (2012).
[[nodiscard]] Figure normal_histogram(const SamplerCheck& check);

}  // namespace rocking::analysis
