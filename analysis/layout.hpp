#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "analysis/look.hpp"

/// Positions of the parts of a drawn figure, in pixels from its lower left corner.
namespace rocking::analysis {

struct Place {
  double left, right, bottom, top;
};

/// A sample of the style of a layer and its text.
struct LegendEntry {
  LayerKind kind;
  Style style;
  std::string text;
  double left;    ///< of the sample
  double middle;  ///< height of the centre of its line
};

struct Layout {
  double width, height;
  double title, subtitle;     ///< heights of the centres of their lines
  std::vector<Place> panels;  ///< within the axes
  std::vector<LegendEntry> legend;
};

/// Number of characters that fit into a line across the figure.
inline constexpr std::size_t letters_across = 97;

/// Number of characters that fit into the title of a panel, and along its axes.
struct LettersOfPanel {
  std::size_t title, x, y;
};

[[nodiscard]] LettersOfPanel letters_of(const Place& panel, const FigureLook& look);

[[nodiscard]] Layout layout_of(const Figure& figure, const FigureLook& look);

}  // namespace rocking::analysis
