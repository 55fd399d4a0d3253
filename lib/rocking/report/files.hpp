#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <string_view>

#include "rocking/report/json_writer.hpp"

namespace rocking::report {

/// All bytes of a regular file, but not much more than `most`: of a longer one at least `most` + 1. Throws base::InputError where
/// the path leads to no regular file, std::system_error with the path where that cannot be read.
[[nodiscard]] std::string read_file(const std::filesystem::path& path,
                                    std::size_t most = std::numeric_limits<std::size_t>::max());

/// Where the files come from that another file names: bytes of the one called so, as read_file gives them.
using FileSource = std::function<std::string(const std::string& name, std::size_t most)>;

/// Files whose place is seen from `folder`.
[[nodiscard]] FileSource files_seen_from(const std::filesystem::path& folder);

/// Replaces or makes a file so that whoever looks sees the old one or the whole new one, also after a power failure: a
/// temporary file in the same folder is written, flushed to the disk and renamed. Throws std::system_error with the path;
/// the temporary file is then gone.
void write_atomically(const std::filesystem::path& path, std::string_view content);
/// The same with content that comes piece by piece: write(sink) is called once.
void write_atomically(const std::filesystem::path& path, const std::function<void(const TextSink& sink)>& write);

/// Removes the temporary files that processes which were killed left in a folder. Those of living processes stay.
void remove_abandoned_files(const std::filesystem::path& folder);

/// Makes `folder` if need be and checks that files can be made in it. Throws std::system_error with the path.
void ensure_writable(const std::filesystem::path& folder);

}  // namespace rocking::report
