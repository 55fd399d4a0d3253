#include "rocking/input/record_tables.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "rocking/input/line_problems.hpp"

namespace rocking {
namespace {

constexpr std::string_view line_of_metadata = "Summary of Metadata of Selected Records";

/// The values of a line between commas. In one that is quoted a comma is a character, and `""` is a quotation mark.
std::vector<std::string> quoted_values(std::string_view line) {
  std::vector<std::string> values(1);
  bool is_quoted = false;
  for (const char c : line) {
    if (c == '"') is_quoted = !is_quoted;
    if (c == ',' && !is_quoted) {
      values.emplace_back();
    } else if (c != '"' && c != '\r') {
      values.back() += c;
    }
  }
  for (std::string& value : values) value = std::string(trimmed(value));
  return values;
}

std::string in_small_letters(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// Lines of values below a line with the names of the columns.
class RecordTable {
 public:
  RecordTable(std::string_view text, const std::string& name, Problems& problems)
      : text_(text), problems_(name, problems) {}

  /// Skips lines up to one with these words, and reads the names of the columns from the next one.
  bool begin_below(std::string_view words) {
    while (!text_.empty()) {
      if (problems_.next_line(text_).find(words) != std::string_view::npos) return begin();
    }
    return false;
  }
  /// Reads the names of the columns from the next line that is not empty.
  bool begin() {
    while (names_.empty() && !text_.empty()) {
      line_ = problems_.next_line(text_);
      if (!is_empty()) names_ = quoted_values(line_);
    }
    for (std::string& name : names_) name = in_small_letters(std::move(name));
    return !names_.empty();
  }
  /// Takes the next line; false at the end, or at one without values.
  bool next() {
    if (text_.empty() || problems_.enough()) return false;
    line_ = problems_.next_line(text_);
    values_ = quoted_values(line_);
    return true;
  }
  [[nodiscard]] bool is_empty() const { return line_.find_first_not_of(", \t\r") == std::string_view::npos; }

  [[nodiscard]] bool has(std::string_view column) const { return std::ranges::find(names_, column) != names_.end(); }
  /// Empty where the column or its value is missing.
  [[nodiscard]] std::string value(std::string_view column) const {
    const auto found = std::ranges::find(names_, column);
    const auto place = static_cast<std::size_t>(found - names_.begin());
    return place < values_.size() && found != names_.end() ? values_[place] : std::string();
  }
  /// A number above `least`; absent where it is not known: nothing, `-`, -999. Reported if it is none.
  std::optional<double> number(std::string_view column, double least = 0.0) {
    const std::string written = value(column);
    if (written.find_first_not_of("- ") == std::string::npos) return std::nullopt;
    const auto found = problems_.number(written);
    constexpr double unknown = -999.0;
    if (!found || *found == unknown) return std::nullopt;
    if (*found > least) return found;
    problems_.reject_line(written, "is the " + std::string(column) + ", which must be positive",
                          "correct it; leave the place empty if it is not known");
    return std::nullopt;
  }

  [[nodiscard]] LineProblems& problems() { return problems_; }

 private:
  std::string_view text_;
  LineProblems problems_;
  std::string_view line_;
  std::vector<std::string> names_;
  std::vector<std::string> values_;
};

}  // namespace

bool is_search_results(std::string_view text) { return text.find(line_of_metadata) != std::string_view::npos; }

std::vector<SelectedRecord> search_results(std::string_view text, const std::string& name, Problems& problems) {
  constexpr std::array<std::string_view, 2> of_files{"horizontal-1 acc. filename", "horizontal-2 acc. filename"};
  RecordTable table(text, name, problems);
  std::vector<SelectedRecord> records;
  if (!table.begin_below(line_of_metadata) || !table.has(of_files[0])) {
    table.problems().reject_file("has no column \"Horizontal-1 Acc. Filename\" below its line of metadata",
                                 "give _SearchResults.csv as PEER's database writes it");
    return {};
  }
  while (table.next() && !table.is_empty()) {
    SelectedRecord record{.file = {},
                          .factor = table.number("scale factor"),
                          .magnitude = table.number("magnitude"),
                          .distance_km = table.number("rrup (km)")};
    if (!record.distance_km) record.distance_km = table.number("clstd (km)");
    for (const std::string_view column : of_files) {
      record.file = table.value(column);
      if (record.file.find_first_not_of("- ") != std::string::npos) records.push_back(record);
    }
  }
  if (records.empty() && !table.problems().any()) {
    table.problems().reject_file("names no horizontal record", "select records in PEER's database");
  }
  return records;
}

std::vector<SelectedRecord> level_table(std::string_view text, const std::string& name, Problems& problems) {
  RecordTable table(without_byte_order_mark(text), name, problems);
  std::vector<SelectedRecord> records;
  static_cast<void>(table.begin());
  for (const std::string_view column : {"level", "file", "factor"}) {
    if (table.has(column)) continue;
    table.problems().reject_file("has no column \"" + std::string(column) + '"', "begin it with: level,file,factor");
  }
  if (table.problems().any()) return {};
  while (table.next()) {
    if (table.is_empty()) continue;
    SelectedRecord record{
        .file = table.value("file"), .factor = table.number("factor"), .level = table.number("level")};
    if (table.has("component")) record.component = table.value("component");
    if (record.component && record.component->empty()) record.component.reset();
    if (!table.problems().any() && (record.file.empty() || !record.factor || !record.level)) {
      table.problems().reject_line(record.file, "is a line without a level, a file or a factor",
                                   "give the three in each line");
    }
    records.push_back(std::move(record));
  }
  if (records.empty() && !table.problems().any()) {
    table.problems().reject_file("has no line below the names of its columns",
                                 "give a line for each record of a level");
  }
  return records;
}

}  // namespace rocking
