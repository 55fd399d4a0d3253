#include "rocking/input/read_record_metadata.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/input/csv_table.hpp"
#include "rocking/input/record_tables.hpp"

namespace rocking {
namespace {

constexpr double largest_magnitude = 10.0;  // the largest earthquake ever recorded had 9.5
constexpr std::array<std::string_view, 3> known_columns{"file", "magnitude", "distance_km"};

class MetadataReader {
 public:
  explicit MetadataReader(const std::string& name) : lines_(name, problems_) {}

  std::vector<RecordMetadata> read(std::string_view text) {
    CsvTable rows(without_byte_order_mark(text), lines_);
    if (rows.next()) read_header(rows.fields());
    if (header_.empty() && !lines_.any()) {
      lines_.reject_file("has no line with the names of the columns", "begin it with: file,magnitude,distance_km");
    }
    while (rows.next()) read_record(rows.fields());
    if (!problems_.empty()) throw base::InputError(std::move(problems_));
    return std::move(records_);
  }

 private:
  void read_header(const std::vector<std::string>& values) {
    header_ = values;
    for (const std::string& column : values) {
      if (std::ranges::find(known_columns, column) == known_columns.end()) {
        lines_.reject_line(column, "is not a column of the metadata of records", "name: file, magnitude, distance_km");
      } else if (std::ranges::count(values, column) > 1) {
        lines_.reject_line(column, "stands twice", "name each column once");
      }
    }
    const bool has_more = values.size() > 1;
    if (std::ranges::find(values, "file") == values.end() || !has_more) {
      lines_.reject_line(values.front(), "does not name the columns",
                         "begin the file with: file,magnitude,distance_km");
    }
  }

  void read_record(const std::vector<std::string>& values) {
    RecordMetadata record;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (header_[i] == "file") {
        record.file = values[i];
        continue;
      }
      if (values[i].empty()) continue;  // not known
      const auto number = lines_.number(values[i]);
      if (!number) return;
      const bool is_magnitude = header_[i] == "magnitude";
      if (is_magnitude ? !(*number >= 0.0 && *number <= largest_magnitude) : !(*number > 0.0)) {
        return lines_.reject_line(
            values[i], is_magnitude ? "is not a magnitude from 0 to 10" : "must be positive",
            "give the " + header_[i] + "; leave the place between the commas empty if it is not known");
      }
      (header_[i] == "magnitude" ? record.magnitude : record.distance_km) = *number;
    }
    if (!files_.insert(record.file).second) {
      return lines_.reject_line(record.file, "stands twice", "give each record one line");
    }
    records_.push_back(std::move(record));
  }

  Problems problems_;
  LineProblems lines_;
  std::vector<std::string> header_;
  std::vector<RecordMetadata> records_;
  std::set<std::string> files_;
};

}  // namespace

std::vector<RecordMetadata> read_record_metadata(std::string_view text, const std::string& name) {
  if (!is_search_results(text)) return MetadataReader(name).read(text);
  Problems problems;
  std::vector<RecordMetadata> records;
  for (const SelectedRecord& found : search_results(text, name, problems)) {
    records.push_back({.file = found.file, .magnitude = found.magnitude, .distance_km = found.distance_km});
  }
  if (!problems.empty()) throw base::InputError(std::move(problems));
  return records;
}

}  // namespace rocking
