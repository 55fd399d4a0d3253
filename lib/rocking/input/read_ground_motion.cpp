#include "rocking/input/read_ground_motion.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>
#include <vector>

#include "rocking/scene/check_ground_motion.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_bad_lines = 5;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool is_comma(char c) { return c == ',' || c == ';'; }

// The fields of a line, between blanks or one comma or semicolon. Between two commas stands an empty field.
void split(std::string_view line, std::vector<std::string_view>& fields) {
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

/// Whether a field is a number and nothing else.
bool is_number(std::string_view field) {
  if (field.starts_with('+')) field.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  return !field.empty() && error != std::errc::invalid_argument && end == field.data() + field.size();
}

class RecordReader {
 public:
  RecordReader(const GroundMotionReading& how, Problems& problems) : how_(how), problems_(problems) {}

  std::optional<GroundMotion> read(std::string_view text) {
    const std::size_t problems_before = problems_.size();
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text.starts_with(byte_order_mark)) text.remove_prefix(byte_order_mark.size());
    while (!text.empty() && goes_on()) {
      ++line_;
      const std::size_t end = text.find('\n');
      read_line(text.substr(0, end));
      text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    if (bad_lines_ == 0) check_whole();
    if (bad_lines_ != 0 && line_ > 0 && !holds_numbers_ && columns_seen_) {
      problems_.erase(problems_.begin() + static_cast<std::ptrdiff_t>(problems_before), problems_.end());
      reject_file("is not a text file of numbers", "give a file with a line of numbers for each sample");
    }
    if (bad_lines_ != 0) return std::nullopt;
    motion_.has_vertical = columns_ == first_value() + 2;
    return std::move(motion_);
  }

 private:
  [[nodiscard]] bool goes_on() const {
    return bad_lines_ < most_bad_lines && motion_.samples.size() <= rules::most_samples;
  }

  // Column of the horizontal acceleration.
  [[nodiscard]] std::size_t first_value() const { return how_.time_step ? 0 : 1; }

  void reject_line(std::string_view found, std::string reason, std::string remedy) {
    ++bad_lines_;
    problems_.push_back({how_.name + ", line " + std::to_string(line_), brief(Json(std::string(found))),
                         std::move(reason), std::move(remedy)});
  }

  void reject_file(std::string reason, std::string remedy) {
    ++bad_lines_;
    problems_.push_back({how_.name, "", std::move(reason), std::move(remedy)});
  }

  void read_line(std::string_view line) {
    line = line.substr(0, line.find('#'));
    split(line, fields_);
    if (fields_.empty()) return;
    columns_seen_ = true;
    holds_numbers_ = holds_numbers_ || std::ranges::any_of(fields_, is_number);
    if (!has_columns(line)) return;
    double values[3] = {0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const auto value = number(fields_[i]);
      if (!value) return;
      values[i] = *value;
    }
    const std::size_t first = first_value();
    const double time = how_.time_step ? *how_.time_step * static_cast<double>(motion_.samples.size()) : values[0];
    if (!is_time(time)) return;
    for (std::size_t i = first; i < fields_.size(); ++i) {
      if (!is_acceleration(values[i], fields_[i])) return;
    }
    motion_.samples.push_back({.time = time,
                               .horizontal = values[first] / how_.gravity,
                               .vertical = fields_.size() > first + 1 ? values[first + 1] / how_.gravity : 0.0});
  }

  [[nodiscard]] bool has_columns(std::string_view line) {
    const std::size_t count = fields_.size();
    if (columns_ == 0 && (count == first_value() + 1 || count == first_value() + 2)) columns_ = count;
    if (count == columns_) return true;
    const std::string found = std::to_string(count) + (count == 1 ? " column" : " columns");
    if (columns_ != 0) {
      reject_line(line, "has " + found + ", but the lines before it have " + std::to_string(columns_),
                  "give every line the same columns");
    } else if (how_.time_step) {
      reject_line(line, "has " + found,
                  "give horizontal[, vertical] in m/s^2; for a column of times omit "
                  "\"time_step_s\"");
    } else {
      reject_line(line, "has " + found,
                  "give time, horizontal[, vertical] in s and m/s^2; for values at even "
                  "spacing set \"time_step_s\"");
    }
    return false;
  }

  [[nodiscard]] std::optional<double> number(std::string_view field) {
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

  [[nodiscard]] bool is_time(double time) {
    if (how_.time_step && time > rules::latest_sample) {
      reject_line(fields_[0], "is later than 1e7 s", "check \"time_step_s\", or give a shorter ground motion");
      return false;
    }
    if (const auto refusal = refuse_sample_time(time)) {
      reject_line(fields_[0], refusal->reason, refusal->remedy);
      return false;
    }
    if (!motion_.samples.empty() && time < motion_.samples.back().time) {
      const Refusal refusal = sample_falls_back(Json(motion_.samples.back().time).dump());
      reject_line(fields_[0], refusal.reason, refusal.remedy);
      return false;
    }
    return true;
  }

  [[nodiscard]] bool is_acceleration(double value, std::string_view field) {
    const auto refusal = refuse_acceleration(value);
    if (refusal) reject_line(field, refusal->reason, refusal->remedy);
    return !refusal;
  }

  void check_whole() {
    const auto refusal = refuse_samples(motion_.samples);
    if (refusal) reject_file(refusal->reason, refusal->remedy);
  }

  const GroundMotionReading& how_;
  Problems& problems_;
  GroundMotion motion_;
  std::vector<std::string_view> fields_;
  std::size_t columns_ = 0;  ///< of the first line that has any; 0 before it
  std::size_t line_ = 0;
  std::size_t bad_lines_ = 0;
  bool columns_seen_ = false;   ///< in any line
  bool holds_numbers_ = false;  ///< some field of some line is a number
};

}  // namespace

std::optional<GroundMotion> read_ground_motion(std::string_view text, const GroundMotionReading& how,
                                               Problems& problems) {
  return RecordReader(how, problems).read(text);
}

}  // namespace rocking
