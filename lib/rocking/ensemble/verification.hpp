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
  std::uint64_t checked = 0;            ///< realisations that were run again
  std::uint64_t different = 0;          ///< of them
  std::vector<Difference> differences;  ///< the first few, in the order of their keys
};

/// Runs realisations of a store again and compares them with their rows to the bit: all of them, or about `sample`,
/// evenly spaced over the experiment.
[[nodiscard]] Verification verify(const Experiment& experiment, const Store& store,
                                  const std::optional<std::uint64_t>& sample, const RunOptions& options);

}  // namespace rocking
