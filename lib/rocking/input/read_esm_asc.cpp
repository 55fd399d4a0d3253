#include "rocking/input/record_formats.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "rocking/base/number_text.hpp"
#include "rocking/input/even_samples.hpp"

namespace rocking {
namespace {

std::string in_capitals(std::string_view text) {
  std::string capitals(text);
  std::ranges::transform(capitals, capitals.begin(),
                         [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return capitals;
}

class EsmReader {
 public:
  EsmReader(const GroundMotionReading& how, Problems& problems) : how_(how), problems_(how.name, problems) {}

  std::optional<GroundMotion> read(std::string_view text) {
    text = without_byte_order_mark(text);
    std::string_view rest = text;
    while (!rest.empty() && !problems_.enough() && !begins_with_number(rest)) read_line(problems_.next_line(rest));
    if (problems_.any()) return std::nullopt;
    for (const char* key : {"SAMPLING_INTERVAL_S", "UNITS"}) {
      if (keys_.contains(key)) continue;
      problems_.reject_file("has no line " + std::string(key) + ": in its header", "give the original file");
    }
    check_duration();
    if (problems_.any()) return std::nullopt;
    auto motion = read_even_samples(rest, header_, how_.gravity, problems_);
    if (!motion) return motion;
    motion->component = stream_;
    if (!event_.empty() && !station_.empty()) motion->origin = event_ + ", " + station_;
    return motion;
  }

 private:
  [[nodiscard]] bool begins_with_number(std::string_view text) {
    split_fields(text.substr(0, text.find('\n')), fields_);
    return !fields_.empty() && is_number_field(fields_.front());
  }

  void read_line(std::string_view line) {
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) {
      if (trimmed(line).empty()) return;
      problems_.reject_line(line, "is neither a line KEY: value nor a number", "give the original file");
      return;
    }
    const std::string key = in_capitals(trimmed(line.substr(0, colon)));
    const std::string_view value = trimmed(line.substr(colon + 1));
    if (!keys_.insert(key).second) {
      problems_.reject_line(line, "gives " + key + " a second time",
                            "give the original file, where each key stands once");
    } else if (key == "SAMPLING_INTERVAL_S") {
      read_step(value);
    } else if (key == "NDATA" && !value.empty()) {
      header_.declared = checked_count(value, problems_);
    } else if (key == "DURATION_S" && is_number_field(value)) {
      duration_ = problems_.number(value);
    } else if (key == "PGA_CM/S^2" && is_number_field(value)) {
      header_.peak = header_peak(value, RecordUnit::cm_s2, how_.gravity);
    } else if (key == "STREAM") {
      stream_ = value;
    } else if (key == "EVENT_ID") {
      event_ = value;
    } else if (key == "STATION_CODE") {
      station_ = value;
    } else if (key == "UNITS") {
      read_unit(value);
    } else if (key == "DATA_TYPE" && !value.empty() && in_capitals(value) != "ACCELERATION") {
      problems_.reject_line(value, "is the kind of the data", "give a file whose DATA_TYPE is ACCELERATION");
    }
  }

  /// That of the header and that of its number of samples; either may be by one step longer.
  void check_duration() {
    if (!duration_ || !header_.declared) return;
    const double of_samples = header_.time_step * static_cast<double>(*header_.declared);
    if (std::abs(*duration_ - of_samples) <= 2.0 * header_.time_step) return;
    problems_.reject_file("states a duration of " + base::shortest(*duration_) +
                              " s, but its number of samples and its step give " + base::significant(of_samples, 6),
                          "restore the header");
  }

  void read_step(std::string_view value) {
    const auto step = checked_time_step(value, 1.0, how_.time_step, problems_);
    if (step) header_.time_step = *step;
  }

  void read_unit(std::string_view value) {
    const WrittenUnit stated = unit_written(value);
    if (stated.kind != UnitKind::acceleration) {
      problems_.reject_line(value, "is not a known unit of acceleration",
                            "give a file of accelerations in " + record_units_in_words());
      return;
    }
    header_.unit = stated.acceleration;
    expect_asked_unit(header_.unit, how_.unit, problems_);
  }

  const GroundMotionReading& how_;
  LineProblems problems_;
  EvenHeader header_;
  std::optional<double> duration_;
  std::string event_, station_;
  std::string stream_;  ///< channel of the sensor: `HNE`, `HNZ`
  std::vector<std::string_view> fields_;
  std::set<std::string> keys_;  ///< that were read
};

}  // namespace

bool is_line_of_esm_header(std::string_view line) { return line.starts_with("SAMPLING_INTERVAL_S:"); }

std::optional<GroundMotion> read_esm_asc(std::string_view text, const GroundMotionReading& how, Problems& problems) {
  return EsmReader(how, problems).read(text);
}

}  // namespace rocking
