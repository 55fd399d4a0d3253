#include "rocking/input/record_formats.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "rocking/input/even_samples.hpp"
#include "rocking/input/header_units.hpp"
#include "rocking/input/header_words.hpp"
#include "rocking/input/peer_counts.hpp"
#include "rocking/input/record_component.hpp"

namespace rocking {
namespace {

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
  [[nodiscard]] bool states_unit() const { return stated_.has_value(); }

 private:
  void read_title(std::string_view line) {
    if (const auto other = other_motion_in(line); !other.empty()) {
      problems_.reject_line(line, "says that the file contains a " + std::string(other), file_of_accelerations);
      return;
    }
    if (component_.empty()) component_ = component_in(line);
    const std::vector<StatedUnit> stated = units_stated(line);
    for (const StatedUnit& found : stated) take(found, stated_);
    if (!stated.empty() || !speaks_of_acceleration(line)) return;
    for (const StatedUnit& found : units_among_words(line)) take(found, mentioned_);
  }

  void take(const StatedUnit& found, std::optional<RecordUnit>& known) {
    switch (found.unit.kind) {
      case UnitKind::time: return;
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
  std::string component_;
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
  if (motion && !reader.states_unit() && !how.unit) {
    motion->unit_is_assumed = true;
    motion->warnings.push_back(unit_assumed(RecordUnit::g));
  }
  return motion;
}

}  // namespace rocking
