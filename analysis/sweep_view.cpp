#include "analysis/sweep_view.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "rocking/output/mode_table.hpp"
#include "rocking/text/json.hpp"

namespace rocking::analysis {
namespace {

/// How many numbers an entry of the sweep takes; 0 if it takes anything else.
std::size_t numbers_taken(const RunReport& report, std::size_t entry) {
  std::set<double> numbers;
  for (const ConditionReport& condition : report.conditions) {
    if (!condition.parameters[entry].is_number()) return 0;
    numbers.insert(condition.parameters[entry].get<double>());
  }
  return numbers.size();
}

std::size_t shown_entry(const RunReport& report) {
  std::size_t shown = report.swept.size() - 1;
  for (std::size_t i = report.swept.size(); i-- > 0;) {
    if (numbers_taken(report, i) > numbers_taken(report, shown)) shown = i;
  }
  return shown;
}

std::string name_of_others(const RunReport& report, const ConditionReport& condition, std::size_t shown) {
  std::string name;
  for (std::size_t i = 0; i < report.swept.size(); ++i) {
    if (i == shown) continue;
    const Axis axis = axis_of_parameter(report.swept[i]);
    name += (name.empty() ? "" : ", ") + axis.quantity + ' ' + short_value(report.swept[i], condition.parameters[i]);
    if (!axis.unit.empty()) name += ' ' + axis.unit;
  }
  return name;
}

/// Positions 0, 1, ... for values that are not numbers, with their names as ticks.
void place_by_name(const RunReport& report, std::size_t shown, SweepView& view) {
  std::map<std::string, double> places;
  for (const ConditionReport& condition : report.conditions) {
    const std::string name = short_value(report.swept[shown], condition.parameters[shown]);
    const auto [found, is_new] = places.try_emplace(name, static_cast<double>(places.size()));
    if (is_new) view.axis.ticks.push_back({.place = found->second, .text = name});
    view.x.push_back(found->second);
  }
}

SweepView view_without_sweep(const RunReport& report) {
  SweepView view;
  view.axis = {.quantity = "the only condition", .symbol = "", .unit = "", .ticks = {{.place = 0.0, .text = " "}}};
  view.column = {"condition", "number of the condition"};
  view.x.assign(report.conditions.size(), 0.0);
  view.slices.push_back({.name = "", .conditions = {0}});
  return view;
}

}  // namespace

Axis axis_of_parameter(const std::string& pointer) {
  static const std::map<std::string, Axis> known{{"/excitation/amplitude", {"base amplitude", "A_h", ""}},
                                                 {"/excitation/frequency_ratio", {"frequency ratio", "Ω_h", ""}},
                                                 {"/excitation/phase_rad", {"phase", "Φ", "rad"}},
                                                 {"/excitation/scale", {"scale of the ground motion", "", ""}},
                                                 {"/friction/static", {"static friction", "μ_s", ""}},
                                                 {"/friction/kinetic", {"kinetic friction", "μ_k", ""}},
                                                 {"/friction", {"friction", "μ_s/μ_k", ""}},
                                                 {"/restitution", {"restitution", "e", ""}},
                                                 {"/block/width_m", {"width", "B", "m"}},
                                                 {"/block/height_m", {"height", "H", "m"}},
                                                 {"/initial/tilt", {"initial tilt", "Θ_0", ""}},
                                                 {"/initial/tilt_rate", {"initial tilt rate", "Θ′_0", ""}},
                                                 {"/initial/slip_rate", {"initial slip rate", "V_0", ""}}};
  if (const auto found = known.find(pointer); found != known.end()) return found->second;
  const std::string key = last_key(pointer);
  if (key == "sigma" || key == "relative_sigma") {
    const std::string whole = pointer.substr(0, pointer.rfind('/'));
    std::string of = last_key(whole);
    std::replace(of.begin(), of.end(), '_', ' ');
    return {.quantity = (key == "sigma" ? "standard deviation of " : "relative standard deviation of ") + of,
            .symbol = "σ",
            .unit = ""};
  }
  std::string words = key;
  std::replace(words.begin(), words.end(), '_', ' ');
  return {.quantity = words, .symbol = "", .unit = ""};
}

std::string name_of_condition(const RunReport& report, const ConditionReport& condition) {
  return name_of_others(report, condition, report.swept.size());
}

std::string short_value(const std::string& pointer, const Json& value) {
  return rocking::short_value({.pointer = pointer, .value = value.dump()});
}

std::vector<Stretch> stretches_of(const std::vector<double>& places) {
  const std::size_t count = places.size();
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < count; ++i) {
    const double below = i > 0 ? places[i] - places[i - 1] : count > 1 ? places[1] - places[0] : 1.0;
    const double above = i + 1 < count ? places[i + 1] - places[i] : below;
    stretches.push_back({.low = places[i] - 0.5 * below, .high = places[i] + 0.5 * above});
  }
  return stretches;
}

SweepView view_of(const RunReport& report) {
  if (report.swept.empty()) return view_without_sweep(report);
  SweepView view;
  const std::size_t shown = shown_entry(report);
  view.axis = axis_of_parameter(report.swept[shown]);
  view.column = {last_key(report.swept[shown]), label_of(view.axis)};
  view.is_line = numbers_taken(report, shown) > 1;
  if (numbers_taken(report, shown) > 0) {
    for (const ConditionReport& condition : report.conditions) {
      view.x.push_back(condition.parameters[shown].get<double>());
    }
  } else {
    place_by_name(report, shown, view);
  }
  std::map<std::string, std::size_t> known;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const std::string name = name_of_others(report, report.conditions[i], shown);
    const auto [found, is_new] = known.try_emplace(name, view.slices.size());
    if (is_new) view.slices.push_back({.name = name, .conditions = {}});
    view.slices[found->second].conditions.push_back(i);
  }
  if (view.slices.size() > most_slices) view.slices.resize(most_slices);
  for (Slice& slice : view.slices) {
    std::stable_sort(slice.conditions.begin(), slice.conditions.end(),
                     [&view](std::size_t a, std::size_t b) { return view.x[a] < view.x[b]; });
  }
  return view;
}

}  // namespace rocking::analysis
