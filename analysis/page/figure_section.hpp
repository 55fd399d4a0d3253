#pragma once

#include <string>

#include "analysis/figure.hpp"
#include "analysis/run_report.hpp"

namespace rocking::analysis {

/// Panels of a figure that a page draws as charts at most; its picture and its data files have them all.
inline constexpr std::size_t most_charts = 24;

/// Rows of a figure that a page draws as a chart, and bytes of a picture that it holds, at most.
inline constexpr std::size_t most_charted_rows = 20'000;
inline constexpr std::size_t most_picture_bytes = 2'000'000;

/// A figure and its picture.
struct DrawnFigure {
  Figure figure;
  std::string svg;  ///< empty where it could not be drawn
};

/// A figure of a page: charts for the page's script, the picture for paper and for pages without scripts, words for who
/// cannot see either, and its numbers as a table.
[[nodiscard]] std::string figure_html(const RunReport& report, const DrawnFigure& drawn);

}  // namespace rocking::analysis
