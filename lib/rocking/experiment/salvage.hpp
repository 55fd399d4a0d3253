#pragma once

#include <cstdint>
#include <filesystem>

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/store.hpp"

namespace rocking::experiment {

/// Gives a database that was cut short its length again, with zeros at the end: SQLite reads nothing of a shorter one. Any
/// other file is left alone.
void restore_length(const std::filesystem::path& path);

/// Takes over every realisation that is sound in a damaged store, whatever stands between them; returns how many. What was
/// added is not yet durable.
std::uint64_t salvage(const Experiment& experiment, const Store& damaged, Store& into);

}  // namespace rocking::experiment
