#pragma once

#include <vector>

#include "analysis/figure.hpp"
#include "rocking/text/json.hpp"

namespace rocking::analysis {

/// The figures `fragility` of the output of `rocking fragility`: for each run a panel with the overturning probability
/// against the intensity, a marker with its exact interval for each level, and the fitted laws with their bands, or,
/// where a law was rejected, the isotonic estimates as steps with their bands. Throws base::InputError if `output` is
/// no such output.
[[nodiscard]] std::vector<Figure> fragility_figures(const Json& output);

}  // namespace rocking::analysis
