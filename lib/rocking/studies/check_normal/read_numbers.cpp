#include <algorithm>

#include "rocking/base/error.hpp"
#include "rocking/input/line_problems.hpp"
#include "rocking/studies/check_normal/study.hpp"

namespace rocking {
namespace {

constexpr std::size_t least_numbers = 20;

/// Fields between commas, semicolons or tabs.
std::vector<std::string_view> fields_in(std::string_view line) {
  std::vector<std::string_view> fields;
  while (true) {
    const std::size_t end = line.find_first_of(",;\t");
    std::string_view field = trimmed(line.substr(0, end));
    if (field.size() > 1 && field.front() == '"' && field.back() == '"') field = field.substr(1, field.size() - 2);
    fields.push_back(field);
    if (end == line.npos) return fields;
    line.remove_prefix(end + 1);
  }
}

/// The place of the numbers among the fields of the first line, which may name them; reports where that is not known.
std::size_t column_in(std::string_view line, const std::optional<std::string>& name, LineProblems& problems) {
  const std::vector<std::string_view> fields = fields_in(line);
  if (name) {
    const auto found = std::ranges::find(fields, *name);
    if (found != fields.end()) return static_cast<std::size_t>(found - fields.begin());
    problems.reject_line(*name, "is no column that this line names", "give --column as it stands there");
  } else if (fields.size() > 1) {
    problems.reject_line(line, "has several columns", "name one of its first line with --column");
  }
  return 0;
}

}  // namespace

std::vector<double> read_numbers(std::string_view text, const std::string& name,
                                 const std::optional<std::string>& column) {
  std::vector<base::Problem> found;
  LineProblems problems(name, found);
  std::vector<double> numbers;
  text = without_byte_order_mark(text);
  bool is_first = true;
  std::size_t place = 0, width = 1;
  while (!text.empty() && !problems.enough()) {
    const std::string_view whole = problems.next_line(text);
    const std::string_view line = trimmed(whole.substr(0, whole.find('#')));
    if (line.empty()) continue;
    const std::vector<std::string_view> fields = fields_in(line);
    const bool is_header = is_first && (column || !is_number_field(fields.front()));
    if (is_first) {
      place = column_in(line, column, problems);
      width = fields.size();
      if (problems.any()) break;
    }
    is_first = false;
    if (is_header) continue;
    if (fields.size() != width) {
      problems.reject_line(
          line, "has " + std::to_string(fields.size()) + " fields, and the first line " + std::to_string(width),
          "give as many; a decimal point is a point");
      continue;
    }
    if (const auto number = problems.number(fields[place])) numbers.push_back(*number);
  }
  if (!problems.any() && numbers.size() < least_numbers) {
    problems.reject_file("has " + std::to_string(numbers.size()) + " numbers", "give at least 20: fewer tell nothing");
  }
  if (!found.empty()) throw base::InputError(std::move(found));
  return numbers;
}

}  // namespace rocking
