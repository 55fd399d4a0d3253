#pragma once

#include <string>
#include <string_view>

#include "rocking/figures/figure.hpp"

namespace rocking::analysis {

/// A text in which matplotlib finds no formula.
[[nodiscard]] std::string without_formulas(std::string_view text);

/// A Python string of this text.
[[nodiscard]] std::string python_quoted(const std::string& text);

/// The call that draws a layer on `ax`, with an entry in the legend if `label` is not empty. It uses `tables`,
/// `columns`, `boxes` and `bars` of the script.
[[nodiscard]] std::string matplotlib_call(const Figure& figure, const Layer& layer, const std::string& label);

}  // namespace rocking::analysis
