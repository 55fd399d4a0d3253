#pragma once

#include <cstdint>
#include <filesystem>

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/store.hpp"

namespace rocking::experiment {

/// Where a database's header counts more pages than its file has, as after a cut or where a bit of it turned: sets the count
/// to those that are there, since SQLite reads nothing of such a file. Any other file is left alone.
void count_pages_again(const std::filesystem::path& path);

/// Takes over every realisation that is sound in a store and has the bits that this program gives, whatever stands between
/// them; returns how many. The store may be damaged or of an earlier layout. What was added is not yet durable.
std::uint64_t salvage(const Experiment& experiment, const Store& damaged, Store& into);

}  // namespace rocking::experiment
