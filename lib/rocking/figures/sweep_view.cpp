#include "rocking/figures/sweep_view.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

/// How many numbers an entry of the sweep takes; 0 if it takes anything else, or they have names.
std::size_t numbers_taken(const Report& report, std::size_t entry) {
  std::set<double> numbers;
  for (const ReportedCondition& condition : report.conditions) {
    const Parameter& parameter = condition.asked.parameters[entry];
    const auto number = number_in(parameter.value);
    if (!number || !parameter.name.empty()) return 0;
    numbers.insert(*number);
  }
  return numbers.size();
}

std::size_t shown_entry(const Report& report) {
  std::size_t shown = report.swept.size() - 1;
  for (std::size_t i = report.swept.size(); i-- > 0;) {
    if (numbers_taken(report, i) > numbers_taken(report, shown)) shown = i;
  }
  return shown;
}

constexpr std::string_view excitation_place = "/excitation/";

/// The key of an amplitude or a frequency; empty for other parameters, and where the conditions have no shaking.
std::string_view shaking_key(const std::string& pointer, const std::optional<Shaking>& shaking) {
  if (!shaking || !pointer.starts_with(excitation_place)) return {};
  const std::string_view key = std::string_view(pointer).substr(excitation_place.size());
  const auto* const found = std::ranges::find(shaking_numbers, key, &ShakingNumber::key);
  return found == shaking_numbers.end() ? std::string_view() : found->key;
}

/// `1.1 g`, for a number that is swept in another unit.
std::string other_form(const Shaking& shaking, std::string_view key) {
  const std::string_view other = other_form_of(key);
  return with_greek(in_unit(other, significant(number_of(shaking, other), 3)));
}

/// `other_forms`: also of a shaking.
std::string name_of_others(const Report& report, const ReportedCondition& condition, std::size_t shown,
                           bool other_forms) {
  std::string name;
  for (std::size_t i = 0; i < report.swept.size(); ++i) {
    if (i == shown) continue;
    name += (name.empty() ? "" : ", ") + value_in_words(condition.asked.parameters[i]);
    const std::string_view key = shaking_key(report.swept[i], condition.shaking);
    if (other_forms && !key.empty()) name += " = " + other_form(*condition.shaking, key);
  }
  return name;
}

/// With the other forms, if they are the same for all conditions of the slice.
std::string name_of_slice(const Report& report, const Slice& slice, std::size_t shown) {
  const auto name_of = [&](std::size_t condition, bool other_forms) {
    return name_of_others(report, report.conditions[condition], shown, other_forms);
  };
  const std::string name = name_of(slice.conditions.front(), true);
  const bool is_common = std::ranges::all_of(slice.conditions, [&](std::size_t i) { return name_of(i, true) == name; });
  return is_common ? name : name_of(slice.conditions.front(), false);
}

/// What 1 in the unit of `key` is in the other form, as far as all conditions agree: `1 = 0.245 g`. Of a period, what
/// the frequency ratio is.
std::string conversion_text(std::string_view key, Shakings shakings) {
  constexpr double rounding = 1e-9;
  const std::string_view other = other_form_of(key);
  const bool is_period = key == "period_s";
  std::optional<double> factor;
  for (const auto& shaking : shakings) {
    if (!shaking) return "";
    const double number = number_of(*shaking, key);
    if (number == 0.0) continue;
    const double other_number = number_of(*shaking, other);
    const double found = is_period ? other_number * number : other_number / number;
    if (factor && std::abs(found - *factor) > rounding * *factor) return "";
    factor = found;
  }
  if (!factor) return "";
  const std::string digits = significant(*factor, 3);
  if (is_period) return "Ω_h = " + digits + " s/period";
  const bool is_normalised = key == "amplitude" || key == "frequency_ratio";
  return (is_normalised ? "1" : in_unit(key, "1")) + " = " + with_greek(in_unit(other, digits));
}

/// Positions 0, 1, ... for values that are not numbers, with their names as ticks.
void place_by_name(const Report& report, std::size_t shown, SweepView& view) {
  std::map<SweptValue, double> places;
  for (const ReportedCondition& condition : report.conditions) {
    const Parameter& parameter = condition.asked.parameters[shown];
    const auto [found, is_new] = places.try_emplace(parameter.value, static_cast<double>(places.size()));
    if (is_new) view.axis.ticks.push_back({.place = found->second, .text = short_value(parameter)});
    view.x.push_back(found->second);
  }
}

/// The values of all parameters but the shown one, in full: short names may be equal where values differ.
std::string others_in_full(const ReportedCondition& condition, std::size_t shown) {
  std::string values;
  for (std::size_t i = 0; i < condition.asked.parameters.size(); ++i) {
    if (i != shown) values += json_text_of(condition.asked.parameters[i].value) + ' ';
  }
  return values;
}

/// Numbers the slices whose short names are equal.
void tell_apart(std::vector<Slice>& slices) {
  std::map<std::string, std::size_t> seen;
  for (Slice& slice : slices) {
    if (const std::size_t number = ++seen[slice.name]; number > 1) slice.name += " (" + std::to_string(number) + ')';
  }
}

SweepView view_without_sweep(const Report& report) {
  SweepView view;
  view.axis = {.quantity = "the only condition", .ticks = {{.place = 0.0, .text = " "}}};
  view.column = {"condition", "number of the condition"};
  view.x.assign(report.conditions.size(), 0.0);
  view.slices.push_back({.name = "", .conditions = {0}, .axis = view.axis});
  return view;
}

/// As that of all conditions, unless the slice alone has a common conversion.
Axis axis_of_slice(const Report& report, const Slice& slice, std::size_t shown, Axis axis) {
  std::vector<std::optional<Shaking>> shakings;
  for (const std::size_t i : slice.conditions) shakings.push_back(report.conditions[i].shaking);
  axis.unit = axis_of_parameter(report.swept[shown], shakings).unit;
  return axis;
}

}  // namespace

std::string with_greek(std::string text) {
  constexpr std::string_view word = "Omega_h";
  for (auto place = text.find(word); place != std::string::npos; place = text.find(word)) {
    text.replace(place, word.size(), "Ω_h");
  }
  return text;
}

Axis axis_of_parameter(const std::string& pointer) {
  const QuantityName name = quantity_name(pointer);
  return {.quantity = name.quantity, .symbol = name.symbol, .unit = name.unit};
}

Axis axis_of_parameter(const std::string& pointer, Shakings shakings) {
  Axis axis = axis_of_parameter(pointer);
  if (shakings.empty()) return axis;
  const std::string_view key = shaking_key(pointer, shakings.front());
  const std::string conversion = key.empty() ? "" : conversion_text(key, shakings);
  if (!conversion.empty()) axis.unit += (axis.unit.empty() ? "" : "; ") + conversion;
  return axis;
}

std::string name_of_condition(const Report& report, const ReportedCondition& condition) {
  return name_of_others(report, condition, report.swept.size(), true);
}

std::vector<SpanAround> spans_around(const std::vector<double>& places) {
  const std::size_t count = places.size();
  std::vector<SpanAround> spans;
  for (std::size_t i = 0; i < count; ++i) {
    const double below = i > 0 ? places[i] - places[i - 1] : count > 1 ? places[1] - places[0] : 1.0;
    const double above = i + 1 < count ? places[i + 1] - places[i] : below;
    spans.push_back({.low = places[i] - 0.5 * below, .high = places[i] + 0.5 * above});
  }
  return spans;
}

void set_range(const SweepView& view, Panel& panel) {
  const auto [least, most] = std::ranges::minmax_element(view.x);
  const double room = view.is_line ? 0.03 * (*most - *least) : 0.5;
  panel.x.low = *least - room;
  panel.x.high = *most + room;
}

double CategoryBars::shift() const {
  constexpr double widest = 0.6;  // of the distance between categories
  return widest * ((static_cast<double>(number) + 0.5) / static_cast<double>(of) - 0.5);
}

void add_bars(const Table& table, const CategoryBars& bars, Figure& figure) {
  const auto& [value, low, high] = bars.columns;
  Table drawn = drawn_part(table, "bars of " + value + ": ", {table.columns.front().name, value, low, high});
  for (auto& row : drawn.rows) row[0] = std::get<double>(row[0]) + bars.shift();
  const std::size_t place = figure.tables.size();
  draw({.kind = LayerKind::error_bars, .table = place, .style = bars.style}, {}, figure, bars.panel);
  draw({.kind = LayerKind::points, .table = place, .style = bars.style, .legend = bars.legend}, {}, figure, bars.panel);
  figure.tables.push_back(std::move(drawn));
}

SweepView view_of(const Report& report, std::size_t most) {
  if (report.swept.empty()) return view_without_sweep(report);
  SweepView view;
  const std::size_t shown = shown_entry(report);
  view.entry = shown;
  view.axis = axis_of_parameter(report.swept[shown], shakings_of(report));
  view.column = {last_key(report.swept[shown]), label_of(view.axis)};
  view.is_line = numbers_taken(report, shown) > 1;
  if (numbers_taken(report, shown) > 0) {
    for (const ReportedCondition& condition : report.conditions) {
      view.x.push_back(number_in(condition.asked.parameters[shown].value).value());
    }
  } else {
    if (!report.conditions.front().asked.parameters[shown].name.empty()) view.axis = {.quantity = view.axis.quantity};
    place_by_name(report, shown, view);
  }
  std::map<std::string, std::size_t> known;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const auto [found, is_new] = known.try_emplace(others_in_full(report.conditions[i], shown), view.slices.size());
    if (is_new) view.slices.push_back({.name = {}, .conditions = {}});
    view.slices[found->second].conditions.push_back(i);
  }
  view.all_slices = view.slices.size();
  if (view.slices.size() > most) view.slices.resize(most);
  for (Slice& slice : view.slices) {
    slice.name = name_of_slice(report, slice, shown);
    slice.axis = axis_of_slice(report, slice, shown, view.axis);
    std::stable_sort(slice.conditions.begin(), slice.conditions.end(),
                     [&view](std::size_t a, std::size_t b) { return view.x[a] < view.x[b]; });
  }
  tell_apart(view.slices);
  return view;
}

std::string slices_left_out(const SweepView& view) {
  if (view.slices.size() >= view.all_slices) return "";
  return " Of " + std::to_string(view.all_slices) + " combinations of the other parameters the first " +
         std::to_string(view.slices.size()) + " are drawn; tables have all.";
}

std::string values_in_words(const std::vector<Parameter>& others) {
  std::string words;
  for (const Parameter& other : others) words += (words.empty() ? "" : ", ") + value_in_words(other);
  return words;
}

}  // namespace rocking::analysis
