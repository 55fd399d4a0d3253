#pragma once

#include "crew.hpp"
#include "exit_code.hpp"

namespace rocking::program {

/// Does what the command line says; runs are done by `crew`. Whatever goes wrong is told on standard error.
[[nodiscard]] ExitCode carry_out_command_line(int argc, const char* const* argv, const Crew& crew);

}  // namespace rocking::program
