#include "rocking/input/read_hazard.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>
#include <vector>

#include "rocking/base/number_text.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {
namespace {

struct MeasureSpelling {
  std::string_view word;
  std::string_view name;
  double divisor;
};
/// Measures in other words and units than a run has. OpenQuake's PGV is in cm/s.
constexpr std::array<MeasureSpelling, 5> other_spellings{{{"pga", "pga_g", 1.0},
                                                          {"pga(g)", "pga_g", 1.0},
                                                          {"pgv", "pgv_m_s", 100.0},
                                                          {"pgv_cm_s", "pgv_m_s", 100.0},
                                                          {"pgv(cm/s)", "pgv_m_s", 100.0}}};

/// In small letters, with round brackets.
std::string in_small_letters(std::string_view word) {
  std::string text;
  for (const char c : word) {
    text += c == '[' ? '(' : c == ']' ? ')' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return text;
}

std::string blanks_removed(std::string text) {
  std::erase(text, ' ');
  return text;
}

/// `name(content)` as its two parts; without brackets the content is absent.
std::pair<std::string, std::optional<std::string>> in_parts(const std::string& text) {
  const std::size_t open = text.find('(');
  if (open == std::string::npos || !text.ends_with(')')) return {text, std::nullopt};
  return {text.substr(0, open), text.substr(open + 1, text.size() - open - 2)};
}

std::optional<double> positive(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_read = error == std::errc() && end == text.data() + text.size();
  return is_read && value > 0.0 && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// `1.0` as `1`, and `0.20-2` as `0.2-2`.
std::optional<std::string> periods_of(std::string_view text) {
  const std::size_t dash = text.find('-');
  const std::optional<double> first = positive(text.substr(0, dash));
  if (!first) return std::nullopt;
  if (dash == std::string_view::npos) return base::shortest(*first);
  const std::optional<double> last = positive(text.substr(dash + 1));
  return last ? std::optional(base::shortest(*first) + '-' + base::shortest(*last)) : std::nullopt;
}

/// The period of `sa0p2`, `sa10p0`, as the USGS writes it; absent: it is none.
std::optional<double> usgs_period(std::string_view text) {
  if (!text.starts_with("sa") || text.find_first_not_of("0123456789p", 2) != std::string_view::npos)
    return std::nullopt;
  std::string number(text.substr(2));
  const std::size_t point = number.find('p');
  if (point == std::string::npos) return std::nullopt;
  number[point] = '.';
  return positive(number);
}

bool is_intensity(const std::string& name) {
  return std::ranges::find(all_intensity_pointers, "/excitation/" + name) != all_intensity_pointers.end();
}

}  // namespace

std::optional<HazardMeasure> hazard_measure(std::string_view word) {
  constexpr std::string_view pointer = "/excitation/";
  if (word.starts_with(pointer)) word.remove_prefix(pointer.size());
  const std::string text = blanks_removed(in_small_letters(word));
  if (is_intensity(text)) return HazardMeasure{.name = text};
  for (const MeasureSpelling& spelling : other_spellings) {
    if (text == spelling.word) return HazardMeasure{.name = std::string(spelling.name), .divisor = spelling.divisor};
  }
  if (const auto period = usgs_period(text)) return HazardMeasure{.name = "sa_g[" + base::shortest(*period) + ']'};
  auto [name, content] = in_parts(text);
  if (name == "sa" || name == "psa") name = "sa_g";
  for (const std::string_view unit : {"sec", "s"}) {
    if (content && content->ends_with(unit)) content->resize(content->size() - unit.size());
  }
  const bool has_periods = is_intensity(name) && name.find("sa_") != std::string::npos;
  const std::optional<std::string> periods = content && has_periods ? periods_of(*content) : std::nullopt;
  if (!periods) return std::nullopt;
  return HazardMeasure{.name = name + '[' + *periods + ']'};
}

std::optional<HazardKind> hazard_kind(std::string_view word) {
  const auto [name, content] = in_parts(in_small_letters(word));
  std::vector<std::string> words(1);
  for (const char c : name) {
    if (c != ' ' && c != '_' && c != '-') {
      words.back() += c;
    } else if (!words.back().empty()) {
      words.emplace_back();
    }
  }
  const auto take = [&words](std::string_view known) { return std::erase(words, known) > 0; };
  take("");
  take("mean"), take("of"), take("exceedance");
  const bool is_per_year = take("per") && take("year");
  const bool is_annual = take("annual") || is_per_year;
  if (words.size() != 1) return std::nullopt;
  const std::string& what = words.front();
  const bool is_rate = what == "rate" || what == "frequency" || what == "afe" || what == "mafe";
  if (is_rate) {
    const bool is_known = !content || *content == "1/year" || *content == "1/yr";
    return is_known ? std::optional(HazardKind{}) : std::nullopt;
  }
  if (what != "poe" && what != "probability" && what != "apoe" && what != "aep") return std::nullopt;
  HazardKind kind{.is_probability = true};
  if (is_annual || what.starts_with('a')) kind.years = 1.0;
  if (!content) return kind;
  const std::optional<double> stated = positive(*content);
  if (!stated || kind.years) return std::nullopt;
  kind.years = stated;
  return kind;
}

}  // namespace rocking
