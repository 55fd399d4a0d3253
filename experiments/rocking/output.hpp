#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include "rocking/base/error.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/write_facts.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/json_writer.hpp"

namespace rocking::program {

/// What is printed. Results go to standard output, everything else to standard error.
struct Loudness {
  bool json = false;
  bool quiet = false;
  bool verbose = false;
  bool no_progress = false;
};

/// Adds `--json`, `-q`, `-v` and `--no-progress` to a command.
void add_loudness(CLI::App& command, Loudness& loudness);

/// Adds `--all`.
void add_extent(CLI::App& command, Extent& extent);

/// Writes to standard output and flushes it. Throws std::system_error.
void print_result(std::string_view text);
/// The same of a text that comes piece by piece.
void print_result(const std::function<void(const TextSink& sink)>& write);

/// Writes text for readers to standard output, on a terminal with lines broken between words.
void print_text(std::string_view text);

/// Prints which files were written, below a text of other results; or as JSON, without it.
void print_written(const Loudness& loudness, const std::vector<std::string>& files, std::string above = "");

/// Writes `rocking: text` to standard error.
void print_notice(std::string_view text);

/// Writes to standard error. Errors of the write are ignored, so that a run continues.
void print_aside(const std::string& text);

/// `FILE: 2 problems` and a line for each.
[[nodiscard]] std::string listed_problems(const base::InputError& error);

/// An environment variable; empty if it is not set.
[[nodiscard]] std::string environment(const char* name);

/// Number of columns of the terminal at a file descriptor; absent without a terminal, or if it is not known.
[[nodiscard]] std::optional<std::size_t> terminal_columns(int descriptor);

/// The look for standard output: on a terminal its width, and bars in the letters of the user's locale.
[[nodiscard]] TableLook table_look();

}  // namespace rocking::program
