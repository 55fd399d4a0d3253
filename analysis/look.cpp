#include "analysis/look.hpp"

#include <algorithm>
#include <string>

namespace rocking::analysis {
namespace {

constexpr double pixels_of_a_millimetre = 96.0 / 25.4;
constexpr double narrower = 0.7;                     // lines of a layer, since the figure is smaller
constexpr double thinnest_line = 0.5 * 96.0 / 72.0;  // 0.5 points, in pixels

}  // namespace

FigureLook screen_look() { return {}; }

FigureLook journal_look(JournalWidth width) {
  const bool is_single = width == JournalWidth::single_column;
  return {.style = FigureStyle::journal,
          .width = (is_single ? 84.0 : 174.0) * pixels_of_a_millimetre,
          .pdf_inches = 1.0 / 96.0,
          .png_pixels = 600.0 / 96.0,
          .font_size = 8.0,
          .letter_width = 6.6,
          .line_height = 17.0,
          .sample_width = 24.0,
          .left_margin = 62.0,
          .wide_left_margin = 78.0,
          .right_margin = 12.0,
          .below_axes = 60.0,
          .above_axes = 22.0,
          .above_figure = 4.0,
          .most_columns = is_single ? 1 : 3,
          .axes_heights = {is_single ? 180.0 : 280.0, 180.0, 130.0},
          .stacked_height = 120.0};
}

Figure adapted(Figure figure, const FigureLook& look) {
  if (look.style == FigureStyle::screen) return figure;
  figure.title.clear();
  figure.subtitle.clear();
  const bool has_letters = figure.arrangement == Arrangement::grid && figure.panels.size() > 1;
  char letter = 'a';
  for (Panel& panel : figure.panels) {
    if (has_letters && letter <= 'z') panel.title = std::string("(") + letter++ + ") " + panel.title;
    for (Layer& layer : panel.layers) {
      layer.style.width = std::max(narrower * layer.style.width, thinnest_line);
    }
  }
  return figure;
}

}  // namespace rocking::analysis
