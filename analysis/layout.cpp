#include "analysis/layout.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/gnuplot_text.hpp"
#include "rocking/output/text_table.hpp"

namespace rocking::analysis {
namespace {

constexpr double full_width = 720.0;
constexpr double line_height = 21.0;
constexpr double letter_width = 7.4;   // mean width of a letter, slightly larger than that of DejaVu Sans at 12
constexpr double sample_width = 42.0;  // of a legend entry, including the gap before its text
constexpr std::size_t letters_of_a_legend = 80;
constexpr double left_margin = 84.0;
constexpr double wide_left_margin = 100.0;  // space for the ticks of a nearly constant slip: -0.00486
constexpr double right_margin = 18.0;
constexpr double below_axes = 68.0;
constexpr double above_axes = 26.0;

/// Each legend entry once, in the order of the panels.
std::vector<LegendEntry> entries_of(const Figure& figure) {
  std::vector<LegendEntry> entries;
  for (const Panel& panel : figure.panels) {
    for (const Layer& layer : panel.layers) {
      const std::string text = cut(printable(layer.legend), letters_of_a_legend);
      const auto same = [&text](const LegendEntry& entry) { return entry.text == text; };
      if (layer.legend.empty() || std::any_of(entries.begin(), entries.end(), same)) continue;
      entries.push_back({.kind = layer.kind, .style = layer.style, .text = text, .left = 0.0, .middle = 0.0});
    }
  }
  return entries;
}

/// Arranges the entries in centred rows with as many entries as fit; `top` is measured from the top of the figure.
/// Returns the height of the rows.
double set_in_rows(std::vector<LegendEntry>& entries, double top) {
  constexpr double widest = full_width - 30.0;
  const double begin = top;
  for (std::size_t first = 0; first < entries.size(); top += line_height) {
    double width = 0.0;
    std::size_t last = first;
    for (; last < entries.size(); ++last) {
      const double wanted = sample_width + letter_width * static_cast<double>(letters_in(entries[last].text)) + 18.0;
      if (last > first && width + wanted > widest) break;
      entries[last].left = width;
      entries[last].middle = top + 0.5 * line_height;
      width += wanted;
    }
    for (; first < last; ++first) entries[first].left += std::max(8.0, 0.5 * (full_width - width + 18.0));
  }
  return top - begin;
}

double left_margin_of(const Figure& figure) {
  return figure.arrangement == Arrangement::stacked ? wide_left_margin : left_margin;
}

double columns_for(const Figure& figure) {
  const std::size_t panels = figure.panels.size();
  if (figure.arrangement == Arrangement::stacked || panels < 2) return 1.0;
  return panels <= 4 ? 2.0 : 3.0;
}

double height_of_axes(const Figure& figure, double columns) {
  if (figure.arrangement == Arrangement::stacked && figure.panels.size() > 1) return 150.0;
  return columns == 1.0 ? 330.0 : columns == 2.0 ? 240.0 : 170.0;
}

/// Arranges panels in rows below `top`. Returns the end of the last row; both are measured from the top of the figure.
double place_panels(const Figure& figure, double top, std::vector<Place>& places) {
  const double columns = columns_for(figure);
  const double before_axes = left_margin_of(figure);
  const double axes_width = (full_width - columns * (before_axes + right_margin)) / columns;
  const double axes_height = height_of_axes(figure, columns);
  const bool joined = figure.arrangement == Arrangement::stacked;
  double left = before_axes;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const Panel& panel = figure.panels[i];
    const bool last = i + 1 == figure.panels.size();
    const bool row_ends = last || std::fmod(static_cast<double>(i) + 1.0, columns) == 0.0;
    const double begin = top + (panel.title.empty() ? 8.0 : above_axes);
    const double end = begin + axes_height * panel.height;
    places.push_back({.left = left, .right = left + axes_width, .bottom = end, .top = begin});
    left += axes_width + before_axes + right_margin;
    if (!row_ends) continue;
    left = before_axes;
    top = end + (joined && !last ? 6.0 : below_axes);
  }
  return top;
}

}  // namespace

static_assert(static_cast<double>(letters_across) <= full_width / letter_width);

std::size_t letters_above(const Place& panel) {
  return static_cast<std::size_t>((panel.right - panel.left + left_margin + right_margin) / letter_width);
}

Layout layout_of(const Figure& figure) {
  Layout layout{.width = full_width, .height = 0.0, .title = 18.0, .subtitle = 38.0, .panels = {}, .legend = {}};
  layout.legend = entries_of(figure);
  double top = figure.subtitle.empty() ? 32.0 : 52.0;
  top += set_in_rows(layout.legend, top) + 4.0;
  layout.height = std::ceil(place_panels(figure, top, layout.panels));
  for (double* height : {&layout.title, &layout.subtitle}) *height = layout.height - *height;
  for (LegendEntry& entry : layout.legend) entry.middle = layout.height - entry.middle;
  for (Place& place : layout.panels) {
    place.bottom = layout.height - place.bottom;
    place.top = layout.height - place.top;
  }
  return layout;
}

}  // namespace rocking::analysis
