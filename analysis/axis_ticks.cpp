#include "analysis/gnuplot_axes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "rocking/look/text_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

constexpr double most_shared = 3e4;    ///< size of the numbers of an axis over its range: labels of at most 7 letters
constexpr double least_range = 1e-13;  ///< of an axis, relative to its numbers
constexpr double range_of_one = 0.01;  ///< of an axis on both sides of a single number, relative to it
constexpr int digits_of_a_tick = 6;
constexpr double letter_of_a_tick = 7.0;  ///< width in pixels
constexpr std::size_t most_usual_ticks = 9;
const std::string minus_sign = "\xE2\x88\x92";  // U+2212, as gnuplot shows it

struct AxisSpan {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  [[nodiscard]] double width() const { return high - low; }
  [[nodiscard]] double size() const { return std::max(std::abs(low), std::abs(high)); }
  void include(double number) {
    low = std::min(low, number);
    high = std::max(high, number);
  }
};

/// Columns of a layer by their order in it: first and one past the last.
using LayerColumns = std::pair<std::size_t, std::size_t>;

/// Those that give places along an axis.
LayerColumns places_along(const Layer& layer, bool along_x) {
  switch (layer.kind) {
    case LayerKind::boxes: return along_x ? LayerColumns{0, 2} : LayerColumns{2, 4};
    case LayerKind::spans: return {0, along_x ? 2 : 0};
    case LayerKind::image: return {0, 0};
    case LayerKind::line:
    case LayerKind::points:
    case LayerKind::steps:
    case LayerKind::arrows:
    case LayerKind::polygon:
    case LayerKind::texts: return along_x ? LayerColumns{0, 1} : LayerColumns{1, 2};
    case LayerKind::ribbon:
    case LayerKind::error_bars: break;
  }
  return along_x ? LayerColumns{0, 1} : LayerColumns{1, layer.columns.size()};
}

/// The numbers that the layers of a panel show along an axis, of a logarithmic one the positive numbers.
AxisSpan axis_span_of(const Figure& figure, const Panel& panel, bool along_x) {
  const Axis& axis = along_x ? panel.x : panel.y;
  AxisSpan span;
  for (const Layer& layer : panel.layers) {
    const auto [first, end] = places_along(layer, along_x);
    for (std::size_t place = first; place < end; ++place) {
      for (const auto& row : figure.tables[layer.table].rows) {
        const double* number = std::get_if<double>(&row[layer.columns[place]]);
        if (number != nullptr && std::isfinite(*number) && (*number > 0.0 || !axis.logarithmic)) span.include(*number);
      }
    }
  }
  return {.low = axis.low.value_or(span.low), .high = axis.high.value_or(span.high)};
}

/// Along a few decades also 2 and 5, along many some of them.
std::vector<Tick> ticks_of_decades(const AxisSpan& span) {
  const bool few = span.high <= 1e4 * span.low;
  const int first = static_cast<int>(std::floor(std::log10(span.low)));
  const int last = static_cast<int>(std::floor(std::log10(span.high)));
  const int stride = few ? 1 : (last - first) / 6 + 1;
  std::vector<Tick> ticks;
  for (int decade = first; decade <= last; ++decade) {
    if (decade % stride != 0) continue;
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double place = digit * std::pow(10.0, decade);
      if (place < 0.8 * span.low || 1.25 * span.high < place || (!few && digit > 1.0)) continue;
      ticks.push_back({place, few ? significant(place, digits_of_a_tick) : "10^{" + std::to_string(decade) + '}'});
    }
  }
  return ticks;
}

/// Round distance of about so many parts.
double step_within(const AxisSpan& span, double parts) {
  const double decade = std::pow(10.0, std::floor(std::log10(span.width() / parts)));
  const double rest = span.width() / parts / decade;
  return decade * (rest < 1.5 ? 1.0 : rest < 3.5 ? 2.0 : rest < 7.5 ? 5.0 : 10.0);
}

std::string with_minus_sign(const std::string& number) {
  return number.starts_with('-') ? minus_sign + number.substr(1) : number;
}

/// Ticks at multiples of a step from `reference` on, with their difference from it.
std::vector<Tick> ticks_from(double reference, const AxisSpan& span, double parts = 5.0) {
  const double step = step_within(span, parts);
  std::vector<Tick> ticks;
  const auto last = std::llround(std::floor((span.high - reference) / step + 1e-6));
  for (auto i = std::llround(std::ceil((span.low - reference) / step - 1e-6)); i <= last; ++i) {
    const double difference = static_cast<double>(i) * step;
    ticks.push_back({reference + difference, with_minus_sign(significant(difference, digits_of_a_tick))});
  }
  return ticks;
}

/// Letters of ticks beside each other, with the space between them.
double letters_beside(const std::vector<Tick>& ticks, std::size_t count) {
  std::size_t widest = 0;
  for (const Tick& tick : ticks) widest = std::max(widest, letters_in(tick.text));
  return (static_cast<double>(widest) + 1.5) * static_cast<double>(count);
}

/// Fewer ticks along a horizontal axis on which the usual number would overlap.
void thin_out(const AxisSpan& span, double letters, Axis& axis) {
  std::vector<Tick> ticks = ticks_from(0.0, span);
  if (letters_beside(ticks, most_usual_ticks) <= letters) return;
  for (double parts = 4.0; letters_beside(ticks, ticks.size()) > letters && parts >= 1.0; --parts) {
    ticks = ticks_from(0.0, span, parts);
  }
  if (ticks.size() > 1) axis.ticks = std::move(ticks);
}

/// Ticks as differences from a number below the range, which the label names.
void count_from_a_number(const AxisSpan& span, Axis& axis) {
  const double unit = std::pow(10.0, std::ceil(std::log10(span.width())));
  const int digits = static_cast<int>(std::ceil(std::log10(span.size() / unit))) + 1;
  const std::string number = significant(std::floor(span.low / unit) * unit, digits);
  axis.ticks = ticks_from(std::stod(number), span);
  const bool is_negative = number.front() == '-';
  axis.symbol +=
      (axis.symbol.empty() ? "" : " ") + (is_negative ? "+" : minus_sign) + ' ' + number.substr(is_negative ? 1 : 0);
}

void set_ticks(AxisSpan span, Axis& axis) {
  if (!(span.low <= span.high) || !std::isfinite(span.width())) return;
  if (span.width() < least_range * span.size()) {
    axis.low = span.low - range_of_one * span.size();
    axis.high = span.high + range_of_one * span.size();
    span = {.low = *axis.low, .high = *axis.high};
  }
  if (!(span.low < span.high)) return;
  if (span.size() > most_shared * span.width()) {
    count_from_a_number(span, axis);
  } else if (axis.logarithmic && span.low > 0.0) {
    axis.ticks = ticks_of_decades(span);
    const auto is_within = [&span](const Tick& tick) { return span.low <= tick.place && tick.place <= span.high; };
    if (std::ranges::count_if(axis.ticks, is_within) < 2) axis.ticks = ticks_from(0.0, span);
  }
}

}  // namespace

Panel with_ticks(const Figure& figure, Panel panel, double width) {
  for (Axis* axis : {&panel.x, &panel.y}) {
    if (!axis->ticks.empty()) continue;
    const AxisSpan span = axis_span_of(figure, panel, axis == &panel.x);
    set_ticks(span, *axis);
    const bool is_usual = axis->ticks.empty() && !axis->logarithmic && span.low < span.high;
    if (axis == &panel.x && is_usual) thin_out(span, width / letter_of_a_tick, *axis);
  }
  return panel;
}

}  // namespace rocking::analysis
