#pragma once

#include "process_pool.hpp"
#include "exit_code.hpp"

namespace rocking::program {

/// Executes the command line; `pool` runs the realisations. Errors are printed on standard error.
[[nodiscard]] ExitCode carry_out_command_line(int argc, const char* const* argv, const ProcessPool& pool);

}  // namespace rocking::program
