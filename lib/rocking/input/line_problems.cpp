#include "rocking/input/line_problems.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include "rocking/text/json.hpp"

namespace rocking {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool is_comma(char c) { return c == ',' || c == ';'; }

/// Takes digits off the front of `text`, and returns whether there were any.
bool take_digits(std::string_view& text) {
  const std::size_t length = std::min(text.find_first_not_of("0123456789"), text.size());
  text.remove_prefix(length);
  return length > 0;
}

/// Takes a number with a decimal comma off the front of `text`: `-0,12`, `1,5E-3`.
bool take_number_with_comma(std::string_view& text) {
  if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
  if (!take_digits(text) || !text.starts_with(',')) return false;
  text.remove_prefix(1);
  if (!take_digits(text)) return false;
  if (!text.starts_with('e') && !text.starts_with('E')) return true;
  text.remove_prefix(1);
  if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
  return take_digits(text);
}

enum class Commas : std::uint8_t { none, decimal, decimal_or_separating, separating };

/// What the commas of a line of numbers are.
Commas commas_of(std::string_view line) {
  if (line.find(',') == std::string_view::npos) return Commas::none;
  if (line.find_first_not_of("0123456789+-.,;eE \t\r") != std::string_view::npos) return Commas::none;
  constexpr std::string_view separators = "; \t\r";
  std::size_t words = 0;
  bool has_number_with_comma = false;
  bool are_pairs = false;
  while (!line.empty()) {
    line.remove_prefix(std::min(line.find_first_not_of(separators), line.size()));
    std::string_view word = line.substr(0, line.find_first_of(separators));
    if (word.empty()) break;
    line.remove_prefix(word.size());
    ++words;
    are_pairs = take_number_with_comma(word);
    has_number_with_comma = has_number_with_comma || (are_pairs && word.empty());
    while (are_pairs && !word.empty()) {
      are_pairs = word.starts_with(',');
      word.remove_prefix(1);
      are_pairs = are_pairs && take_number_with_comma(word);
    }
  }
  if (words > 1) return has_number_with_comma ? Commas::decimal : Commas::separating;
  return are_pairs ? Commas::decimal_or_separating : Commas::separating;
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

void split_fields(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  const auto skip_blanks = [&line] {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
  };
  for (skip_blanks(); !line.empty();) {
    std::size_t length = 0;
    while (length < line.size() && !is_blank(line[length]) && !is_comma(line[length])) ++length;
    fields.push_back(line.substr(0, length));
    line.remove_prefix(length);
    skip_blanks();
    if (line.empty() || !is_comma(line.front())) continue;
    line.remove_prefix(1);
    skip_blanks();
    if (line.empty()) fields.push_back(line);
  }
}

namespace {

/// Of a number as spreadsheets and Fortran write it, `"0.01"` and `1.2D-02`, the number.
std::string_view as_number(std::string_view field, std::string& spelled) {
  if (field.size() > 2 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
  const std::size_t exponent = field.find_first_of("dD");
  if (exponent == std::string_view::npos || exponent == 0 || exponent + 1 == field.size()) return field;
  spelled = field;
  spelled[exponent] = 'e';
  return spelled;
}

}  // namespace

bool is_number_field(std::string_view field) {
  std::string spelled;
  field = as_number(field, spelled);
  if (field.starts_with('+')) field.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  return !field.empty() && error != std::errc::invalid_argument && end == field.data() + field.size();
}

std::optional<TextLine> line_with_decimal_comma(std::string_view text) {
  std::optional<TextLine> first;
  bool do_commas_separate = false;
  for (std::size_t number = 1; !text.empty(); ++number) {
    std::string_view line = take_line(text);
    line = line.substr(0, line.find('#'));
    const Commas commas = commas_of(line);
    if (commas == Commas::decimal) return TextLine{number, line};
    if (commas == Commas::separating) do_commas_separate = true;
    if (commas == Commas::decimal_or_separating && !first) first = TextLine{number, line};
  }
  return do_commas_separate ? std::nullopt : first;
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return text;
}

std::string in_small_letters(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

std::string_view LineProblems::next_line(std::string_view& text) {
  ++line_;
  return take_line(text);
}

void LineProblems::reject_line(std::string_view found, std::string reason, std::string remedy) {
  ++count_;
  problems_->push_back({name_ + ", line " + std::to_string(line_), brief(Json(std::string(found))), std::move(reason),
                        std::move(remedy)});
}

void LineProblems::reject_line_at(std::size_t line, std::string_view found, std::string reason, std::string remedy) {
  const std::size_t present = std::exchange(line_, line);
  reject_line(found, std::move(reason), std::move(remedy));
  line_ = present;
}

void LineProblems::reject_file(std::string reason, std::string remedy) {
  ++count_;
  problems_->push_back({name_, "", std::move(reason), std::move(remedy)});
}

void LineProblems::reject_instead(std::string reason, std::string remedy) {
  problems_->resize(problems_->size() - count_);
  count_ = 0;
  reject_file(std::move(reason), std::move(remedy));
}

bool LineProblems::reject_decimal_comma(std::string_view text) {
  const auto found = line_with_decimal_comma(text);
  if (!found) return false;
  reject_line_at(line_ + found->number, found->text,
                 "has a decimal comma, or whole numbers between commas, which cannot be told from it",
                 "write decimal points; between columns of whole numbers write blanks");
  return true;
}

std::optional<double> LineProblems::number(std::string_view field) {
  std::string spelled;
  std::string_view digits = as_number(field, spelled);
  if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  const bool all_read = end == digits.data() + digits.size();
  if (field.empty()) {
    reject_line(field, "is an empty field", "give a number, or remove the comma");
  } else if (error == std::errc::invalid_argument || !all_read) {
    reject_line(field, "is not a number", "write it as 0.25 or 2.5e-1, and put # before text that is not data");
  } else if (error == std::errc::result_out_of_range) {
    reject_line(field, "is outside the range of doubles, 5e-324 to 1.8e308", "give a finite number, or 0");
  } else if (!std::isfinite(value)) {
    reject_line(field, "is not finite", "give a number; omit the line if nothing was recorded");
  } else {
    return value;
  }
  return std::nullopt;
}

}  // namespace rocking
