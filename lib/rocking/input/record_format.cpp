#include "rocking/input/record_format.hpp"

#include <algorithm>
#include <cctype>
#include <string>

#include "rocking/input/header_words.hpp"
#include "rocking/input/line_problems.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_header_lines = 100;

}  // namespace

std::optional<RecordUnit> record_unit_written(std::string_view text) {
  std::string unit;
  for (const char c : text) {
    if (c == ' ' || c == '\t' || c == '\r' || c == '^' || c == '*' || c == '(' || c == ')') continue;
    unit += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  while (unit.ends_with('.') || unit.ends_with(',')) unit.pop_back();
  for (const std::string_view second : {"seconds", "second", "sec"}) {
    for (auto place = unit.find(second); place != std::string::npos; place = unit.find(second)) {
      unit.replace(place, second.size(), "s");
    }
  }
  if (unit == "g") return RecordUnit::g;
  if (unit == "m/s2" || unit == "m/s/s" || unit == "m/ss") return RecordUnit::m_s2;
  if (unit == "cm/s2" || unit == "cm/s/s" || unit == "cm/ss" || unit == "gal") return RecordUnit::cm_s2;
  return std::nullopt;
}

RecordFormat recognised_format(std::string_view text) {
  text = without_byte_order_mark(text);
  for (std::size_t i = 0; i < most_header_lines && !text.empty(); ++i) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    line = line.substr(0, line.find('#'));
    if (line.starts_with("SAMPLING_INTERVAL_S:")) return RecordFormat::esm_asc;
    if (word_place(line, "npts") && word_place(line, "dt")) return RecordFormat::peer_at2;
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return RecordFormat::columns;
}

}  // namespace rocking
