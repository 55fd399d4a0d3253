#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/base/error.hpp"
#include "rocking/scene/experiment.hpp"

/// Marks the functions that the shared library exports. All others have hidden visibility.
#define ROCKING_API __attribute__((visibility("default")))

/// Experiments: from a file, from JSON text, or from conditions made in C++.
namespace rocking {

/// Reads an experiment file (`rocking.experiment/1`), works out its sweep and checks every condition; `overrides` stand
/// in place of values of the file. Throws
/// base::InputError with all problems found, each with its JSON pointer, and std::system_error with the path where the
/// file, or one that it names, cannot be read.
[[nodiscard]] ROCKING_API Experiment read_experiment(const std::filesystem::path& file,
                                                     const Overrides& overrides = {});

/// The same of JSON text; `folder` is that of the files that the text names, `name` stands for the text in problems. Without a
/// name they tell no lines: the user has not seen the text.
[[nodiscard]] ROCKING_API Experiment parse_experiment(std::string_view text, const std::filesystem::path& folder = ".",
                                                      const std::string& name = "experiment",
                                                      const Overrides& overrides = {});

/// What is declared beside the conditions.
struct Declaration {
  std::uint64_t seed = 0;
  std::string title = {};
};

/// An experiment of conditions that are made in C++, without JSON text; they need not be on a grid. Throws
/// base::InputError with all problems found. Such an experiment can be run in memory only, because a folder keeps the
/// text of its experiment.
[[nodiscard]] ROCKING_API Experiment experiment_of(std::vector<Condition> conditions,
                                                   const Declaration& declaration = {});

/// The experiment as JSON text with every default written out: equal for equal experiments. Empty for one made in C++.
[[nodiscard]] inline const std::string& text_of(const Experiment& experiment) { return experiment.canonical_text; }

/// A valid experiment, and the problems of one that is not, as JSON text: what `rocking validate --json` prints.
[[nodiscard]] ROCKING_API std::string describe_as_json(const Experiment& experiment);
[[nodiscard]] ROCKING_API std::string describe_as_json(const base::InputError& problems);

/// `(1,3)`, `chaotic`, `overturned`, `slide`, `rest` or `unresolved`.
[[nodiscard]] ROCKING_API std::string name_of(const section::ResponseMode& mode);

/// The colour of a response mode in all figures, as `#rrggbb`.
[[nodiscard]] ROCKING_API std::string_view colour_of(const section::ResponseMode& mode);

/// The mode that name_of gives this name; absent if there is none.
[[nodiscard]] ROCKING_API std::optional<section::ResponseMode> mode_named(std::string_view name);

/// Version of the library, MAJOR.MINOR.PATCH. In 0.x a minor version may change the interface.
[[nodiscard]] ROCKING_API std::string version();

}  // namespace rocking
