#include "rocking/input/record_formats.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "rocking/input/line_problems.hpp"
#include "rocking/input/record_unit.hpp"
#include "rocking/scene/check_ground_motion.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

class ColumnsReader {
 public:
  ColumnsReader(const GroundMotionReading& how, Problems& problems) : how_(how), problems_(how.name, problems) {}

  std::optional<GroundMotion> read(std::string_view text) {
    text = without_byte_order_mark(text);
    while (!text.empty() && goes_on()) read_line(problems_.next_line(text));
    if (!problems_.any()) check_whole();
    if (problems_.any() && problems_.line() > 0 && !holds_numbers_ && columns_seen_) {
      problems_.reject_instead("is not a text file of numbers", "give a file with a line of numbers for each sample");
    }
    if (problems_.any()) return std::nullopt;
    motion_.has_vertical = columns_ == first_value() + 2;
    motion_.time_step = how_.time_step;
    return std::move(motion_);
  }

 private:
  [[nodiscard]] bool goes_on() const { return !problems_.enough() && motion_.samples.size() <= rules::most_samples; }

  // Column of the horizontal acceleration.
  [[nodiscard]] std::size_t first_value() const { return how_.time_step ? 0 : 1; }

  void read_line(std::string_view line) {
    line = line.substr(0, line.find('#'));
    split_fields(line, fields_);
    if (fields_.empty()) return;
    columns_seen_ = true;
    holds_numbers_ = holds_numbers_ || std::ranges::any_of(fields_, is_number_field);
    if (!has_columns(line)) return;
    double values[3] = {0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const auto value = problems_.number(fields_[i]);
      if (!value) return;
      values[i] = *value;
    }
    const std::size_t first = first_value();
    const double time = how_.time_step ? *how_.time_step * static_cast<double>(motion_.samples.size()) : values[0];
    if (!is_time(time)) return;
    for (std::size_t i = first; i < fields_.size(); ++i) {
      if (!is_acceleration(values[i], fields_[i])) return;
    }
    motion_.samples.push_back(
        {.time = time,
         .horizontal = over_gravity(values[first], unit_, how_.gravity),
         .vertical = fields_.size() > first + 1 ? over_gravity(values[first + 1], unit_, how_.gravity) : 0.0});
  }

  [[nodiscard]] bool has_columns(std::string_view line) {
    const std::size_t count = fields_.size();
    if (columns_ == 0 && (count == first_value() + 1 || count == first_value() + 2)) columns_ = count;
    if (count == columns_) return true;
    const std::string found = std::to_string(count) + (count == 1 ? " column" : " columns");
    if (columns_ != 0) {
      problems_.reject_line(line, "has " + found + ", but the lines before it have " + std::to_string(columns_),
                            "give every line the same columns");
    } else if (how_.time_step) {
      problems_.reject_line(line, "has " + found,
                            "give horizontal[, vertical] in m/s^2; for a column of times omit "
                            "\"time_step_s\"");
    } else {
      problems_.reject_line(line, "has " + found,
                            "give time, horizontal[, vertical] in s and m/s^2; for values at even "
                            "spacing set \"time_step_s\"");
    }
    return false;
  }

  [[nodiscard]] bool is_time(double time) {
    if (how_.time_step && time > rules::latest_sample) {
      problems_.reject_line(fields_[0], "is later than 1e7 s",
                            "check \"time_step_s\", or give a shorter ground motion");
      return false;
    }
    if (const auto refusal = refuse_sample_time(time)) {
      problems_.reject_line(fields_[0], refusal->reason, refusal->remedy);
      return false;
    }
    if (!motion_.samples.empty() && time < motion_.samples.back().time) {
      const Refusal refusal = sample_falls_back(Json(motion_.samples.back().time).dump());
      problems_.reject_line(fields_[0], refusal.reason, refusal.remedy);
      return false;
    }
    return true;
  }

  [[nodiscard]] bool is_acceleration(double value, std::string_view field) {
    const auto refusal = refuse_acceleration(value, in_m_s2(unit_, how_.gravity));
    if (refusal) problems_.reject_line(field, refusal->reason, refusal->remedy);
    return !refusal;
  }

  void check_whole() {
    const auto refusal = refuse_samples(motion_.samples);
    if (refusal) problems_.reject_file(refusal->reason, refusal->remedy);
  }

  const GroundMotionReading& how_;
  LineProblems problems_;
  RecordUnit unit_ = how_.unit.value_or(RecordUnit::m_s2);
  GroundMotion motion_;
  std::vector<std::string_view> fields_;
  std::size_t columns_ = 0;     ///< of the first line that has any; 0 before it
  bool columns_seen_ = false;   ///< in any line
  bool holds_numbers_ = false;  ///< some field of some line is a number
};

}  // namespace

std::optional<GroundMotion> read_columns(std::string_view text, const GroundMotionReading& how, Problems& problems) {
  return ColumnsReader(how, problems).read(text);
}

}  // namespace rocking
