#include "rocking/input/read_record_metadata.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/input/line_problems.hpp"
#include "rocking/input/record_tables.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_faults = 20;
constexpr double largest_magnitude = 10.0;  // the largest earthquake ever recorded had 9.5
constexpr std::array<std::string_view, 3> known_columns{"file", "magnitude", "distance_km"};

/// Without blanks and quotes around it.
std::string_view unquoted(std::string_view text) {
  text = trimmed(text);
  const bool is_quoted = text.size() > 1 && text.front() == '"' && text.back() == '"';
  return is_quoted ? text.substr(1, text.size() - 2) : text;
}

std::vector<std::string> values_in(std::string_view line) {
  std::vector<std::string> values;
  line = line.substr(0, line.find('#'));
  if (trimmed(line).empty()) return values;
  for (;;) {
    const std::size_t comma = line.find(',');
    values.emplace_back(unquoted(line.substr(0, comma)));
    if (comma == std::string_view::npos) return values;
    line.remove_prefix(comma + 1);
  }
}

std::optional<double> number_in(const std::string& text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

class MetadataReader {
 public:
  explicit MetadataReader(std::string name) : name_(std::move(name)) {}

  std::vector<RecordMetadata> read(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    while (!text.empty() && problems_.size() < most_faults) {
      ++line_;
      const std::size_t end = text.find('\n');
      const std::vector<std::string> values = values_in(text.substr(0, end));
      if (!values.empty()) header_.empty() ? read_header(values) : read_record(values);
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    if (header_.empty() && problems_.empty()) {
      reject("", "has no line with the names of the columns", "begin it with: file,magnitude,distance_km");
    }
    if (!problems_.empty()) throw base::InputError(std::move(problems_));
    return std::move(records_);
  }

 private:
  void reject(std::string value, std::string reason, std::string remedy) {
    problems_.push_back(
        {name_ + ", line " + std::to_string(line_), std::move(value), std::move(reason), std::move(remedy)});
  }

  void read_header(const std::vector<std::string>& values) {
    header_ = values;
    for (const std::string& column : values) {
      if (std::ranges::find(known_columns, column) == known_columns.end()) {
        reject(column, "is not a column of the metadata of records", "name: file, magnitude, distance_km");
      } else if (std::ranges::count(values, column) > 1) {
        reject(column, "stands twice", "name each column once");
      }
    }
    const bool has_more = values.size() > 1;
    if (std::ranges::find(values, "file") == values.end() || !has_more) {
      reject(values.front(), "does not name the columns", "begin the file with: file,magnitude,distance_km");
    }
  }

  void read_record(const std::vector<std::string>& values) {
    if (values.size() != header_.size()) {
      return reject(std::to_string(values.size()) + " values", "do not fit the columns",
                    "give " + std::to_string(header_.size()) + " values between commas");
    }
    RecordMetadata record;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (header_[i] == "file") {
        record.file = values[i];
        continue;
      }
      if (values[i].empty()) continue;  // not known
      const auto number = number_in(values[i]);
      if (!number) return reject(values[i], "is not a number", "give the " + header_[i] + " as a number");
      const bool is_magnitude = header_[i] == "magnitude";
      if (is_magnitude ? !(*number >= 0.0 && *number <= largest_magnitude) : !(*number > 0.0)) {
        return reject(values[i], is_magnitude ? "is not a magnitude from 0 to 10" : "must be positive",
                      "give the " + header_[i] + "; leave the place between the commas empty if it is not known");
      }
      (header_[i] == "magnitude" ? record.magnitude : record.distance_km) = *number;
    }
    if (!files_.insert(record.file).second) return reject(record.file, "stands twice", "give each record one line");
    records_.push_back(std::move(record));
  }

  std::string name_;
  std::vector<std::string> header_;
  std::vector<RecordMetadata> records_;
  std::set<std::string> files_;
  std::vector<base::Problem> problems_;
  std::size_t line_ = 0;
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
