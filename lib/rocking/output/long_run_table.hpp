#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "rocking/output/settling_table.hpp"

/// Long-run shares of time: of the windows of the realisations with a long run (`long_run_every`), by response mode.
namespace rocking {

/// What the shares mean beside the response modes in the end.
inline constexpr const char* long_run_meaning =
    "A response mode in the end is the label of a window; where responses are left again, the long-run shares tell how "
    "much of the time each mode takes";

/// The most frequent modes of all long runs, at most `most`, in the order of the modes.
[[nodiscard]] std::vector<section::ResponseMode> long_run_modes(std::span<const SettlingRow> conditions,
                                                                std::size_t most);

/// `64.0 [52.1, 74.8]` per cent; `< 7.0`, an upper bound, of a mode that no window has.
[[nodiscard]] look::Cell long_run_cell(const SettlingRow& condition, const section::ResponseMode& mode);

/// Share of the windows in per cent that have none of `shown`; nothing if there are none.
[[nodiscard]] look::Cell other_long_run_shares(const SettlingRow& condition,
                                               std::span<const section::ResponseMode> shown);

/// Text for a terminal: a table of the conditions in which more than one mode occurs, with lines up to `width`, and
/// the number of the others. Empty without long runs.
[[nodiscard]] std::string long_run_text(std::span<const SettlingRow> conditions, std::size_t width);

}  // namespace rocking
