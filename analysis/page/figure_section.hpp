#pragma once

#include <string>

#include "rocking/figures/figure.hpp"
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

/// HTML of a figure: charts for the script of the page; the picture for printing and for pages without scripts.
/// `below`: HTML below its caption.
[[nodiscard]] std::string figure_html(const DrawnFigure& drawn, const std::string& below = "");

/// HTML of the numbers of a figure.
[[nodiscard]] std::string tables_html(const Report& report, const Figure& figure);

/// HTML of a figure with its description in words and its numbers; folded if it has many panels or curves.
[[nodiscard]] std::string figure_with_tables_html(const Report& report, const DrawnFigure& drawn);

}  // namespace rocking::analysis
