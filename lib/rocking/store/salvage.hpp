#pragma once

#include <cstdint>
#include <filesystem>

#include "rocking/scene/experiment.hpp"
#include "rocking/store/store.hpp"

namespace rocking {

/// Corrects the page count in the header of a database if it exceeds the pages in the file, for example after
/// truncation or a changed bit. SQLite reads nothing of such a file. Other files are not changed.
void count_pages_again(const std::filesystem::path& path);

/// Copies every undamaged realisation, wherever the file is damaged. Returns their number. The added rows are not yet
/// durable.
std::uint64_t salvage(const Experiment& experiment, const Store& damaged, Store& into);

/// What was kept of a damaged store.
struct Repair {
  std::uint64_t realisations = 0;      ///< taken over
  std::filesystem::path damaged_file;  ///< where it is now
};

/// Where the new store is made, beside the one that it will replace.
[[nodiscard]] std::filesystem::path mended_store_beside(const std::filesystem::path& path);

/// Replaces the damaged store at `path` by one with its undamaged rows. The damaged file stays, in `kept_in`, as
/// `damaged-N.sqlite`. Throws sqlite::UnusableFile if there is no such row, because the identity may then be wrong too.
[[nodiscard]] Repair mend_store(const std::filesystem::path& path, const std::filesystem::path& kept_in, Store damaged,
                                const Experiment& experiment);

}  // namespace rocking
