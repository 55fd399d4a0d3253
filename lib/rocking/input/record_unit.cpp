#include "rocking/input/record_unit.hpp"

#include <algorithm>
#include <cctype>

namespace rocking {
namespace {

/// In lower case, without what only groups or separates, and with `s` for each spelling of the second.
std::string plain(std::string_view text) {
  constexpr std::string_view left_out = " \t\r^*()[]'\"";
  std::string unit;
  for (const char c : text) {
    if (left_out.find(c) == std::string_view::npos)
      unit += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  while (unit.ends_with('.') || unit.ends_with(',')) unit.pop_back();
  for (const std::string_view second : {"seconds", "second", "secs", "sec"}) {
    for (auto place = unit.find(second); place != std::string::npos; place = unit.find(second)) {
      unit.replace(place, second.size(), "s");
    }
  }
  return unit;
}

struct Spelling {
  std::string_view text;
  RecordUnit unit;
};

constexpr std::array<Spelling, 6> whole_units{{{"g", RecordUnit::g},
                                               {"gs", RecordUnit::g},
                                               {"gal", RecordUnit::cm_s2},
                                               {"gals", RecordUnit::cm_s2},
                                               {"mg", RecordUnit::mg},
                                               {"%g", RecordUnit::percent_g}}};

/// Lengths that stand before "per second squared".
constexpr std::array<Spelling, 5> lengths{{{"m", RecordUnit::m_s2},
                                           {"cm", RecordUnit::cm_s2},
                                           {"mm", RecordUnit::mm_s2},
                                           {"ft", RecordUnit::ft_s2},
                                           {"in", RecordUnit::in_s2}}};

/// What a length is with `suffix` behind it.
UnitKind kind_with(std::string_view suffix) {
  for (const std::string_view per_square : {"/s2", "/s/s", "/ss", "s-2"}) {
    if (suffix == per_square) return UnitKind::acceleration;
  }
  if (suffix == "/s" || suffix == "s-1") return UnitKind::velocity;
  return suffix.empty() ? UnitKind::displacement : UnitKind::unknown;
}

}  // namespace

std::string unit_assumed(RecordUnit unit) {
  return "does not state the unit of its accelerations; " + std::string(name_of(unit)) +
         " is assumed (give \"units\" for another)";
}

WrittenUnit unit_written(std::string_view text) {
  if (text.size() > longest_unit) return {};
  const std::string unit = plain(text);
  const auto whole = std::ranges::find(whole_units, unit, &Spelling::text);
  if (whole != whole_units.end()) return {.kind = UnitKind::acceleration, .acceleration = whole->unit};
  if (unit == "s") return {.kind = UnitKind::time};
  for (const Spelling& length : lengths) {
    if (!unit.starts_with(length.text)) continue;
    const UnitKind kind = kind_with(std::string_view(unit).substr(length.text.size()));
    if (kind != UnitKind::unknown) return {.kind = kind, .acceleration = length.unit};
  }
  return {};
}

}  // namespace rocking
