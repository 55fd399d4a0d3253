#pragma once

#include <filesystem>

namespace rocking::base {

/// Throws InputError if `path` names something that is not a regular file: opening a pipe or reading a terminal or a
/// device may block for ever. A path that does not exist is accepted; opening it fails later.
void expect_regular_file(const std::filesystem::path& path);

}  // namespace rocking::base
