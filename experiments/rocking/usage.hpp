#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

namespace rocking::program {

/// What was probably meant by the first word of the command line that nothing knows: `"rnu" is no command; did you mean
/// "run"?`. Absent where every word is known.
[[nodiscard]] std::optional<std::string> explain_unknown_word(const CLI::App& app, int argc, const char* const* argv);

}  // namespace rocking::program
