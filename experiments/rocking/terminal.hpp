#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "rocking/output/mode_table.hpp"

namespace rocking::program {

/// An environment variable; empty if it is not set.
[[nodiscard]] std::string environment(const char* name);

/// Number of columns of the terminal at a file descriptor; absent without a terminal, or if it is not known.
[[nodiscard]] std::optional<std::size_t> terminal_columns(int descriptor);

/// The look for standard output: on a terminal its width, and bars in the letters of the user's locale.
[[nodiscard]] TableLook table_look();

}  // namespace rocking::program
