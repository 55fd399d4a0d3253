#include "analysis/layout.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

#include "analysis/gnuplot_text.hpp"
#include "rocking/look/text_table.hpp"

namespace rocking::analysis {
namespace {

constexpr std::size_t letters_of_a_legend = 80;
constexpr double height_of_a_further_line = 0.85;  // of a title or a legend entry, in the height of a line
constexpr double gap_of_a_sample = 12.0;           // between the sample of a legend entry and its text
constexpr double gap_of_an_entry = 18.0;
constexpr std::size_t most_letters_of_a_margin = 40;  // that are written beside a y axis

std::size_t longest_of(const std::vector<std::string>& lines) {
  std::size_t most = 0;
  for (const std::string& line : lines) most = std::max(most, letters_in(line));
  return most;
}

double height_of(std::size_t lines, const FigureLook& look) {
  return look.line_height * (1.0 + height_of_a_further_line * static_cast<double>(lines - 1));
}

/// Each legend entry once, in the order of the panels.
std::vector<LegendEntry> entries_of(const Figure& figure, const FigureLook& look) {
  const double room = look.width - look.sample_width - gap_of_a_sample - gap_of_an_entry;
  const std::size_t letters = std::min(letters_of_a_legend, static_cast<std::size_t>(room / look.letter_width));
  std::vector<LegendEntry> entries;
  for (const Panel& panel : figure.panels) {
    for (const Layer& layer : panel.layers) {
      const std::vector<std::string> lines = wrapped(printable(layer.legend), letters);
      const auto same = [&lines](const LegendEntry& entry) { return entry.lines == lines; };
      if (layer.legend.empty() || std::any_of(entries.begin(), entries.end(), same)) continue;
      entries.push_back({.kind = layer.kind, .style = layer.style, .lines = lines, .left = 0.0, .middle = 0.0});
    }
  }
  return entries;
}

/// Arranges the entries in centred rows with as many entries as fit; `top` is measured from the top of the figure.
/// Returns the height of the rows.
double set_in_rows(std::vector<LegendEntry>& entries, double top, const FigureLook& look) {
  const double widest = look.width - (look.style == FigureStyle::screen ? 30.0 : 0.0);
  const double begin = top;
  std::size_t lines = 1;
  for (std::size_t first = 0; first < entries.size(); top += height_of(lines, look)) {
    double width = 0.0;
    lines = 1;
    std::size_t last = first;
    for (; last < entries.size(); ++last) {
      const double wanted = look.sample_width + gap_of_a_sample +
                            look.letter_width * static_cast<double>(longest_of(entries[last].lines)) + gap_of_an_entry;
      if (last > first && width + wanted > widest) break;
      lines = std::max(lines, entries[last].lines.size());
      entries[last].left = width;
      entries[last].middle = top + 0.5 * look.line_height;
      width += wanted;
    }
    for (; first < last; ++first) entries[first].left += std::max(8.0, 0.5 * (look.width - width + gap_of_an_entry));
  }
  return top - begin;
}

/// Space for the label of a y axis beside the words at its ticks.
constexpr double margin_of_a_label = 30.0;

double left_margin_of(const Figure& figure, const FigureLook& look) {
  double margin = figure.arrangement == Arrangement::stacked ? look.wide_left_margin : look.left_margin;
  for (const Panel& panel : figure.panels) {
    for (const Tick& tick : panel.y.ticks) {
      const auto letters = static_cast<double>(std::min(letters_in(printable(tick.text)), most_letters_of_a_margin));
      margin = std::max(margin, margin_of_a_label + look.letter_width * letters);
    }
  }
  return margin;
}

int columns_for(const Figure& figure, const FigureLook& look) {
  const std::size_t panels = figure.panels.size();
  if (figure.arrangement == Arrangement::stacked || panels < 2) return 1;
  return std::min(look.most_columns, panels <= 4 ? 2 : 3);
}

double height_of_axes(const Figure& figure, int columns, const FigureLook& look) {
  if (figure.arrangement == Arrangement::stacked && figure.panels.size() > 1) return look.stacked_height;
  return look.axes_heights.at(static_cast<std::size_t>(columns - 1));
}

/// Height above the axes of the panels of a row; `place` has the width of one.
double above_panels(std::span<const Panel> row, const Place& place, const FigureLook& look) {
  double height = 8.0;
  for (const Panel& panel : row) {
    if (panel.title.empty()) continue;
    const double further = height_of(title_lines(panel, place, look).size(), look) - height_of(1, look);
    height = std::max(height, look.above_axes + further);
  }
  return height;
}

/// Arranges panels in rows below `top`. Returns the end of the last row; both are measured from the top of the figure.
double place_panels(const Figure& figure, double top, const FigureLook& look, std::vector<Place>& places) {
  const double columns = columns_for(figure, look);
  const double before_axes = left_margin_of(figure, look);
  const double axes_width = (look.width - columns * (before_axes + look.right_margin)) / columns;
  const double axes_height = height_of_axes(figure, columns_for(figure, look), look);
  const bool joined = figure.arrangement == Arrangement::stacked;
  double left = before_axes;
  double above = 0.0;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const bool last = i + 1 == figure.panels.size();
    const bool row_ends = last || std::fmod(static_cast<double>(i) + 1.0, columns) == 0.0;
    Place place{.left = left, .right = left + axes_width, .bottom = 0.0, .top = 0.0};
    if (left == before_axes) {
      const auto first = figure.panels.begin() + static_cast<std::ptrdiff_t>(i);
      const auto in_row = std::min(static_cast<std::size_t>(columns), figure.panels.size() - i);
      above = above_panels({first, first + static_cast<std::ptrdiff_t>(in_row)}, place, look);
    }
    place.top = top + above;
    const double end = place.top + axes_height * figure.panels[i].height;
    place.bottom = end;
    places.push_back(place);
    left += axes_width + before_axes + look.right_margin;
    if (!row_ends) continue;
    left = before_axes;
    top = end + (joined && !last ? 6.0 : look.below_axes);
  }
  return top;
}

}  // namespace

LettersOfPanel letters_of(const Place& panel, const FigureLook& look) {
  const double width = panel.right - panel.left;
  const auto letters = [&look](double length) { return static_cast<std::size_t>(length / look.letter_width); };
  // Labels are centred on their axis and may be longer than it.
  return {.x = letters(width + 2.0 * look.right_margin), .y = letters(panel.top - panel.bottom + look.below_axes)};
}

std::vector<std::string> title_lines(const Panel& panel, const Place& place, const FigureLook& look) {
  const double width = place.right - place.left + look.left_margin + look.right_margin;
  return wrapped(printable(panel.title), static_cast<std::size_t>(width / look.letter_width));
}

Layout layout_of(const Figure& figure, const FigureLook& look) {
  Layout layout{.width = look.width, .height = 0.0, .title = 18.0, .subtitle = 38.0, .panels = {}, .legend = {}};
  layout.legend = entries_of(figure, look);
  double top = look.above_figure + (figure.subtitle.empty() ? 0.0 : 20.0);
  top += set_in_rows(layout.legend, top, look) + 4.0;
  layout.height = std::ceil(place_panels(figure, top, look, layout.panels));
  for (double* height : {&layout.title, &layout.subtitle}) *height = layout.height - *height;
  for (LegendEntry& entry : layout.legend) entry.middle = layout.height - entry.middle;
  for (Place& place : layout.panels) {
    place.bottom = layout.height - place.bottom;
    place.top = layout.height - place.top;
  }
  return layout;
}

}  // namespace rocking::analysis
