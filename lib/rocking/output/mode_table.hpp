#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rocking/ensemble/result.hpp"
#include "rocking/output/share_bar.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// What the terminal can show.
struct TableLook {
  std::size_t width = 120;      ///< largest length of a line in letters
  std::optional<Letters> bars;  ///< letters from which bars are drawn; absent: no bars
};

/// A response mode in a row of the table.
struct TableEntry {
  section::ResponseMode mode;
  std::uint64_t count = 0;   ///< realisations
  double estimate = 0.0;     ///< probability
  stats::Interval interval;  ///< simultaneous; with `until` the one that is valid whenever the run stops
};

/// A condition: a row of the table.
struct TableRow {
  std::vector<Parameter> parameters;  ///< swept; the same pointers in every row
  std::uint64_t realisations = 0;
  std::vector<TableEntry> modes;
};

/// A row for each condition of a run.
[[nodiscard]] std::vector<TableRow> table_rows(const Experiment& experiment, const ExperimentResult& result);

/// The response modes of every condition as text for a terminal: a row for each condition, a column for each swept
/// parameter and each mode that occurs, with the estimate and its interval in per cent. Modes for which there is no
/// room are added up in a last column, so that each row accounts for every realisation. A bar of the modes' shares
/// follows if bars are wanted, several modes occur, and there is room for it and for three modes (or all); its marks
/// stand before the headings. Empty without rows.
[[nodiscard]] std::string mode_table(std::span<const TableRow> conditions, const TableLook& look = {});

/// The value of a swept parameter in a table: `0.35/0.3` for friction, the value for anything else.
[[nodiscard]] std::string short_value(const Parameter& parameter);

}  // namespace rocking
