#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/base/error.hpp"

namespace rocking {

/// Collects the problems of a text file that is read line by line, each with file, line and value.
class LineProblems {
 public:
  /// `name`: of the file, as shown to users; `line`: the present one.
  LineProblems(std::string name, Problems& problems, std::size_t line = 0)
      : name_(std::move(name)), problems_(&problems), line_(line) {}

  /// Takes the next line off the front of `text`, without its end, and counts it.
  [[nodiscard]] std::string_view next_line(std::string_view& text);

  /// Reports `found`, which stands in the present line, or the file as a whole.
  void reject_line(std::string_view found, std::string reason, std::string remedy);
  /// Likewise in a line that was read before.
  void reject_line_at(std::size_t line, std::string_view found, std::string reason, std::string remedy);
  void reject_file(std::string reason, std::string remedy);
  /// Takes back what was reported, in favour of one problem of the file as a whole.
  void reject_instead(std::string reason, std::string remedy);

  /// Reports the first line of `text`, which begins behind the present line, in which a comma is or may be a decimal
  /// point (line_with_decimal_comma). Returns whether there is one.
  bool reject_decimal_comma(std::string_view text);

  /// The number that a field of the present line is; if it is none, reports it.
  [[nodiscard]] std::optional<double> number(std::string_view field);

  [[nodiscard]] std::size_t line() const { return line_; }
  [[nodiscard]] bool any() const { return count_ > 0; }
  /// Whether further lines should not be read: five problems were reported.
  [[nodiscard]] bool enough() const { return count_ >= 5; }

 private:
  std::string name_;
  Problems* problems_;
  std::size_t line_;
  std::size_t count_ = 0;
};

/// Takes the first line off the front of `text`, without its end.
[[nodiscard]] std::string_view take_line(std::string_view& text);

[[nodiscard]] std::string in_small_letters(std::string text);

/// `text` without blanks around it.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// The fields of a line, between blanks or one comma or semicolon. Between two commas stands an empty field.
void split_fields(std::string_view line, std::vector<std::string_view>& fields);

/// Whether a field is a number and nothing else; between quotation marks or with Fortran's exponent `1.2D-02`, too.
[[nodiscard]] bool is_number_field(std::string_view field);

struct TextLine {
  std::size_t number = 0;  ///< from 1
  std::string_view text;
};

/// The first line of numbers in which a comma is a decimal point, or may be one:
/// - `0,12 3,4` or `0,12;3,4`: a number with one comma beside others that blanks or semicolons separate;
/// - `0,123`, `0,01,-0,12`: pairs of whole numbers between commas and nothing else, if no other line of the text shows
///   that its commas separate columns, as `0.5,3`, `1,-2` and `1, 2` do.
/// Lines with other characters than those of numbers do not count; `#` begins a comment.
[[nodiscard]] std::optional<TextLine> line_with_decimal_comma(std::string_view text);

/// `text` without a byte order mark.
[[nodiscard]] std::string_view without_byte_order_mark(std::string_view text);

}  // namespace rocking
