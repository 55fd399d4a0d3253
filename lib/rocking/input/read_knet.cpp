#include <cmath>

#include "rocking/base/number_text.hpp"
#include "rocking/input/even_samples.hpp"
#include "rocking/input/line_problems.hpp"
#include "rocking/input/record_formats.hpp"

namespace rocking {
namespace {

/// What stands behind a key of a K-NET header, without blanks around it; absent: the line is of another key.
std::optional<std::string_view> behind_knet_key(std::string_view line, std::string_view key) {
  if (!line.starts_with(key)) return std::nullopt;
  line.remove_prefix(key.size());
  return trimmed(line);
}

/// The direction of a component: a sensor of KiK-net has a number, 1 to 3 in the borehole, 4 to 6 at the surface.
std::string knet_direction(std::string_view text) {
  if (text == "1" || text == "4") return "N-S";
  if (text == "2" || text == "5") return "E-W";
  if (text == "3" || text == "6") return "U-D";
  return std::string(text);
}

class KnetReader {
 public:
  KnetReader(const GroundMotionReading& how, Problems& problems) : how_(how), problems_(how.name, problems) {}

  std::optional<GroundMotion> read(std::string_view text) {
    text = without_byte_order_mark(text);
    bool is_header = true;
    while (is_header && !text.empty() && !problems_.enough()) {
      const std::string_view line = problems_.next_line(text);
      is_header = !line.starts_with("Memo.");
      read_line(line);
    }
    if (is_header && !problems_.any()) problems_.reject_file("has no line Memo., which ends its header", remedy);
    if (!has_scale_ && !problems_.any()) problems_.reject_file("has no line Scale Factor", remedy);
    if (!(header_.time_step > 0.0) && !problems_.any()) problems_.reject_file("has no line Sampling Freq(Hz)", remedy);
    if (problems_.any()) return std::nullopt;
    if (duration_) header_.declared = static_cast<std::size_t>(std::llround(*duration_ / header_.time_step));
    expect_asked_unit(header_.unit, how_.unit, problems_);
    auto motion = read_even_samples(text, header_, how_.gravity, problems_);
    if (!motion) return motion;
    motion->component = component_;
    motion->is_of_borehole = is_of_borehole_;
    if (is_of_borehole_) motion->warnings.push_back("is of a sensor in a borehole, not at the surface");
    if (!time_.empty() && !station_.empty())
      motion->origin = station_ + (is_of_borehole_ ? " borehole, " : ", ") + time_;
    return motion;
  }

 private:
  static constexpr const char* remedy = "give the file as NIED distributes it";

  void read_line(std::string_view line) {
    if (auto frequency = behind_knet_key(line, "Sampling Freq(Hz)")) {
      if (frequency->ends_with("Hz")) frequency->remove_suffix(2);
      const auto value = problems_.number(*frequency);
      if (!value) return;
      const auto step = checked_time_step(base::shortest(1.0 / *value), 1.0, how_.time_step, problems_);
      if (step) header_.time_step = *step;
    } else if (const auto scale = behind_knet_key(line, "Scale Factor")) {
      read_scale(*scale);
    } else if (const auto duration = behind_knet_key(line, "Duration Time(s)")) {
      duration_ = problems_.number(*duration);
      if (duration_ && !(*duration_ > 0.0 && *duration_ < 1e6))
        problems_.reject_line(*duration, "is no duration", remedy);
    } else if (const auto peak = behind_knet_key(line, "Max. Acc. (gal)")) {
      header_.peak = header_peak(*peak, RecordUnit::cm_s2, how_.gravity);
    } else if (const auto direction = behind_knet_key(line, "Dir.")) {
      component_ = knet_direction(*direction);
      is_of_borehole_ = *direction == "1" || *direction == "2" || *direction == "3";
    } else if (const auto time = behind_knet_key(line, "Origin Time")) {
      time_ = *time;
    } else if (const auto station = behind_knet_key(line, "Station Code")) {
      station_ = *station;
    }
  }

  /// `3920(gal)/6182761`.
  void read_scale(std::string_view text) {
    constexpr std::string_view unit = "(gal)/";
    const std::size_t at = text.find(unit);
    if (at == std::string_view::npos) return problems_.reject_line(text, "is no scale factor in gal", remedy);
    const auto over = problems_.number(text.substr(0, at)), under = problems_.number(text.substr(at + unit.size()));
    if (!over || !under) return;
    header_.factor = *over / *under;
    has_scale_ = *under != 0.0 && std::isfinite(header_.factor);
    if (!has_scale_) problems_.reject_line(text, "is no scale factor in gal", remedy);
  }

  const GroundMotionReading& how_;
  LineProblems problems_;
  // The accelerations of these files have an offset of the sensor; the peak of the header is that without it.
  EvenHeader header_{.unit = RecordUnit::cm_s2, .has_offset = true};
  std::string component_, time_, station_;
  bool is_of_borehole_ = false;
  std::optional<double> duration_;
  bool has_scale_ = false;
};

}  // namespace

bool is_line_of_knet_header(std::string_view line) {
  return line.starts_with("Scale Factor") && line.find("(gal)/") != std::string_view::npos;
}

std::optional<GroundMotion> read_knet(std::string_view text, const GroundMotionReading& how, Problems& problems) {
  return KnetReader(how, problems).read(text);
}

}  // namespace rocking
