#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/input/line_problems.hpp"

namespace rocking {

/// In what a table differs from others.
struct CsvStyle {
  bool has_comments = true;         ///< `#` begins a comment, but between quotation marks
  bool do_blanks_separate = false;  ///< in a line without another separator
  bool does_empty_line_end = false;
};

/// Every table that is read, but ground motions: rows of fields, all with as many fields as the first row. A comma, a semicolon or a
/// tab separates fields. Between quotation marks and in brackets it is a character; between the former `""` is one of them.
class CsvTable {
 public:
  CsvTable(std::string_view text, LineProblems& problems, CsvStyle style = {})
      : text_(text), problems_(&problems), style_(style) {}

  /// Takes the next row that has a field with text. Reports each before it in which a quotation mark is not closed, or whose
  /// number of fields is not that of the first row. False at the end, and after five problems.
  [[nodiscard]] bool next();

  [[nodiscard]] const std::vector<std::string>& fields() const { return fields_; }
  [[nodiscard]] std::string_view line() const { return trimmed(line_); }
  /// What is not yet read.
  [[nodiscard]] std::string_view rest() const { return text_; }

 private:
  /// The fields of the present line; false, and reported, if a quotation mark is not closed.
  bool split();

  std::string_view text_;
  LineProblems* problems_;
  CsvStyle style_;
  std::string_view line_;
  std::vector<std::string> fields_;
  std::size_t columns_ = 0;
};

}  // namespace rocking
