#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "analysis/run_report.hpp"

/// Selection of the swept parameter on the x axis, and of the curves or panels.
namespace rocking::analysis {

/// Conditions that differ in the shown parameter only.
struct Slice {
  std::string name;                     ///< values of the other parameters; empty if there are none
  std::vector<std::size_t> conditions;  ///< indices in the report, by increasing `x`
};

/// Largest number of slices in figures (the first ones); tables have all conditions.
inline constexpr std::size_t most_slices = 48;

struct SweepView {
  Axis axis;                  ///< of the shown parameter
  Column column;              ///< the same as a column of a table
  std::vector<double> x;      ///< of each condition
  std::vector<Slice> slices;  ///< in the order of the report, at most most_slices
  bool is_line = false;       ///< the parameter takes several numbers, so that curves can be drawn between them
};

/// Shows the entry of the sweep with the most numeric values; among equals the last one. If no entry has numbers, the
/// last one is shown with positions.
[[nodiscard]] SweepView view_of(const RunReport& report);

/// Name of a swept parameter: `base amplitude`, `A_h`.
[[nodiscard]] Axis axis_of_parameter(const std::string& pointer);

/// The values of all swept parameters of a condition: `friction 0.35/0.3, base amplitude 4.5`; empty if nothing is
/// swept.
[[nodiscard]] std::string name_of_condition(const RunReport& report, const ConditionReport& condition);

/// Short text of the value of a parameter: `0.35/0.3` for friction.
[[nodiscard]] std::string short_value(const std::string& pointer, const Json& value);

/// Ends of the interval around each of these increasing numbers: halfway to its neighbours.
struct Stretch {
  double low, high;
};
[[nodiscard]] std::vector<Stretch> stretches_of(const std::vector<double>& places);

}  // namespace rocking::analysis
