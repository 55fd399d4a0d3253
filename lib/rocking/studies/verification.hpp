#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rocking/ensemble/run.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/store/difference.hpp"
#include "rocking/store/store.hpp"

namespace rocking {

struct Verification {
  std::uint64_t checked = 0;    ///< realisations that were run again
  std::uint64_t different = 0;  ///< of them
  /// Stored under a former results version, for which this program computes other bits.
  std::uint64_t not_compared = 0;
  std::vector<Difference> differences;  ///< the first few, in the order of their keys
};

/// Runs realisations of a store again and compares them with their rows to the bit: all of them, or about `sample`,
/// evenly spaced over the experiment. Those of a former results version are compared where they should have the same
/// bits (results_version.hpp); the others are counted.
[[nodiscard]] Verification verify(const Experiment& experiment, const Store& store,
                                  const std::optional<std::uint64_t>& sample, const RunOptions& options);

}  // namespace rocking
