#pragma once

#include <cstdint>

namespace rocking::experiment {

/// One part of several that an experiment was cut into.
struct Shard {
  std::uint64_t part = 1;  ///< from 1 to `parts`
  std::uint64_t parts = 1;

  /// Whether the piece of work with this number, counted from 0 over the whole experiment, belongs to the part.
  [[nodiscard]] bool has(std::uint64_t number) const { return number % parts == part - 1; }
};

}  // namespace rocking::experiment
