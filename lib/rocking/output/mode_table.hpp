#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/ensemble/mode_family.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/output/condition_table.hpp"
#include "rocking/output/report.hpp"

namespace rocking {

/// What the terminal can show.
struct TableLook {
  std::size_t width = 120;                              ///< largest length of a line in letters
  std::optional<Letters> bars = std::nullopt;           ///< letters from which bars are drawn; absent: no bars
  std::optional<std::size_t> most_rows = std::nullopt;  ///< of a run; more conditions are summarised; absent: all rows
};

/// The column of the peak tilt.
inline constexpr std::string_view peak_tilt_heading = "peak tilt";
/// That of the peak slip, which is shown where a block slid without rocking, and its explanation.
inline constexpr std::string_view peak_slip_heading = "peak slip";
inline constexpr std::string_view peak_slip_legend = "peak slip: likewise of the largest slip, in m";

/// `98.5 [94.4, 99.8] (48)`, of a response mode in per cent; `< 2.8`, the end of its interval, if it did not occur.
[[nodiscard]] look::Cell share_cell(const AnyShare& share, std::uint64_t realisations);
/// The share of `count` in `all` without an interval; nothing if it is 0.
[[nodiscard]] look::Cell part_cell(std::uint64_t count, std::uint64_t all);
/// `< 2.8`, of a share.
[[nodiscard]] look::Cell bound_cell(double share);

/// That of this level; without numbers if there is none.
[[nodiscard]] stats::QuantileEstimate quantile_at(const std::vector<stats::QuantileEstimate>& levels, double level);

/// Median and 95 % quantile of a peak in two digits, `0.41 0.53`. `-`: the realisations that ended before their
/// horizon, mostly by overturning, are too many for a value.
[[nodiscard]] std::string peak_cell(const std::vector<stats::QuantileEstimate>& quantiles);

/// The modes that a table or figure with room for `most` shows: the most frequent ones, in the order of the modes.
/// Overturning is one of them if it occurs, however rare it is.
[[nodiscard]] std::vector<section::ResponseMode> modes_to_show(const ModeTally& tally, std::size_t most);

/// Its realisations with this mode.
[[nodiscard]] std::uint64_t count_of(const ReportedCondition& condition, const section::ResponseMode& mode);
/// The mode that most of them have; unresolved if it has none.
[[nodiscard]] section::ResponseMode most_frequent_in(const ReportedCondition& condition);

/// The columns of the response modes that occur, at most `most` of them, and of all others; where nothing is random, of
/// the response.
[[nodiscard]] ConditionColumns mode_columns(const Report& report, std::size_t most);

/// The response modes of every condition as text for a terminal: a row for each condition, a column for each swept
/// parameter, for the shaking in its other form where that differs between conditions (a last line has what is common
/// to all), and for each mode that occurs, with the estimate and its interval in per cent (of more than 1000 realisations also the
/// count, `0.016 [0.012, 0.021] (48)`). A mode that did not occur in a condition has the upper end of its interval there:
/// `< 2.8`. Where not every mode has room, overturning and the most frequent mode of each condition come first,
/// without an interval if need be, and the others are added up in a last column: each row accounts for every realisation. A bar of the modes' shares follows if bars are wanted,
/// several modes occur, and there is room for it and for three modes (or all); its marks stand before the headings. If
/// no row is random, there is one column with the response instead. The peak tilt follows if the rows have it and there
/// is room, and after it the peak slip where a block slid without rocking.
[[nodiscard]] std::string mode_table(const Report& report, const TableLook& look = {});

/// A line on the most frequent response of the only condition, in words, with its interval where something is random; empty
/// for several conditions.
[[nodiscard]] std::string response_line(const Report& report);

/// A line on overturning: where it is most likely, or the largest upper bound of its probability in any condition.
[[nodiscard]] std::string overturning_line(const Report& report);

}  // namespace rocking
