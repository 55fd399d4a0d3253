#include "rocking/input/record_unit.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>
#include <utility>

namespace rocking {
namespace {

void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (auto place = text.find(from); place != std::string::npos; place = text.find(from, place + to.size())) {
    text.replace(place, from.size(), to);
  }
}

/// In lower case, without what only groups or separates, and with `s` for each spelling of the second.
std::string compact(std::string_view text) {
  constexpr std::string_view left_out = " \t\r()[]{}'\"";
  std::string unit;
  for (const char c : text) {
    if (left_out.find(c) == std::string_view::npos)
      unit += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> symbols{
      {{"\u00B2", "2"}, {"\u207B", "-"}, {"\u2212", "-"}, {"\u00B7", ""}, {"\u00D7", "*"}}};
  for (const auto& [symbol, plain] : symbols) replace_all(unit, symbol, plain);
  while (unit.ends_with('.') || unit.ends_with(',')) unit.pop_back();
  for (const std::string_view second : {"seconds", "second", "secs", "sec"}) replace_all(unit, second, "s");
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

/// A unit without a factor.
WrittenUnit unit_alone(std::string unit) {
  std::erase_if(unit, [](char c) { return c == '^' || c == '*'; });
  const auto* const whole = std::ranges::find(whole_units, unit, &Spelling::text);
  if (whole != whole_units.end()) return {.kind = UnitKind::acceleration, .acceleration = whole->unit};
  if (unit == "s") return {.kind = UnitKind::time};
  for (const Spelling& length : lengths) {
    if (!unit.starts_with(length.text)) continue;
    const UnitKind kind = kind_with(std::string_view(unit).substr(length.text.size()));
    if (kind != UnitKind::unknown) return {.kind = kind, .acceleration = length.unit};
  }
  return {};
}

std::optional<double> number_taken_off(std::string_view& text) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

/// Takes `0.1`, `1e-3`, `10^-2*` or `milli-` off the front of a unit.
std::optional<double> factor_taken_off(std::string_view& unit) {
  constexpr std::array<std::pair<std::string_view, double>, 4> words{
      {{"milli-", 1e-3}, {"milli", 1e-3}, {"centi-", 1e-2}, {"centi", 1e-2}}};
  for (const auto& [word, factor] : words) {
    if (!unit.starts_with(word)) continue;
    unit.remove_prefix(word.size());
    return factor;
  }
  const auto is_times = [&unit] { return unit.starts_with('*') || unit.starts_with('x'); };
  if (is_times()) unit.remove_prefix(1);
  std::optional<double> factor = number_taken_off(unit);
  const bool is_power = factor == 10.0 && (unit.starts_with('^') || unit.starts_with("**"));
  if (is_power) {
    unit.remove_prefix(unit.starts_with('^') ? 1 : 2);
    const auto exponent = number_taken_off(unit);
    factor = exponent ? std::optional(std::pow(10.0, *exponent)) : std::nullopt;
  }
  if (factor && is_times()) unit.remove_prefix(1);
  return factor;
}

/// The unit of which `unit` is with this factor.
WrittenUnit times(double factor, RecordUnit unit) {
  const auto is_of_g = [](RecordUnit of) { return in_m_s2(of, 2.0) != in_m_s2(of, 1.0); };
  constexpr double rounding = 1e-9;
  for (std::size_t i = 0; i < record_unit_names.size(); ++i) {
    const auto other = static_cast<RecordUnit>(i);
    const double ratio = factor * in_m_s2(unit, 1.0) / in_m_s2(other, 1.0);
    if (is_of_g(other) == is_of_g(unit) && std::abs(ratio - 1.0) < rounding) {
      return {.kind = UnitKind::acceleration, .acceleration = other};
    }
  }
  return {.kind = UnitKind::multiple};
}

/// Whether a factor stands behind a unit of acceleration: `g*1000`, `m/s2 x 0.01`, `g/1000`.
bool has_factor_behind(std::string_view unit) {
  const std::size_t end = unit.find_last_not_of("0123456789.+-e^");
  if (end == std::string_view::npos || end == 0 || end + 1 == unit.size()) return false;
  const bool is_joined = unit[end] == '*' || unit[end] == 'x' || unit[end] == '/';
  const std::string_view before = unit.substr(0, is_joined ? unit.find_last_not_of('*', end - 1) + 1 : end + 1);
  return unit_alone(std::string(before)).kind == UnitKind::acceleration;
}

}  // namespace

std::string unit_assumed(RecordUnit unit) {
  return "does not state the unit of its accelerations; " + std::string(name_of(unit)) +
         " is assumed (give \"units\" for another)";
}

WrittenUnit unit_written(std::string_view text) {
  if (text.size() > longest_unit) return {};
  const std::string unit = compact(text);
  const WrittenUnit found = unit_alone(unit);
  if (found.kind != UnitKind::unknown) return found;
  std::string_view rest = unit;
  if (const auto factor = factor_taken_off(rest)) {
    const WrittenUnit alone = unit_alone(std::string(rest));
    if (alone.kind == UnitKind::acceleration) return times(*factor, alone.acceleration);
  }
  return has_factor_behind(unit) ? WrittenUnit{.kind = UnitKind::scaled} : WrittenUnit{};
}

}  // namespace rocking
