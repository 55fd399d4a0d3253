#pragma once

#include "campaign.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "rocking/api/run.hpp"

namespace rocking::program {

/// How a study of the library is carried out: on the threads that are asked for, with a line of progress, until Ctrl-C.
[[nodiscard]] inline Execution watched(const ExecutionOptions& options, Progress& progress) {
  const auto show = [&progress](std::uint64_t done, std::uint64_t all) {
    progress.show(done, all);
    return Decision::proceed;
  };
  return {.threads = options.threads, .on_progress = show, .stop = &stop_on_interrupt()};
}

}  // namespace rocking::program
