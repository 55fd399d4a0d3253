#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rocking/experiment/work.hpp"

/// How pairs and what came of them travel between processes of one program on machines alike: fields one after the other,
/// numbers as they lie in memory. No format of a file.
namespace rocking::experiment {

using Bytes = std::vector<std::byte>;

/// What came of a pair.
struct PairOutcome {
  Pair pair;
  std::vector<Summary> summaries;
};

[[nodiscard]] Bytes to_bytes(std::span<const Pair> pairs);
[[nodiscard]] Bytes to_bytes(std::span<const PairOutcome> outcomes);

/// Throw std::length_error where the bytes are not what the other side wrote.
[[nodiscard]] std::vector<Pair> pairs_from(std::span<const std::byte> bytes);
[[nodiscard]] std::vector<PairOutcome> outcomes_from(std::span<const std::byte> bytes);

}  // namespace rocking::experiment
