#pragma once

#include <cstddef>
#include <string>

#include "rocking/output/condition_table.hpp"

/// Long-run shares of time: of the windows of the realisations with a long run (`long_run_every`), by response mode.
namespace rocking {

/// For publications: a row for each condition with long runs, a column for each of the most frequent modes in per cent,
/// `64.0 [52.1, 74.8]`; `< 7.0`, an upper bound, of a mode that no window has.
[[nodiscard]] RunTable long_run_table(const Report& report);
/// For CSV: a row for each condition and response mode of its long runs.
[[nodiscard]] RunTable long_run_share_table(const Report& report);

/// Text for a terminal: a table of the conditions in which more than one mode occurs, with lines up to `width`, and
/// the number of the others. Empty without long runs.
[[nodiscard]] std::string long_run_text(const Report& report, std::size_t width);

}  // namespace rocking
