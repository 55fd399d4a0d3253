#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "rocking/report/mode_table.hpp"

namespace rocking::program {

/// A variable of the environment; empty where it is not set.
[[nodiscard]] std::string environment(const char* name);

/// How many columns the terminal behind a file descriptor has; absent where there is none, or where it does not tell.
[[nodiscard]] std::optional<std::size_t> terminal_columns(int descriptor);

/// What suits standard output: on a terminal its width, and bars in the letters of the user's locale.
[[nodiscard]] report::TableLook table_look();

}  // namespace rocking::program
