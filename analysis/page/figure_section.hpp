#pragma once

#include <string>

#include "analysis/figure.hpp"
#include "rocking/output/report.hpp"

namespace rocking::analysis {

/// Largest number of panels of a figure that are drawn as charts; the picture and the data files have all of them.
inline constexpr std::size_t most_charts = 24;

/// Largest number of rows of a figure that is drawn as charts, and largest size in bytes of an embedded picture.
inline constexpr std::size_t most_charted_rows = 20'000;
inline constexpr std::size_t most_picture_bytes = 2'000'000;

/// A figure and its picture.
struct DrawnFigure {
  Figure figure;
  std::string svg;  ///< empty if it could not be drawn
};

/// HTML of a figure: charts for the script of the page; the picture for printing and for pages without scripts; a
/// description in words for readers who see neither; and the numbers as a table.
[[nodiscard]] std::string figure_html(const Report& report, const DrawnFigure& drawn);

}  // namespace rocking::analysis
