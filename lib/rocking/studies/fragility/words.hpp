#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rocking/look/table.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/stats/fragility.hpp"
#include "rocking/studies/fragility/fragility_curve.hpp"
#include "rocking/studies/fragility/stripes.hpp"

/// Words that the curves of one motion and of a suite share.
namespace rocking {

/// `overturning`, or `a peak tilt above 0.5`.
[[nodiscard]] std::string words_of(const FragilityEvent& event);
/// Heading of the column of shares: `overturned`, or `tilt > 0.5`.
[[nodiscard]] std::string column_of(const FragilityEvent& event);
/// `2.31 [2.20, 2.43]`.
[[nodiscard]] look::Cell estimate_cell(double value, const std::optional<stats::Interval>& interval);
[[nodiscard]] std::string bounded_in_words(const stats::Bounded& bounded);

/// A number of years with three digits and without a power of ten: `1910`, `0.25`.
[[nodiscard]] std::string years_in_words(double years);

/// Adds the column `unresolved` to the table of every `step`-th level if a level has realisations without an answer.
template <class Levels>
void add_unresolved(const Levels& levels, std::size_t step, look::Table& table) {
  if (std::ranges::none_of(levels, [](const auto& level) { return level.unresolved > 0; })) return;
  add_columns(table, {"unresolved"});
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    table.rows[row].push_back(look::whole(levels[row * step].unresolved));
  }
}

/// `lack of fit: deviance 3.2, p = 0.4 (499 bootstrap samples)`, as a line.
[[nodiscard]] std::string test_in_words(const stats::LackOfFit& test);

/// The rare estimates of a curve over the swept intensity `parameter`, as a table; empty if there are none.
[[nodiscard]] std::string rare_table(const std::vector<RareLevel>& levels, const std::string& parameter);

/// The title of the run and the values of the other entries of its sweep, as a line; empty if there are none.
[[nodiscard]] std::string heading_of_curve(const std::string& title, const std::vector<Parameter>& others);

}  // namespace rocking
