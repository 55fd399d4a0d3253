#pragma once

#include <string>
#include <vector>

#include "rocking/figures/figure.hpp"

namespace rocking::analysis {

/// `fc ... fs transparent solid ...` of a filled shape; with a hatch there is another to be laid over it.
[[nodiscard]] std::string fill_of(const Style& style);
[[nodiscard]] std::string hatch_over(const Style& style);

/// `lc ... dt ... lw ...`.
[[nodiscard]] std::string stroke_of(const Style& style);

/// What `plot` is given for a layer: one element, or two where a hatch is laid over it.
[[nodiscard]] std::vector<std::string> plot_elements(const Figure& figure, const Layer& layer);

}  // namespace rocking::analysis
