#pragma once

#include <cstdint>
#include <optional>

#include "rocking/scene/experiment.hpp"
#include "rocking/store/shard.hpp"

namespace rocking {

/// Largest disk space and memory that a run needs at a time, estimated to within a factor of 1.5 for runs of a megabyte
/// and more (lib/docs/scale.md).
struct Needs {
  std::uint64_t disk_bytes = 0;
  std::uint64_t memory_bytes = 0;
};

/// Options of a run that its needs depend on.
struct Means {
  unsigned threads = 1;
  std::optional<Shard> shard;
  std::uint64_t stored = 0;  ///< realisations whose rows are on the disk already
  bool page = true;          ///< whether the page is drawn
};

[[nodiscard]] Needs needs_of(const Experiment& experiment, const Means& means);

}  // namespace rocking
