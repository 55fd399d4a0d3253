#pragma once

#include <cstdint>
#include <string>

#include "rocking/ensemble/run.hpp"
#include "run_folder.hpp"

namespace rocking::program {

/// State of a run.
struct Standing {
  std::string state;  ///< running, stopped or finished
  std::string part;   ///< `2/5` of a shard; empty: the whole
  Completeness realisations;
  std::uint64_t failed = 0;  ///< of those that are done: stopped, or ended by Painleve's paradox
  bool replaces = false;     ///< will replace an earlier run in the folder
  double rate = 0.0;         ///< realisations per second of the active run; 0 if none is active or it has just started

  [[nodiscard]] std::uint64_t missing() const { return realisations.all - realisations.done; }
};

/// Reads the state of the run in a folder, of the one that replaces it if there is one. Throws as
/// RunFolder::open_valid_store does.
[[nodiscard]] Standing standing_of(RunFolder& folder);

}  // namespace rocking::program
