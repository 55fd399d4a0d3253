#include "rocking/input/record_formats.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rocking/input/even_times.hpp"
#include "rocking/input/line_problems.hpp"
#include "rocking/input/lines_above_columns.hpp"
#include "rocking/input/missing_samples.hpp"
#include "rocking/input/record_unit.hpp"
#include "rocking/scene/ground_motion_reading.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

constexpr const char* name_the_columns =
    R"(say what they are: "columns": ["time", "horizontal"], also "vertical", and "other" for one that is not used)";

constexpr std::size_t most_columns = 5;  // of a file with a line for each sample that does not name them

std::string columns_in_words(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " column" : " columns");
}

class ColumnsReader {
 public:
  ColumnsReader(const GroundMotionReading& how, Problems& problems)
      : how_(how), problems_(how.name, problems), columns_(how.columns) {}

  std::optional<GroundMotion> read(std::string_view text) {
    text = without_byte_order_mark(text);
    if (problems_.reject_decimal_comma(text)) return std::nullopt;
    above_.read(text);
    while (!text.empty() && goes_on()) read_line(problems_.next_line(text));
    if (!problems_.any()) check_whole();
    if (problems_.any() && problems_.line() > 0 && !holds_numbers_ && columns_seen_) {
      problems_.reject_instead("is not a text file of numbers", "give a file with a line of numbers for each sample");
    }
    if (problems_.any()) return std::nullopt;
    motion_.has_vertical = std::ranges::find(columns_, RecordColumn::vertical) != columns_.end();
    for (const RecordColumn column : columns_) motion_.columns.push_back(name_of(column));
    motion_.unit = name_of(unit_);
    motion_.component = above_.component();
    motion_.unit_is_assumed = !how_.unit && !above_.stated_unit();
    if (motion_.unit_is_assumed) motion_.warnings.push_back(unit_assumed(unit_));
    if (!above_.warning().empty()) motion_.warnings.push_back(above_.warning());
    return std::move(motion_);
  }

 private:
  [[nodiscard]] bool goes_on() const {
    return !are_unknown_ && !problems_.enough() && motion_.samples.size() <= rules::most_samples;
  }

  void read_line(std::string_view line) {
    line = line.substr(0, line.find('#'));
    split_fields(line, fields_);
    const bool is_above = motion_.samples.empty() && (fields_.empty() || !is_number_field(fields_.front()));
    if (fields_.empty()) return;
    columns_seen_ = true;
    holds_numbers_ = holds_numbers_ || std::ranges::any_of(fields_, is_number_field);
    if (is_above) return read_header(line);
    if (!has_columns(line)) return;
    if (motion_.samples.empty() && !is_checked_) take_what_stands_above();
    if (!are_unknown_) read_sample();
  }

  /// A line of text above the numbers.
  void read_header(std::string_view line) {
    if (!how_.columns.empty() || has_header_) return;
    has_header_ = true;
    problems_.reject_line(line, "is a header, not a number; what the columns are is not read from it",
                          std::string(name_the_columns) + "; or put # before text that is not data");
  }

  void take_what_stands_above() {
    is_checked_ = true;
    const bool was_fine = !problems_.any();
    above_.check(columns_, how_.unit, problems_);
    are_unknown_ = was_fine && problems_.any();
    if (const auto stated = above_.stated_unit(); stated && !how_.unit) unit_ = *stated;
  }

  void read_sample() {
    dynamics::GroundMotionSample sample{};
    if (how_.time_step) sample.time = *how_.time_step * static_cast<double>(motion_.samples.size());
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      if (columns_[i] == RecordColumn::other) continue;
      const auto value = problems_.number(fields_[i]);
      if (!value) return;
      switch (columns_[i]) {
        case RecordColumn::time: sample.time = *value / above_.times_per_second(); break;
        case RecordColumn::horizontal: sample.horizontal = *value; break;
        case RecordColumn::vertical: sample.vertical = *value; break;
        case RecordColumn::other: break;
      }
    }
    if (!is_time(sample.time)) return;
    for (const auto& [column, value] : {std::pair{RecordColumn::horizontal, &sample.horizontal},
                                        std::pair{RecordColumn::vertical, &sample.vertical}}) {
      if (place_of(column)) missing_[column == RecordColumn::vertical ? 1 : 0].add(*value, problems_.line());
      if (!is_acceleration(*value, column)) return;
      *value = over_gravity(*value, unit_, how_.gravity);
    }
    if (const auto place = place_of(RecordColumn::time)) {
      digits_.add(fields_[*place]);
      times_.push_back(sample.time * above_.times_per_second());
    }
    motion_.samples.push_back(sample);
  }

  [[nodiscard]] std::optional<std::size_t> place_of(RecordColumn column) const {
    const auto place = std::ranges::find(columns_, column);
    if (place == columns_.end()) return std::nullopt;
    return static_cast<std::size_t>(place - columns_.begin());
  }

  /// Whether a line has the columns of the file; those that are not given are one, or a time and an acceleration.
  [[nodiscard]] bool has_columns(std::string_view line) {
    const std::size_t count = fields_.size();
    if (columns_.empty() && count == 1 && how_.time_step) columns_ = {RecordColumn::horizontal};
    if (columns_.empty() && count == 2 && !how_.time_step) columns_ = {RecordColumn::time, RecordColumn::horizontal};
    if (count == columns_.size()) return true;
    const std::string found = "has " + columns_in_words(count);
    if (!how_.columns.empty()) {
      problems_.reject_line(line, found + ", but \"columns\" names " + std::to_string(columns_.size()),
                            "name every column of the file; call those that are not used \"other\"");
    } else if (!columns_.empty()) {
      problems_.reject_line(line, found + ", but the lines before it have " + std::to_string(columns_.size()),
                            "give every line the same columns");
    } else if (count == 1) {
      problems_.reject_line(line, found,
                            "give time and horizontal acceleration; for values at even spacing set \"time_step_s\"");
    } else if (count >= most_columns) {
      are_unknown_ = true;
      problems_.reject_line(
          line, found + ", which are likely accelerations that run on from line to line",
          "put a line NPTS= 4000, DT= .01 SEC above them, with their number and time step, and give \"units\"");
    } else {
      are_unknown_ = true;
      problems_.reject_line(
          line, found + (how_.time_step ? " beside \"time_step_s\"" : "") + "; what they are is not guessed",
          std::string(name_the_columns) + (how_.time_step ? "; for a column of times omit \"time_step_s\"" : ""));
    }
    return false;
  }

  [[nodiscard]] bool is_time(double time) {
    const std::string_view field = fields_[place_of(RecordColumn::time).value_or(0)];
    if (how_.time_step && time > rules::latest_sample) {
      problems_.reject_line(field, "is later than 1e7 s", "check \"time_step_s\", or give a shorter ground motion");
      return false;
    }
    if (const auto refusal = refuse_sample_time(time)) {
      problems_.reject_line(field, refusal->reason, refusal->remedy);
      return false;
    }
    if (!motion_.samples.empty() && time < motion_.samples.back().time) {
      const Refusal refusal = sample_falls_back(Json(motion_.samples.back().time).dump());
      problems_.reject_line(field, refusal.reason, refusal.remedy);
      return false;
    }
    return true;
  }

  [[nodiscard]] bool is_acceleration(double value, RecordColumn column) {
    if (MissingSamples::is_mark_alone(value)) return true;
    const auto refusal = refuse_acceleration(value, in_m_s2(unit_, how_.gravity));
    if (refusal) problems_.reject_line(fields_[place_of(column).value_or(0)], refusal->reason, refusal->remedy);
    return !refusal;
  }

  void check_whole() {
    if (const auto refusal = refuse_samples(motion_.samples)) {
      return problems_.reject_file(refusal->reason, refusal->remedy);
    }
    for (const MissingSamples& missing : missing_) missing.check(problems_);
    if (problems_.any()) return;
    motion_.time_step = how_.time_step;
    const auto too_long = refuse_long_steps(motion_.samples);
    if (how_.time_step) {
      if (too_long) problems_.reject_file(too_long->reason, "check \"time_step_s\": 10 ms is 0.01");
      return;
    }
    Evenness evenness = evenness_of(times_, digits_);
    if (above_.times_per_second() != 1.0) evenness = evenness.in_seconds(above_.times_per_second());
    if (how_.columns.empty() && !evenness.is_progression) {
      return problems_.reject_file(
          "has two columns, of which the first does not rise in even steps: it may be no time",
          std::string(name_the_columns) + "; for two components at even spacing set \"time_step_s\", too");
    }
    if (too_long) return problems_.reject_file(too_long->reason, too_long->remedy);
    if (evenness.is_even()) {
      motion_.time_step = evenness.step;
    } else {
      motion_.warnings.push_back(uneven_in_words(evenness, "call this column \"other\" and give \"time_step_s\""));
    }
  }

  const GroundMotionReading& how_;
  LineProblems problems_;
  RecordUnit unit_ = how_.unit.value_or(RecordUnit::m_s2);
  GroundMotion motion_;
  LinesAboveColumns above_;
  std::vector<RecordColumn> columns_;  ///< empty until they are known
  std::vector<std::string_view> fields_;
  std::vector<double> times_;              ///< of the column of times
  PrintedDigits digits_;                   ///< likewise
  std::array<MissingSamples, 2> missing_;  ///< of the horizontal and the vertical column
  bool is_checked_ = false;                ///< what stands above the numbers
  bool has_header_ = false;
  bool are_unknown_ = false;    ///< the columns, or what stands above them: one problem says so
  bool columns_seen_ = false;   ///< in any line
  bool holds_numbers_ = false;  ///< some field of some line is a number
};

}  // namespace

std::optional<GroundMotion> read_columns(std::string_view text, const GroundMotionReading& how, Problems& problems) {
  return ColumnsReader(how, problems).read(text);
}

}  // namespace rocking
