#pragma once

#include <cstdint>
#include <optional>

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/shard.hpp"

namespace rocking::program {

/// What a run takes of its machine at most at a time, estimated to within a factor of 1.5 for runs of a megabyte and more
/// (lib/docs/scale.md).
struct Needs {
  std::uint64_t disk_bytes = 0;
  std::uint64_t memory_bytes = 0;
};

/// How a run is carried out, as far as its needs depend on that.
struct Means {
  unsigned threads = 1;
  std::optional<experiment::Shard> shard;
  std::uint64_t stored = 0;  ///< realisations whose rows are on the disk already
};

[[nodiscard]] Needs needs_of(const experiment::Experiment& experiment, const Means& means);

/// Throws std::system_error where this process cannot have that much memory.
void expect_memory(std::uint64_t bytes);

}  // namespace rocking::program
