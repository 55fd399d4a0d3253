#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "rocking/figures/figure.hpp"
#include "rocking/output/report.hpp"
#include "rocking/output/shaking_text.hpp"

/// Selection of the swept parameter on the x axis, and of the curves or panels.
namespace rocking::analysis {

/// Conditions that differ in the shown parameter only.
struct Slice {
  std::string name;                     ///< values of the other parameters; empty if there are none
  std::vector<std::size_t> conditions;  ///< indices in the report, by increasing `x`
  Axis axis = {};                       ///< of the shown parameter, with the other form of the shaking in this slice

  [[nodiscard]] std::string words() const { return name.empty() ? "all conditions" : name; }
};

/// Largest number of slices in figures (the first ones), but for strips; tables have all conditions.
inline constexpr std::size_t most_slices = 48;

struct SweepView {
  std::size_t entry = 0;       ///< the shown entry of the sweep; 0 without a sweep
  Axis axis;                   ///< of the shown parameter
  Column column;               ///< the same as a column of a table
  std::vector<double> x;       ///< of each condition
  std::vector<Slice> slices;   ///< in the order of the report, the first of them
  std::size_t all_slices = 0;  ///< of the report
  bool is_line = false;        ///< the parameter takes several numbers, so that curves can be drawn between them
};

/// Shows the entry of the sweep with the most numeric values; among equals the last one. If no entry has numbers, the
/// last one is shown with positions.
[[nodiscard]] SweepView view_of(const Report& report, std::size_t most = most_slices);

/// ` Of 60 combinations of the other parameters the first 48 are drawn; tables have all.`; empty if all are drawn.
[[nodiscard]] std::string slices_left_out(const SweepView& view);

/// Sets the range of the axis of a panel to that of the shown parameter, with a margin.
void set_range(const SweepView& view, Panel& panel);

/// Values with their intervals at the places of categories, between which no line means anything.
struct CategoryBars {
  std::size_t number, of;              ///< place among the bars that stand side by side
  std::array<std::string, 3> columns;  ///< of the value, its lower and its upper end in the table of the slice
  Style style;
  std::string legend;
  std::size_t panel = 0;  ///< of the figure
  /// By how much the bars stand to the right of their category.
  [[nodiscard]] double shift() const;
};

/// Adds the values of `table` as markers with bars to a panel of the figure.
void add_bars(const Table& table, const CategoryBars& bars, Figure& figure);

/// Name of a swept parameter: `base amplitude`, `A_h`.
[[nodiscard]] Axis axis_of_parameter(const std::string& pointer);

/// The same for these conditions: its unit also has the other form of an amplitude or a frequency, `1 = 0.245 g`, if
/// that is the same in all of them.
[[nodiscard]] Axis axis_of_parameter(const std::string& pointer, Shakings shakings);

/// `Omega_h` as `Ω_h`, as figures and pages write it.
[[nodiscard]] std::string with_greek(std::string text);

/// The values of all swept parameters of a condition, those of its shaking in both forms: `friction 0.35/0.3, base
/// amplitude 4.5 = 1.1 g`; empty if nothing is swept.
[[nodiscard]] std::string name_of_condition(const Report& report, const ReportedCondition& condition);

/// Ends of the interval around each of these increasing numbers: halfway to its neighbours.
struct SpanAround {
  double low, high;
};
[[nodiscard]] std::vector<SpanAround> spans_around(const std::vector<double>& places);

/// Quantities and values; empty if there are none.
[[nodiscard]] std::string values_in_words(const std::vector<Parameter>& others);

}  // namespace rocking::analysis
