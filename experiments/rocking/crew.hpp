#pragma once

#include <functional>

#include "rocking/experiment/run.hpp"
#include "rocking/experiment/store_identity.hpp"

namespace rocking::program {

/// Who simulates.
struct Crew {
  unsigned threads = 1;    ///< of each process, unless `-j` says otherwise
  unsigned processes = 1;  ///< that work together
  /// Gives the other processes what they must know, and returns how pairs are run together with them. Empty: no others.
  std::function<experiment::Workforce(const experiment::Identity&, unsigned threads)> hire = {};
};

}  // namespace rocking::program
