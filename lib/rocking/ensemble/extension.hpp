#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "rocking/scene/experiment.hpp"
#include "rocking/store/store.hpp"

namespace rocking {

/// The largest number of realisations of a condition in a store, counting those before a missing one too.
[[nodiscard]] std::uint64_t most_stored_realisations(const Store& store);

/// Copies the rows of a store of `experiment` that are also rows of `extension`, an experiment that differs in the
/// numbers of realisations, or by further values of its sweep, only. The row of a realisation that has a neighbour in
/// one of the two but not in the other
/// is left out, because it contains the comparison with the neighbour. The added rows are not yet durable.
void copy_common_realisations(const Store& former, const Experiment& experiment, const Experiment& extension,
                              Store& into);

/// Where the new store is made, beside the one that it will replace.
[[nodiscard]] std::filesystem::path extended_store_beside(const std::filesystem::path& path);

/// Replaces the store at `path` by one of an extension of its experiment, with the realisations that the two have in
/// common. `code`: version and revision of the program.
void extend_store(const std::filesystem::path& path, Store former, const Experiment& experiment,
                  const Experiment& extension, const std::string& code);

}  // namespace rocking
