#include <algorithm>

#include "rocking/base/error.hpp"
#include "rocking/input/csv_table.hpp"
#include "rocking/studies/check_normal/study.hpp"

namespace rocking {
namespace {

constexpr std::size_t least_numbers = 20;

/// The place of the numbers among the fields of the first line, which may name them; reports where that is not known.
std::size_t column_in(const CsvTable& rows, const std::optional<std::string>& name, LineProblems& problems) {
  const std::vector<std::string>& fields = rows.fields();
  if (name) {
    const auto found = std::ranges::find(fields, *name);
    if (found != fields.end()) return static_cast<std::size_t>(found - fields.begin());
    problems.reject_line(*name, "is no column that this line names", "give --column as it stands there");
  } else if (fields.size() > 1) {
    problems.reject_line(rows.line(), "has several columns", "name one of its first line with --column");
  }
  return 0;
}

}  // namespace

std::vector<double> read_numbers(std::string_view text, const std::string& name,
                                 const std::optional<std::string>& column) {
  std::vector<base::Problem> found;
  LineProblems problems(name, found);
  std::vector<double> numbers;
  CsvTable rows(without_byte_order_mark(text), problems);
  const bool has_rows = rows.next();
  const std::size_t place = has_rows ? column_in(rows, column, problems) : 0;
  const bool is_header = has_rows && (column || !is_number_field(rows.fields().front()));
  bool goes_on = has_rows && !problems.any() && (!is_header || rows.next());
  for (; goes_on; goes_on = rows.next()) {
    if (const auto number = problems.number(rows.fields()[place])) numbers.push_back(*number);
  }
  if (!problems.any() && numbers.size() < least_numbers) {
    problems.reject_file("has " + std::to_string(numbers.size()) + " numbers", "give at least 20: fewer tell nothing");
  }
  if (!found.empty()) throw base::InputError(std::move(found));
  return numbers;
}

}  // namespace rocking
