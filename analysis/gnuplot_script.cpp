#include "analysis/gnuplot_script.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "analysis/data_file.hpp"
#include "analysis/gnuplot_layers.hpp"
#include "analysis/layout.hpp"
#include "rocking/report/text_table.hpp"

namespace rocking::analysis {
namespace {

/// A point of the page in gnuplot's coordinates.
std::string at(const Layout& layout, double x, double y) {
  const auto rounded = [](double share) { return number_text(std::round(share * 1e5) / 1e5); };
  return "screen " + rounded(x / layout.width) + ", screen " + rounded(y / layout.height);
}

std::string size_of(const Layout& layout, double scale) {
  return number_text(std::round(scale * layout.width * 100.0) / 100.0) + ',' +
         number_text(std::round(scale * layout.height * 100.0) / 100.0);
}

// Fonts and sizes are named, and nothing of the day or the machine enters, so that equal data give equal bytes.
std::string terminals(const Figure& figure, const Layout& layout) {
  const std::string stem = in_quotes(figure.name);
  return "  if (format eq 'svg') {\n    set terminal svg enhanced size " + size_of(layout, 1.0) +
         " font 'DejaVu Sans,12' background '#ffffff' name " + stem +
         "\n  }\n  if (format eq 'png') {\n    set terminal pngcairo enhanced size " + size_of(layout, 2.0) +
         " font 'DejaVu Sans,9' fontscale 2 linewidth 2 pointscale 2 background '#ffffff'"
         "\n  }\n  if (format eq 'pdf') {\n    set terminal pdfcairo enhanced size " +
         size_of(layout, 0.01) + " font 'DejaVu Sans,9' linewidth 1 background '#ffffff'\n  }\n  set output " + stem +
         ".'.'.format\n";
}

std::string rectangle(const Layout& layout, const LegendEntry& entry) {
  const std::string place = "  set object rectangle from " + at(layout, entry.left, entry.middle - 6.0) + " to " +
                            at(layout, entry.left + 30.0, entry.middle + 6.0) + " front noclip ";
  std::string text = place + fill_of(entry.style) + '\n';
  if (entry.style.hatch != 0) text += place + hatch_over(entry.style) + '\n';
  return text + place + "fs empty border lc rgb '#606060' lw 0.5\n";
}

std::string stroke(const Layout& layout, const LegendEntry& entry) {
  return "  set arrow from " + at(layout, entry.left, entry.middle) + " to " +
         at(layout, entry.left + 30.0, entry.middle) + " nohead front " + stroke_of(entry.style) + '\n';
}

std::string marker(const Layout& layout, const LegendEntry& entry) {
  return "  set label '' at " + at(layout, entry.left + 15.0, entry.middle) + " point pt " +
         std::to_string(entry.style.marker) + " ps " + number_text(std::max(entry.style.size, 0.6)) + " lc rgb '" +
         entry.style.colour + "' lw " + number_text(entry.style.width) + " front\n";
}

std::string sample(const Layout& layout, const LegendEntry& entry) {
  switch (entry.kind) {
    case LayerKind::boxes:
    case LayerKind::ribbon:
    case LayerKind::spans:
    case LayerKind::image:
    case LayerKind::polygon: return rectangle(layout, entry);
    case LayerKind::line: return stroke(layout, entry) + (entry.style.marker == 0 ? "" : marker(layout, entry));
    case LayerKind::steps:
    case LayerKind::arrows: return stroke(layout, entry);
    case LayerKind::points:
    case LayerKind::error_bars: return marker(layout, entry);
    case LayerKind::texts: return "";
  }
  return "";
}

std::string heading(const Figure& figure, const Layout& layout) {
  std::string text = "  set label " + in_quotes(figure.title) + " at " + at(layout, 0.5 * layout.width, layout.title) +
                     " center noenhanced font ',13' front\n";
  if (!figure.subtitle.empty()) {
    text += "  set label " + in_quotes(figure.subtitle) + " at " + at(layout, 0.5 * layout.width, layout.subtitle) +
            " center noenhanced textcolor rgb '#404040' front\n";
  }
  for (const LegendEntry& entry : layout.legend) {
    text += sample(layout, entry);
    text += "  set label " + in_quotes(entry.text) + " at " + at(layout, entry.left + 37.0, entry.middle) +
            " noenhanced front\n";
  }
  return text;
}

std::string range_of(const Axis& axis) {
  const auto end = [](const std::optional<double>& value) { return value ? number_text(*value) : std::string("*"); };
  return '[' + end(axis.low) + ':' + end(axis.high) + "] noextend";
}

/// Ticks with their words, or without any where the axis shares those of a panel below.
std::string ticks_of(const Axis& axis, bool labelled) {
  if (axis.ticks.empty()) return labelled ? "autofreq format '%g'" : "autofreq format ''";
  std::string text;
  for (const Tick& tick : axis.ticks)
    text += (text.empty() ? "(" : ", ") + in_quotes(labelled ? tick.text : "") + ' ' + number_text(tick.place);
  return text + ')';
}

std::string axis_text(const Axis& axis, const std::string& letter, bool labelled) {
  std::string text = (axis.logarithmic ? "  set logscale " : "  unset logscale ") + letter + '\n';
  text += "  set " + letter + "range " + range_of(axis) + '\n';
  text += "  set " + letter + "tics " + ticks_of(axis, labelled) + " nomirror out\n";
  if (labelled) return text + "  set " + letter + "label " + in_quotes(label_of(axis)) + '\n';
  return text + "  set " + letter + "label\n";
}

/// Widens the ranges of a panel to scale until both axes have the same one.
Panel fitted(Panel panel, const Place& place) {
  const double width = *panel.x.high - *panel.x.low;
  const double height = *panel.y.high - *panel.y.low;
  const double scale = std::max(width / (place.right - place.left), height / (place.top - place.bottom));
  const auto widen = [](Axis& axis, double by) {
    *axis.low -= 0.5 * by;
    *axis.high += 0.5 * by;
  };
  widen(panel.x, scale * (place.right - place.left) - width);
  widen(panel.y, scale * (place.top - place.bottom) - height);
  return panel;
}

/// The least and the largest positive number that the layers of a panel show along an axis; first > second: none.
std::pair<double, double> span_of(const Figure& figure, const Panel& panel, bool along_x) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const Layer& layer : panel.layers) {
    for (std::size_t place = along_x ? 0 : 1; place < (along_x ? 1 : layer.columns.size()); ++place) {
      for (const auto& row : figure.tables[layer.table].rows) {
        const double* number = std::get_if<double>(&row[layer.columns[place]]);
        if (number == nullptr || !(*number > 0.0)) continue;
        least = std::min(least, *number);
        most = std::max(most, *number);
      }
    }
  }
  return {least, most};
}

/// Ticks of a logarithmic axis from `least` to `most`: along a few decades also 2 and 5, along many some of them.
std::vector<Tick> logarithmic_ticks(double least, double most) {
  const bool few = most <= 1e4 * least;
  const int first = static_cast<int>(std::floor(std::log10(least)));
  const int last = static_cast<int>(std::floor(std::log10(most)));
  const int stride = few ? 1 : (last - first) / 6 + 1;
  std::vector<Tick> ticks;
  for (int decade = first; decade <= last; ++decade) {
    if (decade % stride != 0) continue;
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double place = digit * std::pow(10.0, decade);
      if (place < 0.8 * least || 1.25 * most < place || (!few && digit > 1.0)) continue;
      ticks.push_back({place, few ? report::significant(place, 6) : "10^{" + std::to_string(decade) + '}'});
    }
  }
  return ticks;
}

void name_decades(const Figure& figure, Panel& panel) {
  for (Axis* axis : {&panel.x, &panel.y}) {
    if (!axis->logarithmic || !axis->ticks.empty()) continue;
    auto [least, most] = span_of(figure, panel, axis == &panel.x);
    least = axis->low.value_or(least);
    most = axis->high.value_or(most);
    if (least < most) axis->ticks = logarithmic_ticks(least, most);
  }
}

std::string margins(const Layout& layout, const Place& place) {
  const auto share = [](double part, double whole) { return number_text(std::round(part / whole * 1e5) / 1e5); };
  return "  set lmargin at screen " + share(place.left, layout.width) + "\n  set rmargin at screen " +
         share(place.right, layout.width) + "\n  set bmargin at screen " + share(place.bottom, layout.height) +
         "\n  set tmargin at screen " + share(place.top, layout.height) + '\n';
}

std::string axes_text(const Panel& panel, bool with_x) {
  const std::string frame = panel.to_scale ? "  unset border\n" : "  set border 3 lw 0.8\n";
  std::string text = frame + axis_text(panel.x, "x", with_x) + axis_text(panel.y, "y", true);
  if (panel.to_scale) text += "  unset xtics\n  unset ytics\n  set xlabel\n  set ylabel\n";
  return text;
}

std::string plot_text(const Figure& figure, const Panel& panel) {
  std::string text = "  plot ";
  bool first = true;
  for (const Layer& layer : panel.layers) {
    for (const std::string& element : plot_elements(figure, layer)) {
      text += (first ? "" : ", \\\n    ") + element + " notitle";
      first = false;
    }
  }
  return text + '\n';
}

std::string panel_text(const Figure& figure, const Layout& layout, std::size_t number) {
  const Place& place = layout.panels[number];
  const Panel& as_given = figure.panels[number];
  Panel panel = as_given.to_scale ? fitted(as_given, place) : as_given;
  name_decades(figure, panel);
  const bool with_x = figure.arrangement == Arrangement::grid || number + 1 == figure.panels.size();
  return margins(layout, place) + axes_text(panel, with_x) + "  set title " + in_quotes(panel.title) +
         " noenhanced offset 0,-0.6\n" + plot_text(figure, panel) + "  unset label\n  unset object\n  unset arrow\n";
}

/// The logarithm of the largest number of an image; 1 where there is none.
double top_shade(const Figure& figure) {
  double most = 10.0;
  for (const Table& table : figure.tables) {
    if (!table.grid) continue;
    for (const auto& row : table.rows) {
      for (const Cell& cell : row) most = std::max(most, std::get<double>(cell));
    }
  }
  return std::log10(most);
}

}  // namespace

std::string script_text(const Figure& figure) {
  const Layout layout = layout_of(figure);
  std::string text = "# Draws " + figure.name + " from " + figure.name +
                     ".tsv, with gnuplot 5.4 or later:\n#   gnuplot " + figure.name +
                     ".gp\n#   gnuplot -e \"formats='svg'\" " + figure.name + ".gp\n" +
                     "if (!exists(\"formats\")) formats = 'svg png pdf'\nset encoding utf8\ndata = " +
                     in_quotes(figure.name + ".tsv") +
                     "\nset datafile separator tab\nset key off\nset minussign\n"
                     "set offsets graph 0.02, graph 0.02, graph 0.05, graph 0.05\nset y2range [0:1]\n"
                     "unset colorbox\nset palette defined (0 '#b0b0b0', 1 '#000000')\nset cbrange [0:" +
                     number_text(std::round(top_shade(figure) * 1e4) / 1e4) + "]\ndo for [format in formats] {\n";
  text += terminals(figure, layout) + "  set multiplot\n" + heading(figure, layout);
  for (std::size_t i = 0; i < figure.panels.size(); ++i) text += panel_text(figure, layout, i);
  return text + "  unset multiplot\n  set output\n}\n";
}

}  // namespace rocking::analysis
