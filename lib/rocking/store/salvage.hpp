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

}  // namespace rocking
