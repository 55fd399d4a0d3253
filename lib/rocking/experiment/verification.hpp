#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/run.hpp"
#include "rocking/experiment/store.hpp"

namespace rocking::experiment {

/// A realisation that gave something else when it was run again.
struct Difference {
  RealisationKey key;
  std::vector<std::string> fields;  ///< those of its row that differ
};

struct Verification {
  std::uint64_t checked = 0;            ///< realisations that were run again
  std::uint64_t different = 0;          ///< of them
  std::uint64_t not_compared = 0;       ///< stored under a former results version, of which this program gives other bits
  std::vector<Difference> differences;  ///< the first few, in the order of their keys
};

/// Names of the fields in which two summaries differ.
[[nodiscard]] std::vector<std::string> differing_fields(const Summary& a, const Summary& b);

/// Runs realisations of a store again and compares them with their rows, to the bit: all of them, or about `sample`,
/// evenly spread over the experiment. Those of a former results version are compared where they should have the same bits
/// (results_version.hpp); the others are counted.
[[nodiscard]] Verification verify(const Experiment& experiment, const Store& store,
                                  const std::optional<std::uint64_t>& sample, const RunOptions& options);

}  // namespace rocking::experiment
