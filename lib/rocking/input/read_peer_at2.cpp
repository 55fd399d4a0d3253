#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "rocking/input/even_samples.hpp"
#include "rocking/input/header_words.hpp"
#include "rocking/input/line_problems.hpp"
#include "rocking/input/record_component.hpp"
#include "rocking/input/record_formats.hpp"

namespace rocking {
namespace {

/// What the last line of a header in PEER's format gives, as written.
struct PeerCounts {
  std::string_view count;         ///< of samples
  std::string_view step;          ///< the time step
  double units_per_second = 1.0;  ///< of its unit: 1 for s, 1000 for ms
};

/// What a second holds of the unit of time at the beginning of `text`; without a unit, one. Absent, and reported, if a
/// word stands there that is no known unit.
std::optional<double> units_per_second(std::string_view text, LineProblems& problems) {
  constexpr std::array<std::string_view, 5> seconds{"s", "sec", "secs", "second", "seconds"};
  constexpr std::array<std::string_view, 5> milliseconds{"ms", "msec", "msecs", "millisecond", "milliseconds"};
  const std::size_t begin = text.find_first_not_of(" \t\r,;([.");
  if (begin == std::string_view::npos) return 1.0;
  const bool is_behind_comma = text.substr(0, begin).find_first_of(",;") != std::string_view::npos;
  text.remove_prefix(begin);
  const auto is_next = [text](std::string_view word) { return begins_with_word(text, word); };
  if (std::ranges::any_of(seconds, is_next)) return 1.0;
  if (std::ranges::any_of(milliseconds, is_next)) return 1000.0;
  const std::string_view word = text.substr(0, text.find_first_of(" \t\r,;)]=:"));
  const std::size_t behind = text.find_first_not_of(" \t", word.size());
  const bool is_key = behind != std::string_view::npos && (text[behind] == '=' || text[behind] == ':');
  if (is_behind_comma || is_key || is_next("npts")) return 1.0;
  problems.reject_line(word, "is not a known unit of time", "write the time step as DT= .01 SEC or DT= 10 MSEC");
  return std::nullopt;
}

/// Reads both forms of the line: `NPTS=  4000, DT=   .0100 SEC` and `4000  0.0050  NPTS, DT`. Absent, and reported,
/// where a number is missing, a key stands twice, or the unit of the time step is not known.
std::optional<PeerCounts> peer_counts(std::string_view line, LineProblems& problems) {
  const std::size_t dt = *word_place(line, "dt");
  const std::string_view behind_dt = line.substr(dt + 2);
  const std::string_view behind_npts = line.substr(*word_place(line, "npts") + 4);
  if (word_place(behind_dt, "dt") || word_place(behind_npts, "npts")) {
    problems.reject_line(line, "gives NPTS or DT a second time", "correct the header: each stands there once");
    return std::nullopt;
  }
  auto count = number_after(line, "npts");
  auto step = number_after(line, "dt");
  std::string_view unit = behind_dt;
  if (step) unit = line.substr(static_cast<std::size_t>(step->data() + step->size() - line.data()));
  std::vector<std::string_view> fields;
  split_fields(line, fields);
  if (!count && !step && fields.size() >= 2 && is_number_field(fields[0]) && is_number_field(fields[1])) {
    count = fields[0];
    step = fields[1];
  }
  if (!count || !step) {
    problems.reject_line(line, "does not give a number after NPTS and after DT", "write it as NPTS= 4000, DT= .01 SEC");
    return std::nullopt;
  }
  const auto per_second = units_per_second(unit, problems);
  if (!per_second) return std::nullopt;
  return PeerCounts{.count = *count, .step = *step, .units_per_second = *per_second};
}

constexpr std::size_t most_lines_of_a_peer_header = 100;
constexpr const char* file_of_accelerations = "give the file of accelerations, whose name ends in .AT2";

bool speaks_of_acceleration(std::string_view line) {
  return word_place(line, "acceleration") || word_place(line, "accelerations") || word_place(line, "accel");
}

/// What a line says that the file contains instead of accelerations; empty: nothing.
std::string_view other_motion_in(std::string_view line) {
  if (speaks_of_acceleration(line)) return {};
  const bool speaks_of_data = word_place(line, "time") || word_place(line, "units") || !units_among_words(line).empty();
  for (const std::string_view other : {"velocity", "displacement"}) {
    if (speaks_of_data && word_place(line, other)) return other;
  }
  return {};
}

std::string in_words(UnitKind kind) { return kind == UnitKind::velocity ? "velocity" : "displacement"; }

/// The reader of the lines above the data.
class PeerHeader {
 public:
  PeerHeader(const GroundMotionReading& how, LineProblems& problems) : how_(how), problems_(problems) {}

  /// Takes the header off `text`. Absent where anything is wrong with it.
  std::optional<EvenHeader> read(std::string_view& text) {
    while (!text.empty() && problems_.line() < most_lines_of_a_peer_header && !problems_.enough()) {
      const std::string_view line = problems_.next_line(text);
      read_title(line);
      if (word_place(line, "npts") && word_place(line, "dt")) return whole(line);
      has_counts_ = has_counts_ || number_after(line, "npts") || number_after(line, "dt");
    }
    problems_.reject_file("has no line with NPTS and DT among its first 100",
                          "give a file in PEER's .AT2 format, or another \"format\"");
    return std::nullopt;
  }

  [[nodiscard]] const std::string& component() const { return component_; }
  [[nodiscard]] const std::string& origin() const { return origin_; }
  [[nodiscard]] bool states_unit() const { return stated_.has_value(); }

 private:
  void read_title(std::string_view line) {
    if (const auto other = other_motion_in(line); !other.empty()) {
      problems_.reject_line(line, "says that the file contains a " + std::string(other), file_of_accelerations);
      return;
    }
    if (component_.empty()) {
      component_ = component_in(line);
      // RIO DELL, RIO DELL OVERPASS FF, 270: earthquake and station stand before the component.
      const std::size_t comma = line.rfind(',', std::min(line.find('('), line.size()));
      if (!component_.empty() && comma != std::string_view::npos) origin_ = trimmed(line.substr(0, comma));
    }
    const std::vector<StatedUnit> stated = units_stated(line);
    for (const StatedUnit& found : stated) take(found, stated_);
    if (!stated.empty() || !speaks_of_acceleration(line)) return;
    for (const StatedUnit& found : units_among_words(line)) take(found, mentioned_);
  }

  void take(const StatedUnit& found, std::optional<RecordUnit>& known) {
    switch (found.unit.kind) {
      case UnitKind::time: return;
      case UnitKind::multiple:
      case UnitKind::scaled:
      case UnitKind::unknown:
        return problems_.reject_line(found.text, "is not a known unit of acceleration",
                                     "correct the header; known: " + record_units_in_words());
      case UnitKind::velocity:
      case UnitKind::displacement:
        return problems_.reject_line(found.text, "is the unit of a " + in_words(found.unit.kind),
                                     file_of_accelerations);
      case UnitKind::acceleration: break;
    }
    const RecordUnit unit = found.unit.acceleration;
    if (known && *known != unit) {
      problems_.reject_line(found.text, "contradicts a line above it, which states " + std::string(name_of(*known)),
                            "correct the header: all accelerations of a file have one unit");
    }
    known = unit;
    expect_asked_unit(unit, how_.unit, problems_);
  }

  /// The header as a whole, whose last line is `line`.
  std::optional<EvenHeader> whole(std::string_view line) {
    if (!stated_) stated_ = mentioned_;
    if (!stated_) expect_name_of_accelerations();
    if (has_counts_) {
      problems_.reject_line(line, "gives NPTS or DT a second time", "correct the header: each stands there once");
    }
    const auto counts = peer_counts(line, problems_);
    if (!counts) return std::nullopt;
    const auto declared = checked_count(counts->count, problems_);
    const auto time_step = checked_time_step(counts->step, counts->units_per_second, how_.time_step, problems_);
    if (!declared || !time_step || problems_.any()) return std::nullopt;
    return EvenHeader{
        .time_step = *time_step, .declared = declared, .unit = stated_.value_or(how_.unit.value_or(RecordUnit::g))};
  }

  /// Velocities and displacements have the same header; where it states no unit, the name of the file tells.
  void expect_name_of_accelerations() {
    constexpr std::array<std::pair<std::string_view, std::string_view>, 4> endings{
        {{".vt2", "velocity"}, {".VT2", "velocity"}, {".dt2", "displacement"}, {".DT2", "displacement"}}};
    for (const auto& [ending, kind] : endings) {
      if (!how_.name.ends_with(ending)) continue;
      problems_.reject_file("is the file of a " + std::string(kind) + " by its name, and states no unit",
                            file_of_accelerations);
    }
  }

  const GroundMotionReading& how_;
  LineProblems& problems_;
  std::optional<RecordUnit> stated_;     ///< after the word "units"
  std::optional<RecordUnit> mentioned_;  ///< in a line that speaks of accelerations
  std::string component_, origin_;
  bool has_counts_ = false;  ///< NPTS or DT stands in a line above
};

}  // namespace

bool is_line_of_peer_header(std::string_view line) { return word_place(line, "npts") && word_place(line, "dt"); }

std::optional<GroundMotion> read_peer_at2(std::string_view text, const GroundMotionReading& how, Problems& found) {
  LineProblems problems(how.name, found);
  text = without_byte_order_mark(text);
  PeerHeader reader(how, problems);
  const auto header = reader.read(text);
  if (!header) return std::nullopt;
  auto motion = read_even_samples(text, *header, how.gravity, problems);
  if (motion) motion->component = reader.component();
  if (motion) motion->origin = reader.origin();
  if (motion && !reader.states_unit() && !how.unit) {
    motion->unit_is_assumed = true;
    motion->warnings.push_back(unit_assumed(RecordUnit::g));
  }
  return motion;
}

}  // namespace rocking
