#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "rocking/ensemble/work_list.hpp"

/// Transfer of pairs and their results between processes of one program on machines of the same kind: the fields one
/// after the other, numbers as in memory. Not a file format.
namespace rocking {

using Bytes = std::vector<std::byte>;

/// Results of a pair.
struct PairOutcome {
  Pair pair;
  std::vector<Summary> summaries;
};

[[nodiscard]] Bytes to_bytes(std::span<const Pair> pairs);
[[nodiscard]] Bytes to_bytes(std::span<const PairOutcome> outcomes);

/// Throw std::length_error if the bytes are not those that the counterpart writes.
[[nodiscard]] std::vector<Pair> pairs_from(std::span<const std::byte> bytes);
[[nodiscard]] std::vector<PairOutcome> outcomes_from(std::span<const std::byte> bytes);

}  // namespace rocking
