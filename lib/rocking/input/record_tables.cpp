#include "rocking/input/record_tables.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "rocking/input/csv_table.hpp"

namespace rocking {
namespace {

constexpr std::string_view line_of_metadata = "Summary of Metadata of Selected Records";

/// Rows below a row with the names of the columns.
class RecordTable {
 public:
  RecordTable(std::string_view text, LineProblems& problems, CsvStyle style = {})
      : problems_(problems), rows_(text, problems, style) {
    if (rows_.next()) names_ = rows_.fields();
    for (std::string& name : names_) name = in_small_letters(std::move(name));
  }

  [[nodiscard]] bool next() { return rows_.next(); }
  [[nodiscard]] std::string_view line() const { return rows_.line(); }
  [[nodiscard]] std::string_view rest() const { return rows_.rest(); }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
  [[nodiscard]] bool has(std::string_view column) const { return count(column) > 0; }
  /// Reports the column if it is not there once.
  void require(std::string_view column, std::string remedy) {
    const auto found = count(column);
    if (found == 1) return;
    problems_.reject_file((found == 0 ? "has no column \"" : "has several columns \"") + std::string(column) + '"',
                          std::move(remedy));
  }

  /// Empty where there is no such column.
  [[nodiscard]] std::string value(std::string_view column) const {
    const auto found = std::ranges::find(names_, in_small_letters(std::string(column)));
    return found == names_.end() ? std::string() : rows_.fields()[static_cast<std::size_t>(found - names_.begin())];
  }
  /// A number above 0; absent where it is not known: nothing, `-`, -999. Reported if it is none.
  std::optional<double> number(std::string_view column) {
    const std::string written = value(column);
    if (written.find_first_not_of("- ") == std::string::npos) return std::nullopt;
    const auto found = problems_.number(written);
    constexpr double unknown = -999.0;
    if (!found || *found == unknown) return std::nullopt;
    if (*found > 0.0) return found;
    problems_.reject_line(written, "is the " + std::string(column) + ", which must be positive",
                          "correct it; leave the place empty if it is not known");
    return std::nullopt;
  }

 private:
  [[nodiscard]] std::ptrdiff_t count(std::string_view column) const {
    return std::ranges::count(names_, in_small_letters(std::string(column)));
  }

  LineProblems& problems_;
  CsvTable rows_;
  std::vector<std::string> names_;  ///< in small letters: PEER has written them in several ways
};

constexpr std::array<std::string_view, 2> columns_of_files{"Horizontal-1 Acc. Filename", "Horizontal-2 Acc. Filename"};

/// Takes lines off the front of `text` up to the one with these words.
void skip_to(std::string_view words, std::string_view& text, LineProblems& problems) {
  while (!text.empty() && problems.next_line(text).find(words) == std::string_view::npos) {
  }
}

/// PEER's explanations follow the first empty line. A record among them would be lost.
void refuse_records_in(std::string_view text, LineProblems& problems) {
  while (!text.empty() && !problems.enough()) {
    const std::string_view line = problems.next_line(text);
    const std::string small = in_small_letters(std::string(line));
    const std::size_t ending = small.find(".at2");
    if (ending == std::string::npos || ending == 0 || small[ending - 1] == ' ') continue;
    problems.reject_line(trimmed(line), "names a record behind the empty line that ends the table",
                         "remove the empty line, or the record");
  }
}

/// Both horizontal components of a row; dashes stand for one that does not exist.
void add_components(const RecordTable& table, SelectedRecord record, std::vector<SelectedRecord>& records,
                    LineProblems& problems) {
  const std::size_t before = records.size();
  for (const std::string_view column : columns_of_files) {
    record.file = table.value(column);
    if (record.file.empty()) {
      return problems.reject_line(table.line(), "has no " + std::string(column),
                                  "complete the row; write ----- for a component that does not exist");
    }
    if (record.file.find_first_not_of('-') != std::string::npos) records.push_back(record);
  }
  if (records.size() == before) problems.reject_line(table.line(), "names no horizontal record", "remove the row");
}

}  // namespace

bool is_search_results(std::string_view text) { return text.find(line_of_metadata) != std::string_view::npos; }

std::vector<SelectedRecord> search_results(std::string_view text, const std::string& name, Problems& found) {
  LineProblems problems(name, found);
  skip_to(line_of_metadata, text, problems);
  RecordTable table(text, problems, {.has_comments = false, .does_empty_line_end = true});
  const std::string_view distance = table.has("ClstD (km)") ? "ClstD (km)" : "Rrup (km)";
  for (const std::string_view column : {columns_of_files[0], columns_of_files[1], std::string_view("Scale Factor"),
                                        std::string_view("Magnitude"), distance}) {
    table.require(column, "give _SearchResults.csv as PEER's database writes it");
  }
  std::vector<SelectedRecord> records;
  if (problems.any()) return records;
  while (table.next()) {
    SelectedRecord record{.file = {},
                          .factor = table.number("Scale Factor"),
                          .magnitude = table.number("Magnitude"),
                          .distance_km = table.number("Rrup (km)")};
    if (!record.distance_km) record.distance_km = table.number("ClstD (km)");
    add_components(table, std::move(record), records, problems);
  }
  refuse_records_in(table.rest(), problems);
  if (records.empty() && !problems.any()) {
    problems.reject_file("names no horizontal record", "select records in PEER's database");
  }
  return records;
}

std::vector<SelectedRecord> level_table(std::string_view text, const std::string& name, Problems& found) {
  LineProblems problems(name, found);
  RecordTable table(without_byte_order_mark(text), problems);
  const std::string remedy = "begin it with: level,file,factor";
  constexpr std::array<std::string_view, 4> of_periods{"return_period_years", "return_period", "return period", "rp"};
  const std::vector<std::string> names = table.names();
  const auto period = std::ranges::find_first_of(of_periods, names);
  const bool has_periods = period != of_periods.end() && std::ranges::find(names, "level") == names.end();
  const std::string_view level = has_periods ? *period : "level";
  for (const std::string_view column : {level, std::string_view("file"), std::string_view("factor")}) {
    table.require(column, remedy);
  }
  for (const std::string& column : table.names()) {
    const std::array<std::string_view, 5> known{level, "file", "factor", "component", ""};
    if (std::ranges::find(known, column) != known.end()) continue;
    problems.reject_file("has the column \"" + column + "\", which is not known", remedy + ", perhaps with component");
  }
  std::vector<SelectedRecord> records;
  if (problems.any()) return records;
  while (table.next()) {
    SelectedRecord record{.file = table.value("file"),
                          .factor = table.number("factor"),
                          .level = table.number(level),
                          .is_return_period = has_periods};
    if (!table.value("component").empty()) record.component = table.value("component");
    if (!problems.any() && (record.file.empty() || !record.factor || !record.level)) {
      problems.reject_line(table.line(), "is a line without a level, a file or a factor",
                           "give the three in each line");
    }
    records.push_back(std::move(record));
  }
  if (records.empty() && !problems.any()) {
    problems.reject_file("has no line below the names of its columns", "give a line for each record of a level");
  }
  return records;
}

}  // namespace rocking
