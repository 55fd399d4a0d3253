#include <vector>

#include "rocking/base/number_text.hpp"
#include "rocking/input/even_samples.hpp"
#include "rocking/input/line_problems.hpp"
#include "rocking/input/record_formats.hpp"

namespace rocking {
namespace {

constexpr const char* remedy_of_timeseries =
    "give one segment as ObsPy writes it: TIMESERIES IV_NRC__HNE_D, 4000 samples, 200 sps, 2016-08-24T01:36:30, SLIST, "
    "FLOAT, M/S**2";

/// Reads a line `TIMESERIES id, 4000 samples, 200 sps, start, SLIST, FLOAT, unit` and accelerations, any number of them in a
/// line, or (TSPAIR) behind the time of each.
class TimeseriesReader {
 public:
  TimeseriesReader(const GroundMotionReading& how, Problems& problems) : how_(how), problems_(how.name, problems) {}

  std::optional<GroundMotion> read(std::string_view text) {
    text = without_byte_order_mark(text);
    while (!text.empty() && fields_.empty()) split_fields(problems_.next_line(text), fields_);
    // TIMESERIES, id, 4000, samples, 200, sps, start, SLIST, FLOAT, unit
    constexpr std::size_t with_unit = 10;
    if (fields_.size() < with_unit || fields_[3] != "samples" || fields_[5] != "sps") {
      problems_.reject_file("has no line with samples, rate and unit", remedy_of_timeseries);
      return std::nullopt;
    }
    const auto rate = problems_.number(fields_[4]);
    EvenHeader header{.declared = checked_count(fields_[2], problems_)};
    if (!rate || !header.declared) return std::nullopt;
    const auto step = checked_time_step(base::shortest(1.0 / *rate), 1.0, how_.time_step, problems_);
    if (!step || !read_unit(fields_[9], header)) return std::nullopt;
    header.time_step = *step;
    if (fields_[7] == "TSPAIR") header.columns = 2, header.column = 1;
    if (const std::size_t next = text.find("TIMESERIES"); next != std::string_view::npos) {
      problems_.reject_file("holds several segments: there is a gap in the record", remedy_of_timeseries);
      return std::nullopt;
    }
    const std::string component = channel_in(fields_[1]);
    auto motion = read_even_samples(text, header, how_.gravity, problems_);
    if (motion) motion->component = component;
    return motion;
  }

 private:
  bool read_unit(std::string_view written, EvenHeader& header) {
    const WrittenUnit unit = unit_written(written);
    if (unit.kind == UnitKind::acceleration) {
      header.unit = unit.acceleration;
      expect_asked_unit(header.unit, how_.unit, problems_);
      return !problems_.any();
    }
    problems_.reject_line(written, "is no unit of acceleration",
                          "correct the record for the instrument, as with ObsPy (remove_response(output=\"ACC\"))");
    return false;
  }

  /// `HNE` of `IV_NRC__HNE_D`.
  static std::string channel_in(std::string_view id) {
    for (int part = 0; part < 3; ++part) {
      const std::size_t end = id.find('_');
      if (end == std::string_view::npos) return {};
      id.remove_prefix(end + 1);
    }
    return std::string(id.substr(0, id.find('_')));
  }

  const GroundMotionReading& how_;
  LineProblems problems_;
  std::vector<std::string_view> fields_;
};

}  // namespace

bool is_line_of_timeseries_header(std::string_view line) { return line.starts_with("TIMESERIES "); }

std::optional<GroundMotion> read_timeseries(std::string_view text, const GroundMotionReading& how, Problems& problems) {
  return TimeseriesReader(how, problems).read(text);
}

}  // namespace rocking
