#include <algorithm>
#include <string>
#include <vector>

#include "rocking/input/header_words.hpp"
#include "rocking/input/record_channels.hpp"

namespace rocking {
namespace {

constexpr std::string_view remedy_of_afad = "give the file as AFAD distributes it";

/// The older layout: lines `KEY : value`, the names of three columns, and a line of three accelerations for each sample. The
/// unit stands beside the peaks: `RAW PGA VALUES (gal)    : (N-S) 13.2 (E-W) 12.2 (U-D) 9.8`. Names are in Latin-1.
class AfadReader {
 public:
  AfadReader(const GroundMotionReading& how, Problems& found) : how_(how), found_(found), problems_(how.name, found) {}

  std::optional<GroundMotion> read(std::string_view text) {
    std::vector<std::string_view> names;
    while (!text.empty() && names.size() < 2 && !problems_.enough()) {
      const std::string_view line = problems_.next_line(text);
      const std::size_t colon = line.find(':');
      if (colon != std::string_view::npos) read_key(trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1)));
      if (colon == std::string_view::npos && is_head(line)) split_fields(line, names);
    }
    if (names.empty() && !problems_.any())
      problems_.reject_file("has no line with the names of its columns, N-S E-W U-D", std::string(remedy_of_afad));
    if (!(header_.time_step > 0.0) && !problems_.any())
      problems_.reject_file("has no line SAMPLING INTERVAL", std::string(remedy_of_afad));
    if (!has_unit_ && !problems_.any())
      problems_.reject_file("has no line RAW PGA VALUES, which gives the unit", std::string(remedy_of_afad));
    if (problems_.any()) return std::nullopt;
    std::vector<RecordChannel> channels;
    for (std::size_t i = 0; i < names.size(); ++i) {
      RecordChannel channel{
          .component = std::string(names[i]), .header = header_, .samples = text, .line = problems_.line()};
      channel.header.columns = names.size();
      channel.header.column = i;
      channel.header.peak = peak_of(names[i]);
      channels.push_back(std::move(channel));
    }
    return read_chosen(channels, how_, found_);
  }

 private:
  static bool is_head(std::string_view line) {
    return line.find("N-S") != std::string_view::npos && line.find("U-D") != std::string_view::npos;
  }

  void read_key(std::string_view key, std::string_view value) {
    if (key.starts_with("NUMBER OF DATA")) {
      header_.declared = checked_count(value, problems_);
    } else if (key.starts_with("SAMPLING INTERVAL")) {
      if (const auto step = checked_time_step(value, 1.0, std::nullopt, problems_)) header_.time_step = *step;
    } else if (key.starts_with("RAW PGA VALUES")) {
      const WrittenUnit unit = unit_written(key.substr(std::min(key.find('('), key.size())));
      if (unit.kind != UnitKind::acceleration)
        return problems_.reject_line(key, "names no known unit", std::string(remedy_of_afad));
      has_unit_ = true;
      header_.unit = unit.acceleration;
      peaks_ = value;
    }
  }

  [[nodiscard]] std::optional<HeaderPeak> peak_of(std::string_view name) const {
    const std::string key = '(' + std::string(name) + ')';
    const std::size_t place = peaks_.find(key);
    if (place == std::string_view::npos) return std::nullopt;
    const std::string_view behind = trimmed(peaks_.substr(place + key.size()));
    return header_peak(behind.substr(0, behind.find(' ')), header_.unit, how_.gravity);
  }

  const GroundMotionReading& how_;
  Problems& found_;
  LineProblems problems_;
  EvenHeader header_;
  bool has_unit_ = false;
  std::string_view peaks_;
};

}  // namespace

bool is_line_of_afad_header(std::string_view line) { return line.starts_with("STRONG GROUND MOTION RECORDS OF TURK"); }

std::optional<GroundMotion> read_afad(std::string_view text, const GroundMotionReading& how, Problems& problems) {
  text = without_byte_order_mark(text);
  if (!is_line_of_afad_header(text)) return read_esm_asc(text, how, problems);
  return AfadReader(how, problems).read(text);
}

}  // namespace rocking
