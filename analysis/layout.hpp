#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/figure.hpp"

/// Where the parts of a drawn figure stand, in pixels from its lower left corner.
namespace rocking::analysis {

struct Place {
  double left, right, bottom, top;
};

/// A sample of a layer's look and the words beside it.
struct LegendEntry {
  LayerKind kind;
  Style style;
  std::string text;
  double left;    ///< of the sample
  double middle;  ///< height of the line it stands on
};

struct Layout {
  double width, height;
  double title, subtitle;     ///< middles of their lines
  std::vector<Place> panels;  ///< within the axes
  std::vector<LegendEntry> legend;
};

/// How many characters of a line across the figure, and of a panel's title, there is room for.
inline constexpr std::size_t letters_across = 97;
[[nodiscard]] std::size_t letters_above(const Place& panel);

[[nodiscard]] Layout layout_of(const Figure& figure);

}  // namespace rocking::analysis
