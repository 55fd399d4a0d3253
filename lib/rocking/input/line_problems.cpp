#include "rocking/input/line_problems.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

namespace rocking {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool is_comma(char c) { return c == ',' || c == ';'; }

}  // namespace

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

bool is_number_field(std::string_view field) {
  if (field.starts_with('+')) field.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  return !field.empty() && error != std::errc::invalid_argument && end == field.data() + field.size();
}

std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
  return text;
}

std::string_view LineProblems::next_line(std::string_view& text) {
  ++line_;
  const std::size_t end = text.find('\n');
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return line;
}

void LineProblems::reject_line(std::string_view found, std::string reason, std::string remedy) {
  ++count_;
  problems_->push_back({name_ + ", line " + std::to_string(line_), brief(Json(std::string(found))), std::move(reason),
                        std::move(remedy)});
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

std::optional<double> LineProblems::number(std::string_view field) {
  std::string_view digits = field;
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
