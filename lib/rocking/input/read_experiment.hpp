#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "rocking/base/error.hpp"
#include "rocking/input/sweep.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/text/files.hpp"

namespace rocking {

/// What an experiment file may draw on beside its own text, and how far it may go.
struct Surroundings {
  FileSource files = files_seen_from(".");       ///< for the recorded motions that it names
  FileMatches matches = matches_seen_from(".");  ///< for the patterns of a suite
  std::size_t most_conditions = rocking::most_conditions;
};

/// Files and patterns are seen from a folder.
[[nodiscard]] Surroundings seen_from(const std::filesystem::path& folder);

/// Reads an experiment file (`rocking.experiment/1`, lib/docs/formats.md), works out its sweep and checks every
/// condition. Throws InputError with all problems found, and std::system_error where a file that it names cannot be
/// read.
[[nodiscard]] Experiment experiment_in(std::string_view text, const Overrides& overrides = {},
                                       const Surroundings& surroundings = {});

/// The text of an experiment, as it was given.
struct ExperimentText {
  std::string text;
  std::string name;              ///< of the file, for messages
  std::filesystem::path folder;  ///< to which the file names in the text are relative
};

/// Largest size of an experiment file. A reader of its text need not read more than one byte beyond it.
inline constexpr std::size_t most_experiment_bytes = 64'000'000;

/// The text of a file. Throws std::system_error with the path where it cannot be read.
[[nodiscard]] ExperimentText experiment_text_of(const std::filesystem::path& path);

/// The same of a text; problems have the name and the line.
[[nodiscard]] Experiment experiment_in(const ExperimentText& source, const Overrides& overrides);

/// The same from a file, from whose folder the files that it names are seen. Throws std::system_error with the path
/// where it cannot be read.
[[nodiscard]] Experiment read_experiment_file(const std::filesystem::path& path, const Overrides& overrides = {});

/// JSON Schema (draft 07) of experiment files, as reports/schemas has it.
[[nodiscard]] std::string experiment_schema_text();

/// The keys of experiment files as a table in Markdown, as lib/docs/formats.md has it.
[[nodiscard]] std::string experiment_table();

/// The place of a key of the format, `/accuracy` for `rerun_every`; of two, both. Absent: it has none, or stands at the top.
[[nodiscard]] std::optional<std::string> place_of_key(std::string_view key);

}  // namespace rocking
