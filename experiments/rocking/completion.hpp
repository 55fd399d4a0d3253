#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace rocking::program {

/// A script for bash that completes the commands, flags, choices and files of the program.
[[nodiscard]] std::string bash_completion(const CLI::App& app);

}  // namespace rocking::program
