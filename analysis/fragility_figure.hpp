#pragma once

#include <vector>

#include "analysis/figure.hpp"
#include "rocking/report/json.hpp"

namespace rocking::analysis {

/// What `rocking fragility` found, `fragility`: for each run a panel with the probability of overturning against the
/// intensity, a marker with its exact interval for each level, and the fitted laws with their bands. Throws base::InputError
/// where it is no such file.
[[nodiscard]] std::vector<Figure> fragility_figures(const report::Json& output);

}  // namespace rocking::analysis
