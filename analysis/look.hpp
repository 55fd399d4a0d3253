#pragma once

#include <array>
#include <cstdint>

#include "rocking/figures/figure.hpp"

namespace rocking::analysis {

/// For what a figure is drawn: pages and slides, or the column of a journal.
enum class FigureStyle : std::uint8_t { screen, journal };

enum class JournalWidth : std::uint8_t { single_column, double_column };

/// Sizes of a drawn figure. Lengths are in pixels of 1/96 inch, font sizes in points of 1/72 inch.
struct FigureLook {
  FigureStyle style = FigureStyle::screen;
  double width = 720.0;
  double pdf_inches = 0.01;  ///< of a pixel in the PDF
  double png_pixels = 2.0;   ///< of a pixel along a side in the PNG
  double font_size = 9.0;
  double letter_width = 7.4;   ///< mean width of a letter, slightly larger than that of DejaVu Sans
  double line_height = 21.0;   ///< of the legend
  double sample_width = 30.0;  ///< of a stroke or rectangle in the legend
  double left_margin = 84.0;
  double wide_left_margin = 100.0;  ///< space for the ticks of a nearly constant slip: -0.00486
  double right_margin = 18.0;
  double below_axes = 68.0;
  double above_axes = 26.0;
  double above_figure = 32.0;  ///< from the top to the legend: the title, without a subtitle
  int most_columns = 3;        ///< of panels
  std::array<double, 3> axes_heights = {330.0, 240.0, 170.0};  ///< of panels in one, two, three columns
  double stacked_height = 150.0;                               ///< of the axes of one of several stacked panels
};

[[nodiscard]] FigureLook screen_look();

/// 84 mm (single) or 174 mm (double column) wide, without title and subtitle, all text in 8 points except subscripts,
/// no line thinner than 0.5 points, PNG with 600 pixels per inch. These widths fit the columns of Springer (84 and 174
/// mm) and of Elsevier (90 and 190 mm).
[[nodiscard]] FigureLook journal_look(JournalWidth width);

/// The figure as this look shows it: for a journal without title and subtitle, panels of a grid lettered (a), (b), ...,
/// and no line of a layer thinner than 0.5 points.
[[nodiscard]] Figure adapted(Figure figure, const FigureLook& look);

}  // namespace rocking::analysis
