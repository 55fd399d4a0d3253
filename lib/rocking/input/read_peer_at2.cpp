#include "rocking/input/read_peer_at2.hpp"

#include <vector>

#include "rocking/input/even_samples.hpp"
#include "rocking/input/header_words.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_lines_of_a_peer_header = 100;

/// The unit that `UNITS OF G` or `units are (g)` states; absent if the line states none.
std::optional<RecordUnit> unit_in_title(std::string_view line) {
  const auto place = word_place(line, "units");
  if (!place) return std::nullopt;
  std::vector<std::string_view> words;
  split_fields(line.substr(*place), words);
  if (words.size() < 3) return std::nullopt;
  return record_unit_written(words[2]);
}

/// Reports a file of velocities or displacements, which have the same header.
void expect_acceleration(std::string_view line, LineProblems& problems) {
  if (word_place(line, "acceleration") || !(word_place(line, "time") || word_place(line, "units"))) return;
  for (const std::string_view other : {"velocity", "displacement"}) {
    if (!word_place(line, other)) continue;
    problems.reject_line(line, "says that the file contains a " + std::string(other),
                         "give the file of accelerations, whose name ends in .AT2");
  }
}

/// Both forms of the last line: `NPTS=  4000, DT=   .0100 SEC` and `4000  0.0050  NPTS, DT`.
std::optional<EvenHeader> counts_in(std::string_view line, const GroundMotionReading& how, LineProblems& problems) {
  auto count = number_after(line, "npts");
  auto step = number_after(line, "dt");
  std::vector<std::string_view> fields;
  split_fields(line, fields);
  const bool counts_first = fields.size() >= 2 && is_number_field(fields[0]) && is_number_field(fields[1]);
  if (!count && !step && counts_first) {
    count = fields[0];
    step = fields[1];
  }
  if (!count || !step) {
    problems.reject_line(line, "does not give a number after NPTS and after DT", "write it as NPTS= 4000, DT= .01 SEC");
    return std::nullopt;
  }
  const auto declared = checked_count(*count, problems);
  const auto time_step = checked_time_step(*step, how.time_step, problems);
  if (!declared || !time_step) return std::nullopt;
  return EvenHeader{.time_step = *time_step, .declared = declared};
}

}  // namespace

std::optional<GroundMotion> read_peer_at2(std::string_view text, const GroundMotionReading& how, Problems& found) {
  LineProblems problems(how.name, found);
  text = without_byte_order_mark(text);
  std::optional<RecordUnit> stated;
  while (!text.empty() && problems.line() < most_lines_of_a_peer_header) {
    const std::string_view line = problems.next_line(text);
    expect_acceleration(line, problems);
    if (const auto unit = unit_in_title(line)) stated = unit;
    if (!word_place(line, "npts") || !word_place(line, "dt")) continue;
    auto header = counts_in(line, how, problems);
    const RecordUnit unit = agreed_unit(stated, how.unit, RecordUnit::g, problems);
    if (!header || problems.any()) return std::nullopt;
    header->unit = unit;
    return read_even_samples(text, *header, how.gravity, problems);
  }
  problems.reject_file("has no line with NPTS and DT among its first 100",
                       "give a file in PEER's .AT2 format, or another \"format\"");
  return std::nullopt;
}

}  // namespace rocking
