#include "analysis/gnuplot_axes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/figure_scripts.hpp"
#include "analysis/gnuplot_text.hpp"
#include "rocking/look/text_table.hpp"

namespace rocking::analysis {
namespace {

constexpr std::size_t most_letters_of_a_tick = 40;
constexpr std::size_t most_letters_of_a_quantity = 60;

std::string range_of(const Axis& axis) {
  const auto end = [](const std::optional<double>& value) { return value ? number_text(*value) : std::string("*"); };
  return '[' + end(axis.low) + ':' + end(axis.high) + "] noextend";
}

/// Ticks with their words, or without any where the axis shares those of a panel below. Only those of a logarithmic
/// axis have marks of setting, as in `10^{3}`. Numbers have as many digits as tell the ticks of a short axis apart.
std::string ticks_of(const Axis& axis, bool labelled) {
  if (axis.ticks.empty()) return labelled ? "autofreq format '%.10g'" : "autofreq format ''";
  std::string text;
  for (const Tick& tick : axis.ticks) {
    const std::string words = labelled ? cut(printable(tick.text), most_letters_of_a_tick) : "";
    text += (text.empty() ? "(" : ", ") + gnuplot_quoted(without_formats(words)) + ' ' + number_text(tick.place);
  }
  return text + (axis.logarithmic ? ") enhanced" : ") noenhanced");
}

/// As label_of says, with the symbol alone set by its marks.
std::string quoted_label(const Axis& axis) {
  const Axis shown{.quantity = without_marks(cut(printable(axis.quantity), most_letters_of_a_quantity)),
                   .symbol = axis.symbol,
                   .unit = without_marks(axis.unit)};
  return gnuplot_quoted(label_of(shown));
}

std::string axis_text(const Axis& axis, const std::string& letter, bool labelled) {
  std::string text = (axis.logarithmic ? "  set logscale " : "  unset logscale ") + letter + '\n';
  text += "  set " + letter + "range " + range_of(axis) + '\n';
  text += "  set " + letter + "tics " + ticks_of(axis, labelled) + " nomirror out\n";
  if (labelled) return text + "  set " + letter + "label " + quoted_label(axis) + '\n';
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

bool is_finite(const Cell& cell) {
  if (std::holds_alternative<std::string>(cell)) return true;
  const double* number = std::get_if<double>(&cell);
  return number != nullptr && std::isfinite(*number);
}

/// Whether a layer has a row that is drawn.
bool shows_something(const Figure& figure, const Layer& layer) {
  const Table& table = figure.tables.at(layer.table);
  return std::any_of(table.rows.begin(), table.rows.end(), [&layer](const Row& row) {
    return std::all_of(layer.columns.begin(), layer.columns.end(),
                       [&row](std::size_t column) { return is_finite(row.at(column)); });
  });
}

/// Gives an axis a range that gnuplot can draw: of data where `has_data`, otherwise one of its own; never an empty one.
void settle_range(Axis& axis, bool has_data) {
  if (!has_data) {
    if (!axis.low) axis.low = axis.logarithmic ? 1.0 : 0.0;
    if (!axis.high) axis.high = *axis.low + (axis.logarithmic ? 9.0 * *axis.low : 1.0);
  }
  if (axis.low && axis.high && !(*axis.low < *axis.high))
    axis.high = *axis.low + std::max(1.0, 1e-6 * std::abs(*axis.low));
}

}  // namespace

bool shows_nothing(const Figure& figure, const Panel& panel) {
  return std::none_of(panel.layers.begin(), panel.layers.end(),
                      [&figure](const Layer& layer) { return shows_something(figure, layer); });
}

Panel with_settled_axes(const Figure& figure, const Panel& panel, const Place& place) {
  if (panel.to_scale) return fitted(panel, place);
  Panel settled = panel;
  const auto scales_y = [&figure](const Layer& layer) {
    return layer.kind != LayerKind::spans && shows_something(figure, layer);
  };
  settle_range(settled.x, !shows_nothing(figure, panel));
  settle_range(settled.y, std::any_of(panel.layers.begin(), panel.layers.end(), scales_y));
  return with_ticks(figure, std::move(settled), place.right - place.left);
}

std::string axes_text(const Panel& panel, bool with_x) {
  const std::string frame = panel.to_scale ? "  unset border\n" : "  set border 3 lw 0.8\n";
  std::string text = frame + axis_text(panel.x, "x", with_x) + axis_text(panel.y, "y", true);
  if (panel.to_scale) text += "  unset xtics\n  unset ytics\n  set xlabel\n  set ylabel\n";
  return text;
}

}  // namespace rocking::analysis
