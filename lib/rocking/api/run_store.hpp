#pragma once

#include <stdexcept>

#include "rocking/api/run.hpp"

namespace rocking {

/// The realisations of a run. Throws std::invalid_argument if it has none: a RunResult that no call has returned.
[[nodiscard]] inline const Store& store_of(const RunResult& run) {
  if (!run.store) throw std::invalid_argument("the run has no realisations: run() or open_run() has not returned it");
  return *run.store;
}

}  // namespace rocking
