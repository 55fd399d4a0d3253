#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace rocking::report {

/// All bytes of a file. Throws std::system_error with the path.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

/// Replaces or makes a file so that whoever looks sees the old one or the whole new one, also after a power failure: a
/// temporary file in the same folder is written, flushed to the disk and renamed. Throws std::system_error with the path;
/// the temporary file is then gone.
void write_atomically(const std::filesystem::path& path, std::string_view content);

/// Makes `folder` if need be and checks that files can be made in it. Throws std::system_error with the path.
void ensure_writable(const std::filesystem::path& folder);

}  // namespace rocking::report
