#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/input/line_problems.hpp"
#include "rocking/scene/counted_tests.hpp"

namespace rocking {

/// Largest size of a file of counted tests.
inline constexpr std::size_t most_tests_bytes = 1'000'000;

/// Reads counted tests: a line for each tested condition, of which the first names the columns. A column is a parameter
/// (a JSON pointer into the experiment, or its last key where only one has it), or else response modes with their
/// count: `(1,1)`, `chaotic`, `(1,1)|(3,3)` for modes that are counted together, `other` for all that no column has.
/// A parameter is a JSON value, or text.
///
/// `name`: of the file, for messages. Throws base::InputError with the line of each fault, also where the experiment
/// does not allow a value, with the unknowns at the ends of their ranges or between them. Files of the experiment are
/// seen from `folder`.
[[nodiscard]] CountedTests read_tests(std::string_view text, const std::string& name, const Experiment& experiment,
                                      const std::filesystem::path& folder);

/// Reads candidate conditions: the same without counts. Appends them to the tests.
void read_candidates(std::string_view text, const std::string& name, const Experiment& experiment,
                     const std::filesystem::path& folder, CountedTests& tests);

/// Largest number of columns of a file of tests.
inline constexpr std::size_t most_test_columns = 100;

/// What the columns of a file of tests are.
struct TestColumns {
  std::vector<std::string> parameters;  ///< JSON pointers; these columns come first
  std::vector<ModeGroup> groups;        ///< the columns after them
};

/// Reads the line that names the columns. Problems are reported; then what is returned is of no use.
[[nodiscard]] TestColumns read_test_columns(const std::vector<std::string>& names, const Experiment& experiment,
                                            LineProblems& problems);

}  // namespace rocking
