#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "analysis/figure.hpp"
#include "analysis/run_report.hpp"

/// Along which parameter a run is shown, and what stands beside it.
namespace rocking::analysis {

/// Conditions that differ in the shown parameter alone.
struct Slice {
  std::string name;                     ///< the values of the other parameters; empty where there are none
  std::vector<std::size_t> conditions;  ///< of the report, by growing `x`
};

/// Slices that figures show at most, the first ones; tables have all conditions.
inline constexpr std::size_t most_slices = 48;

struct SweepView {
  Axis axis;                  ///< of the shown parameter
  Column column;              ///< the same, for a table
  std::vector<double> x;      ///< of each condition
  std::vector<Slice> slices;  ///< in the order of the report, at most most_slices
  bool is_line = false;       ///< the parameter takes several numbers, so that there is a way between two
};

/// Shows the entry of the sweep that takes the most numbers, of several the last; where none takes numbers, the last by
/// place.
[[nodiscard]] SweepView view_of(const RunReport& report);

/// What a swept parameter is called: `base amplitude`, `A_h`.
[[nodiscard]] Axis axis_of_parameter(const std::string& pointer);

/// The values of all swept parameters of a condition: `friction 0.35/0.3, base amplitude 4.5`; empty where nothing is swept.
[[nodiscard]] std::string name_of_condition(const RunReport& report, const ConditionReport& condition);

/// A value of a parameter in a few letters: `0.35/0.3` for friction.
[[nodiscard]] std::string short_value(const std::string& pointer, const report::Json& value);

/// Ends of the stretch that each of these rising numbers stands for: halfway to its neighbours.
struct Stretch {
  double low, high;
};
[[nodiscard]] std::vector<Stretch> stretches_of(const std::vector<double>& places);

}  // namespace rocking::analysis
