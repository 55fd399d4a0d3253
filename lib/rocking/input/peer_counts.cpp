#include "rocking/input/peer_counts.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "rocking/input/header_words.hpp"

namespace rocking {
namespace {

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

}  // namespace

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

}  // namespace rocking
