#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/text/json_writer.hpp"

namespace rocking {

/// All bytes of a regular file, but not much more than `most`: of a longer one at least `most` + 1. Throws
/// base::InputError if the path does not lead to a regular file, std::system_error with the path if it cannot be read.
[[nodiscard]] std::string read_file(const std::filesystem::path& path,
                                    std::size_t most = std::numeric_limits<std::size_t>::max());

/// Source of the files that another file names: the bytes of the file `name`, as from read_file.
using FileSource = std::function<std::string(const std::string& name, std::size_t most)>;

/// Files with paths relative to `folder`.
[[nodiscard]] FileSource files_seen_from(const std::filesystem::path& folder);

/// Source of the names that fit a pattern, sorted by bytes: `*` stands for any characters of the file name, `?` for one.
using FileMatches = std::function<std::vector<std::string>(const std::string& pattern)>;

/// Names of regular files with paths relative to `folder`, in letters of any case: `*.at2` fits `A.AT2`; a `*` or `?` in the name of a folder is itself. Names that
/// begin with a dot need a dot in the pattern. Empty where the folder of the pattern does not exist.
[[nodiscard]] FileMatches matches_seen_from(const std::filesystem::path& folder);

/// Replaces or creates a file atomically, so that readers see the old file or the complete new one, also after a power
/// failure: a temporary file in the same folder is written, flushed to the disk and renamed. Throws std::system_error
/// with the path; the temporary file is then gone.
void write_atomically(const std::filesystem::path& path, std::string_view content);
/// The same with content in pieces: write(sink) is called once.
void write_atomically(const std::filesystem::path& path, const std::function<void(const TextSink& sink)>& write);

/// Creates `folder` if necessary, checks that files can be created in it, and removes from it the temporary files of
/// processes that were killed. Throws std::system_error with the path.
void ensure_writable(const std::filesystem::path& folder);

/// A word as a shell takes it from a command line: in single quotes where it needs them.
[[nodiscard]] std::string shell_word(const std::string& word);

}  // namespace rocking
