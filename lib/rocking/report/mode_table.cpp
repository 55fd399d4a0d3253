#include "rocking/report/mode_table.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "rocking/report/json.hpp"
#include "rocking/report/text_table.hpp"

namespace rocking::report {
namespace {

using experiment::ConditionResult;
using experiment::Experiment;
using experiment::ExperimentResult;
using section::ResponseMode;

constexpr std::size_t gap = 2;
constexpr std::size_t cell_width = std::string_view("100.0 [100.0, 100.0]").size() + gap;
constexpr std::size_t rest_width = std::string_view("others").size() + gap;
constexpr std::size_t mark_width = 2;
constexpr std::size_t shortest_bar = 12;
constexpr std::size_t longest_bar = 24;
constexpr std::size_t modes_beside_a_bar = 3;

// `/excitation/amplitude` is called `amplitude`.
std::string short_name(const std::string& pointer) { return pointer.substr(pointer.rfind('/') + 1); }

// The modes that occur anywhere, in their order, with how often they do.
std::map<ResponseMode, std::uint64_t> occurring_modes(const ExperimentResult& result) {
  std::map<ResponseMode, std::uint64_t> modes;
  for (const ConditionResult& condition : result.conditions) {
    for (const auto& [mode, probability] : condition.modes) {
      if (probability.counts.successes > 0) modes[mode] += probability.counts.successes;
    }
  }
  return modes;
}

// As many of the most frequent modes as there is room for, in the order of the modes.
std::vector<ResponseMode> chosen_modes(const std::map<ResponseMode, std::uint64_t>& occurring, std::size_t room) {
  std::vector<std::pair<ResponseMode, std::uint64_t>> ranked(occurring.begin(), occurring.end());
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
  if (ranked.size() > room) ranked.resize(room);
  std::vector<ResponseMode> modes;
  for (const auto& [mode, count] : ranked) modes.push_back(mode);
  std::sort(modes.begin(), modes.end());
  return modes;
}

std::string cell(const ConditionResult& condition, const ResponseMode& mode) {
  for (const auto& [found, probability] : condition.modes) {
    if (found != mode || probability.counts.successes == 0) continue;
    const auto [low, high] = probability.anytime.value_or(probability.simultaneous);
    return per_cent(probability.estimate) + " [" + per_cent(low) + ", " + per_cent(high) + ']';
  }
  return ".";
}

std::uint64_t count_of(const ConditionResult& condition, const ResponseMode& mode) {
  for (const auto& [found, probability] : condition.modes) {
    if (found == mode) return probability.counts.successes;
  }
  return 0;
}

std::uint64_t others_in(const ConditionResult& condition, const std::vector<ResponseMode>& shown) {
  std::uint64_t others = condition.realisations;
  for (const ResponseMode& mode : shown) others -= count_of(condition, mode);
  return others;
}

std::string rest_of(const ConditionResult& condition, const std::vector<ResponseMode>& shown) {
  const std::uint64_t count = others_in(condition, shown);
  if (count == 0) return ".";
  return per_cent(static_cast<double>(count) / static_cast<double>(condition.realisations));
}

std::string bar_of(const ConditionResult& condition, const std::vector<ResponseMode>& shown, const BarLook& look) {
  std::vector<std::uint64_t> counts;
  for (const ResponseMode& mode : shown) counts.push_back(count_of(condition, mode));
  counts.resize(most_marks, 0);
  counts.back() = others_in(condition, shown);
  return share_bar(counts, look);
}

TextRow leading_cells(const experiment::Condition& condition, const ConditionResult& result) {
  TextRow row;
  for (const experiment::Parameter& parameter : condition.parameters) row.push_back(short_value(parameter));
  row.push_back(std::to_string(result.realisations));
  return row;
}

std::vector<TextRow> leading_columns(const Experiment& experiment, const ExperimentResult& result) {
  TextRow header;
  for (const auto& parameter : experiment.conditions.front().parameters)
    header.push_back(short_name(parameter.pointer));
  header.emplace_back("n");
  std::vector<TextRow> rows{header};
  for (std::size_t i = 0; i < result.conditions.size(); ++i) {
    rows.push_back(leading_cells(experiment.conditions[i], result.conditions[i]));
  }
  return rows;
}

std::size_t width_of(const std::vector<TextRow>& rows) {
  const std::string text = aligned(rows);
  return letters_in(text.substr(0, text.find('\n')));
}

// What there is room for: columns of modes, and letters of a bar, 0 for none.
struct Layout {
  std::size_t modes = 1;
  std::size_t bar = 0;
};

Layout layout_of(std::size_t used, std::size_t occurring, const TableLook& look) {
  const auto room_beside = [&](std::size_t taken) {
    return taken < look.width ? std::max<std::size_t>(1, (look.width - taken) / cell_width) : 1;
  };
  const std::size_t with_bar = used + mark_width + gap + shortest_bar;
  const std::size_t modes = std::min({room_beside(with_bar), occurring, most_marks - 1});
  const bool drawn = look.bars && occurring > 1 && modes >= std::min(occurring, modes_beside_a_bar);
  if (!drawn) return {.modes = room_beside(used), .bar = 0};
  const std::size_t left = look.width - std::min(look.width, with_bar + modes * cell_width);
  return {.modes = modes, .bar = std::min(longest_bar, shortest_bar + left)};
}

/// In six digits, or as many more as a number just below 1 takes to differ from it.
std::string digits_of(double number) {
  constexpr int most_digits = 17;
  std::string text;
  for (int digits = 6; digits <= most_digits; ++digits) {
    text = significant(number, digits);
    if (text != "1" || number >= 1.0) break;
  }
  return text;
}

}  // namespace

std::string short_value(const experiment::Parameter& parameter) {
  const Json value = Json::parse(parameter.value);
  if (value.is_number_float()) return digits_of(value.get<double>());
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_object()) return brief(value);
  std::string text;
  for (const auto& [key, part] : value.items()) {
    if (!text.empty()) text += '/';
    text += part.is_number() ? significant(part.get<double>(), 6) : brief(part);
  }
  return text;
}

std::string mode_table(const Experiment& experiment, const ExperimentResult& result, const TableLook& look) {
  if (result.conditions.empty()) return {};
  std::vector<TextRow> rows = leading_columns(experiment, result);
  const auto occurring = occurring_modes(result);
  const Layout layout = layout_of(width_of(rows) + rest_width, occurring.size(), look);
  const std::vector<ResponseMode> shown = chosen_modes(occurring, layout.modes);
  const bool with_others = shown.size() < occurring.size();
  const auto mark = [&](std::size_t place) { return layout.bar == 0 ? "" : mark_of(place, *look.bars) + ' '; };
  for (std::size_t i = 0; i < shown.size(); ++i) rows[0].push_back(mark(i) + to_string(shown[i]));
  if (with_others) rows[0].push_back(mark(most_marks - 1) + "others");
  if (layout.bar > 0) rows[0].emplace_back("shares");
  for (std::size_t i = 0; i < result.conditions.size(); ++i) {
    const ConditionResult& condition = result.conditions[i];
    for (const ResponseMode& mode : shown) rows[i + 1].push_back(cell(condition, mode));
    if (with_others) rows[i + 1].push_back(rest_of(condition, shown));
    if (layout.bar > 0) rows[i + 1].push_back(bar_of(condition, shown, {.length = layout.bar, .letters = *look.bars}));
  }
  return aligned(rows);
}

}  // namespace rocking::report
