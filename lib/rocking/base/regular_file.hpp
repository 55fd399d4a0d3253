#pragma once

#include <filesystem>

namespace rocking::base {

/// Throws InputError where there is something of this name that is no regular file: to open a pipe, or to read a terminal or a
/// device, may wait or go on for ever. A path that leads nowhere is left to whoever opens it.
void expect_regular_file(const std::filesystem::path& path);

}  // namespace rocking::base
