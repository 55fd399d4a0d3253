#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/ensemble/mode_family.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/output/report.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/shaking.hpp"

namespace rocking {

/// What the terminal can show.
struct TableLook {
  std::size_t width = 120;                              ///< largest length of a line in letters
  std::optional<Letters> bars = std::nullopt;           ///< letters from which bars are drawn; absent: no bars
  std::optional<std::size_t> most_rows = std::nullopt;  ///< of a run; more conditions are summarised; absent: all rows
};

/// A response mode in a row of the table.
struct TableEntry {
  section::ResponseMode mode;
  std::uint64_t count = 0;  ///< realisations
  double estimate = 0.0;    ///< probability
  /// Simultaneous; with `until` the one that is valid whenever the run stops. Absent where nothing is random, and for
  /// a mode that did not occur and that the result does not list.
  std::optional<stats::Interval> interval;
};

/// The column of the peak tilt, and its explanation.
inline constexpr std::string_view peak_tilt_heading = "peak tilt";
inline constexpr std::string_view peak_tilt_legend =
    "peak tilt: median and 95 % quantile of the largest abs(Theta); overturned counts as above every value (-)";
/// Likewise of the peak slip, which is shown where a block slid without rocking.
inline constexpr std::string_view peak_slip_heading = "peak slip";
inline constexpr std::string_view peak_slip_legend = "peak slip: likewise of the largest slip, in m";

/// A condition: a row of the table.
struct TableRow {
  std::vector<Parameter> parameters;  ///< swept; the same pointers in every row
  std::uint64_t realisations = 0;
  std::uint64_t without_answer = 0;  ///< ConditionResult::without_answer
  std::vector<TableEntry> modes;
  bool is_random = true;  ///< otherwise the single realisation is the response of the condition, with certainty
  std::optional<Shaking> shaking = std::nullopt;  ///< absent under a ground motion
  std::optional<double> scale = std::nullopt;     ///< of a ground motion
  std::string peak_tilt = {};                     ///< peak_cell, or empty
  std::string peak_slip = {};                     ///< likewise [m]
};

/// `98.5 [94.4, 99.8] (48)`, of a response mode in per cent; `< 2.8`, the end of its interval, if it did not occur.
[[nodiscard]] look::Cell share_cell(const AnyShare& share, std::uint64_t realisations);
/// The share of `count` in `all` without an interval; nothing if it is 0.
[[nodiscard]] look::Cell part_cell(std::uint64_t count, std::uint64_t all);
/// `< 2.8`, of a share.
[[nodiscard]] look::Cell bound_cell(double share);

/// Median and 95 % quantile of a peak in two digits, `0.41 0.53`. `-`: the realisations that ended before their
/// horizon, mostly by overturning, are too many for a value.
[[nodiscard]] std::string peak_cell(const std::vector<stats::QuantileEstimate>& quantiles);

/// The modes that a table or figure with room for `most` shows: the most frequent ones, in the order of the modes.
/// Overturning is one of them if it occurs, however rare it is.
[[nodiscard]] std::vector<section::ResponseMode> modes_to_show(const ModeTally& tally, std::size_t most);

/// A row for each condition of a run. Each row lists the modes that occur in any condition.
[[nodiscard]] std::vector<TableRow> table_rows(const Report& report);

/// The response modes of every condition as text for a terminal: a row for each condition, a column for each swept
/// parameter, for the shaking in its other form where that differs between conditions (a last line has what is common
/// to all), and for each mode that occurs, with the estimate and its interval in per cent (of more than 1000 realisations also the
/// count, `0.016 [0.012, 0.021] (48)`). A mode that did not occur in a condition has the upper end of its interval there:
/// `< 2.8`. Where not every mode has room, overturning and the most frequent mode of each condition come first,
/// without an interval if need be, and the others are added up in a last column: each row accounts for every realisation. A bar of the modes' shares follows if bars are wanted,
/// several modes occur, and there is room for it and for three modes (or all); its marks stand before the headings. If
/// no row is random, there is one column with the response instead. The peak tilt follows if the rows have it and there
/// is room, and after it the peak slip where a block slid without rocking. Empty without rows.
[[nodiscard]] std::string mode_table(std::span<const TableRow> conditions, const TableLook& look = {});

/// A line on overturning: where it is most likely, or the largest upper bound of its probability in any condition.
/// Empty without rows.
[[nodiscard]] std::string overturning_line(std::span<const TableRow> conditions);

}  // namespace rocking
