#pragma once

#include "rocking/figures/figure.hpp"
#include "rocking/studies/fragility/result.hpp"

namespace rocking::analysis {

/// The figure `fragility`: for each run a panel with the overturning probability against the intensity, a marker with its
/// exact interval for each level, and the fitted laws with their bands, or, where a law was rejected, the isotonic
/// estimates as steps with their bands.
[[nodiscard]] Figure fragility_figure(const FragilityReport& report);

}  // namespace rocking::analysis
