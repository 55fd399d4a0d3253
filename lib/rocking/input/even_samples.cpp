#include "rocking/input/even_samples.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "rocking/base/number_text.hpp"
#include "rocking/input/even_times.hpp"
#include "rocking/input/fixed_fields.hpp"
#include "rocking/input/missing_samples.hpp"
#include "rocking/scene/ground_motion_reading.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

std::string samples_in_words(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " sample" : " samples");
}

/// Every `stride`-th number of a text from the number `first` on, as long as they do not fall.
class StridedNumbers {
 public:
  StridedNumbers(std::size_t first, std::size_t stride) : first_(first), stride_(stride) {}

  /// Returns whether the numbers before the end or a text rise evenly.
  bool read(std::string_view text) {
    std::vector<std::string_view> fields;
    std::size_t index = 0;
    bool goes_on = true;
    while (!text.empty() && goes_on) {
      split_fields(take_line(text), fields);
      for (const std::string_view field : fields) {
        goes_on = goes_on && is_number_field(field);
        if (goes_on && index++ % stride_ == first_ && !add(field)) return false;
      }
    }
    constexpr std::size_t fewest = 3;
    if (values_.size() < fewest) return false;
    evenness_ = evenness_of(values_, digits_);
    return evenness_.is_progression;
  }

  [[nodiscard]] double step() const { return evenness_.step; }

 private:
  /// Returns whether the number does not fall below the one before it.
  bool add(std::string_view field) {
    double value = 0.0;
    const std::string_view digits = field.substr(field.starts_with('+') ? 1 : 0);
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (!values_.empty() && value < values_.back()) return false;
    values_.push_back(value);
    digits_.add(field);
    return true;
  }

  std::size_t first_;
  std::size_t stride_;
  std::vector<double> values_;
  PrintedDigits digits_;
  Evenness evenness_;
};

/// The step of the times that stand beside accelerations, as every second number or as the first of each line; absent if
/// there are none. A ramp, of which all numbers rise by the same step, has none.
std::optional<double> step_of_times_among(std::string_view text) {
  std::vector<std::string_view> fields;
  split_fields(text.substr(0, text.find('\n')), fields);
  for (const std::size_t stride : {std::size_t{2}, fields.size()}) {
    if (stride < 2) continue;
    StridedNumbers times(0, stride);
    if (!times.read(text)) continue;
    StridedNumbers beside(1, stride);
    if (!beside.read(text) || beside.step() != times.step()) return times.step();
  }
  return std::nullopt;
}

class EvenSamplesReader {
 public:
  EvenSamplesReader(const EvenHeader& header, double gravity, LineProblems& problems)
      : header_(header), gravity_(gravity), problems_(problems) {}

  std::optional<GroundMotion> read(std::string_view text) {
    if (problems_.reject_decimal_comma(text)) return std::nullopt;
    const std::string parted = header_.field_width > 0 ? parted_fields(text, header_.field_width) : std::string();
    if (header_.field_width > 0) text = parted;
    const std::string_view whole = text;
    while (!text.empty() && !is_ended_ && !problems_.enough() && motion_.samples.size() <= rules::most_samples) {
      read_line(problems_.next_line(text));
    }
    if (!problems_.any()) check_whole(whole);
    if (problems_.any()) return std::nullopt;
    if (header_.has_offset) remove_mean();
    if (header_.peak) compare_peak();
    if (header_.has_times) take_times();
    if (!header_.has_times) motion_.time_step = header_.time_step;
    motion_.declared = header_.declared;
    motion_.unit = name_of(header_.unit);
    return std::move(motion_);
  }

 private:
  void read_line(std::string_view line) {
    split_fields(line, fields_);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const std::string_view field = fields_[i];
      if (ends_data(field)) {
        motion_.warnings.push_back("contains text after its samples: " + brief(Json(std::string(field))) + " in line " +
                                   std::to_string(problems_.line()) + "; nothing is read from there on");
        is_ended_ = true;
        return;
      }
      if (i % header_.columns == header_.column && !add(i)) return;
    }
    if (fields_.size() % header_.columns == 0) return;
    problems_.reject_line(line,
                          "has " + std::to_string(fields_.size()) + " numbers, but " + std::to_string(header_.columns) +
                              " belong to each sample",
                          "restore the file");
  }

  /// Whether a field is text behind the declared number of samples.
  [[nodiscard]] bool ends_data(std::string_view field) const {
    const bool is_complete = header_.declared && motion_.samples.size() >= *header_.declared;
    return is_complete && !field.empty() && !is_number_field(field);
  }

  /// The sample whose acceleration is a field of the present line.
  [[nodiscard]] bool add(std::size_t place) {
    const std::string_view field = fields_[place];
    const auto value = problems_.number(field);
    const auto time = value ? time_of(place) : std::nullopt;
    if (!time) return false;
    const double scaled = *value * header_.factor;
    missing_.add(*value, problems_.line());
    const bool is_mark = MissingSamples::is_mark_alone(*value);  // all are counted before one is reported
    if (const auto refusal = refuse_acceleration(scaled, in_m_s2(header_.unit, gravity_)); refusal && !is_mark) {
      problems_.reject_line(field, refusal->reason, "check the number and the unit of the file");
      return false;
    }
    motion_.samples.push_back(
        {.time = *time, .horizontal = over_gravity(scaled, header_.unit, gravity_), .vertical = 0.0});
    return true;
  }

  /// Absent, and reported, if there is none.
  [[nodiscard]] std::optional<double> time_of(std::size_t place) {
    std::string_view written = fields_[place];
    double time = header_.time_step * static_cast<double>(motion_.samples.size());
    if (header_.has_times) {
      written = fields_[place - 1];
      const auto found = problems_.number(written);
      if (!found) return std::nullopt;
      time = *found;
    }
    std::optional<Refusal> refusal;
    if (time > rules::latest_sample) refusal = Refusal{"is later than 1e7 s", "check the time step of the header"};
    if (header_.has_times && !refusal) refusal = refuse_sample_time(time);
    if (!motion_.samples.empty() && time < motion_.samples.back().time)
      refusal = sample_falls_back(base::shortest(motion_.samples.back().time));
    if (refusal) {
      problems_.reject_line(written, refusal->reason, refusal->remedy);
      return std::nullopt;
    }
    if (header_.has_times) {
      digits_.add(written);
      times_.push_back(time);
    }
    return time;
  }

  void take_times() {
    const Evenness evenness = evenness_of(times_, digits_);
    if (evenness.is_even()) {
      motion_.time_step = evenness.step;
    } else {
      motion_.warnings.push_back(uneven_in_words(evenness, ""));
    }
  }

  void remove_mean() {
    double sum = 0.0;
    for (const auto& sample : motion_.samples) sum += sample.horizontal;
    const double mean = sum / static_cast<double>(motion_.samples.size());
    for (auto& sample : motion_.samples) sample.horizontal -= mean;
    motion_.warnings.push_back("its mean, " + base::significant(mean * gravity_, 3) +
                               " m/s2, is the offset of the sensor and is removed");
  }

  void compare_peak() {
    constexpr double tolerance = 0.01;
    double peak = 0.0;
    for (const auto& sample : motion_.samples) peak = std::max(peak, std::abs(sample.horizontal) * gravity_);
    const double stated = header_.peak->m_s2;
    const bool is_equal = std::abs(peak - stated) <= tolerance * stated + header_.peak->rounding;
    motion_.header_peak = {.m_s2 = stated, .is_that_of_samples = is_equal};
    if (is_equal) return;
    motion_.warnings.push_back("has a peak of " + base::significant(peak, 4) + " m/s2, but its header states " +
                               base::significant(stated, 4));
  }

  void check_whole(std::string_view text) {
    const auto step = header_.has_times ? std::nullopt : step_of_times_among(text);
    if (step) {
      return problems_.reject_file(
          "has a column of times, which rise by " + base::shortest(*step) +
              ", below a header of evenly spaced accelerations: they would be taken for accelerations",
          R"(put # before the lines of its header, and give "format": "columns", "columns": ["time", "horizontal"] and )"
          R"("units")");
    }
    const std::size_t found = motion_.samples.size();
    if (header_.declared && found <= rules::most_samples) {
      const std::size_t declared = *header_.declared;
      const std::size_t difference = std::max(found, declared) - std::min(found, declared);
      const std::string counts =
          "contains " + samples_in_words(found) + ", but its header declares " + std::to_string(declared);
      if (difference > 1) {
        problems_.reject_file(counts, "restore the file, or correct the number in its header");
        return;
      }
      if (difference == 1) motion_.warnings.push_back(counts + "; all that it contains are used");
    }
    missing_.check(problems_);
    auto refusal = refuse_samples(motion_.samples);
    if (!refusal) refusal = refuse_long_steps(motion_.samples);
    if (refusal && !problems_.any()) problems_.reject_file(refusal->reason, refusal->remedy);
  }

  const EvenHeader& header_;
  double gravity_;
  LineProblems& problems_;
  GroundMotion motion_;
  std::vector<std::string_view> fields_;
  std::vector<double> times_;  ///< of a file that has them
  PrintedDigits digits_;       ///< likewise
  MissingSamples missing_;
  bool is_ended_ = false;  ///< by text
};

}  // namespace

std::optional<GroundMotion> read_even_samples(std::string_view text, const EvenHeader& header, double gravity,
                                              LineProblems& problems) {
  return EvenSamplesReader(header, gravity, problems).read(text);
}

std::optional<HeaderPeak> header_peak(std::string_view field, RecordUnit unit, double gravity) {
  constexpr double absent = 1e30;
  if (!is_number_field(field)) return std::nullopt;
  double value = 0.0;
  const std::string_view digits = field.substr(field.starts_with('+') ? 1 : 0);
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  value = std::abs(value);
  if (!(value > 0.0 && value < absent)) return std::nullopt;
  PrintedDigits printed;
  printed.add(field);
  return HeaderPeak{.m_s2 = value * in_m_s2(unit, gravity),
                    .rounding = 0.5 * printed.unit_of(value) * in_m_s2(unit, gravity)};
}

void expect_asked_unit(RecordUnit stated, std::optional<RecordUnit> asked, LineProblems& problems) {
  if (!asked || *asked == stated) return;
  problems.reject_line(name_of(stated),
                       "is the unit of the file, but \"units\" is \"" + std::string(name_of(*asked)) + '"',
                       "omit \"units\", or correct the file");
}

std::optional<double> checked_time_step(std::string_view field, double units_per_second, std::optional<double> asked,
                                        LineProblems& problems) {
  auto step = problems.number(field);
  if (!step) return std::nullopt;
  *step /= units_per_second;
  if (!rules::time_step.allows(*step)) {
    problems.reject_line(field, std::string(rules::time_step.demand), "correct the time step of the header");
    return std::nullopt;
  }
  if (asked && *asked != *step) {
    expect_asked_step(*step, asked, problems);
    return std::nullopt;
  }
  return step;
}

void expect_asked_step(double step, std::optional<double> asked, LineProblems& problems) {
  if (!asked || *asked == step) return;
  problems.reject_line(base::shortest(step),
                       "is the time step of the file, but \"time_step_s\" is " + base::shortest(*asked),
                       "omit \"time_step_s\", or correct the file");
}

void expect_no_step(std::optional<double> asked, LineProblems& problems) {
  if (!asked) return;
  problems.reject_file("has a time beside each acceleration, but \"time_step_s\" is given", "omit \"time_step_s\"");
}

std::optional<std::size_t> checked_count(std::string_view field, LineProblems& problems) {
  const auto count = problems.number(field);
  if (!count) return std::nullopt;
  if (!(*count >= 0.0 && *count <= 1e9) || std::trunc(*count) != *count) {
    problems.reject_line(field, "is not a number of samples", "correct the header");
    return std::nullopt;
  }
  return static_cast<std::size_t>(*count);
}

}  // namespace rocking
