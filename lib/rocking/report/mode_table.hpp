#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/result.hpp"
#include "rocking/report/share_bar.hpp"

namespace rocking::report {

/// Where a table is to stand.
struct TableLook {
  std::size_t width = 120;      ///< letters a line that there is room for
  std::optional<Letters> bars;  ///< of what to draw bars; absent: none
};

/// The response modes of every condition as text for a terminal: a row a condition, a column for each swept parameter and
/// each mode that occurs, with the estimate and its simultaneous interval (with `until` the one that holds whenever the run
/// stopped), all in per cent. Modes that do not fit are added
/// up in a last column, so that each row still accounts for every realisation. A bar of the modes' shares follows where it
/// is wanted, several modes occur, and three of them (or all) have room beside it; its marks stand before the headings.
[[nodiscard]] std::string mode_table(const experiment::Experiment& experiment,
                                     const experiment::ExperimentResult& result, const TableLook& look = {});

/// What a condition is called in a table: `0.35/0.3` for friction, the value for anything else.
[[nodiscard]] std::string short_value(const experiment::Parameter& parameter);

}  // namespace rocking::report
