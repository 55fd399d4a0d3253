#pragma once

#include "exit_code.hpp"
#include "process_pool.hpp"

namespace rocking::program {

/// Executes the command line; `pool` runs the realisations. Errors are printed on standard error.
[[nodiscard]] ExitCode carry_out_command_line(int argc, const char* const* argv, const ProcessPool& pool);

}  // namespace rocking::program
