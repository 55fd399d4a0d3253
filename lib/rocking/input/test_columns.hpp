#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/input/line_problems.hpp"
#include "rocking/scene/counted_tests.hpp"

namespace rocking {

/// Largest number of columns of a file of tests.
inline constexpr std::size_t most_test_columns = 100;

/// The fields of a line, without blanks and quotation marks around them. A separator within quotation marks or
/// parentheses belongs to the field; two quotation marks within others are one. A comment is left out. A quotation mark
/// that is not closed is reported; then there are no fields.
[[nodiscard]] std::vector<std::string> test_fields(std::string_view line, LineProblems& problems);

/// What the columns of a file of tests are.
struct TestColumns {
  std::vector<std::string> parameters;  ///< JSON pointers; these columns come first
  std::vector<ModeGroup> groups;        ///< the columns after them
};

/// Reads the line that names the columns. Problems are reported; then what is returned is of no use.
[[nodiscard]] TestColumns read_test_columns(const std::vector<std::string>& names, const Experiment& experiment,
                                            LineProblems& problems);

}  // namespace rocking
