#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/look.hpp"
#include "rocking/figures/figure.hpp"

/// Positions of the parts of a drawn figure, in pixels from its lower left corner.
namespace rocking::analysis {

struct Place {
  double left, right, bottom, top;
};

/// A sample of the style of a layer and its text.
struct LegendEntry {
  LayerKind kind;
  Style style;
  std::vector<std::string> lines;
  double left;    ///< of the sample
  double middle;  ///< height of the centre of its first line
};

struct Layout {
  double width, height;
  double title, subtitle;     ///< heights of the centres of their lines
  std::vector<Place> panels;  ///< within the axes
  std::vector<LegendEntry> legend;
};

/// Number of characters that fit into a line across the figure.
inline constexpr std::size_t letters_across = 97;

/// Number of characters that fit along the axes of a panel.
struct LettersOfPanel {
  std::size_t x, y;
};

[[nodiscard]] LettersOfPanel letters_of(const Place& panel, const FigureLook& look);

/// The title of a panel in lines that fit above it.
[[nodiscard]] std::vector<std::string> title_lines(const Panel& panel, const Place& place, const FigureLook& look);

[[nodiscard]] Layout layout_of(const Figure& figure, const FigureLook& look);

}  // namespace rocking::analysis
