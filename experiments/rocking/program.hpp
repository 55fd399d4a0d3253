#pragma once

#include <functional>

#include "exit_code.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/store/store_identity.hpp"

namespace rocking::program {

/// Processes and threads that run realisations.
struct ProcessPool {
  unsigned threads = 1;    ///< of each process, unless `-j` says otherwise
  unsigned processes = 1;  ///< that work together
  /// Sends the other processes the experiment, and returns the runner of pairs on all processes. Empty: no others.
  std::function<PairRunner(const Identity&, unsigned threads)> start_workers = {};
};

/// Executes the command line; `pool` runs the realisations. Errors are printed on standard error.
[[nodiscard]] ExitCode carry_out_command_line(int argc, const char* const* argv, const ProcessPool& pool);

}  // namespace rocking::program
