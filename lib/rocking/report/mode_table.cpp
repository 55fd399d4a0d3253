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

constexpr std::size_t widest = 120;
constexpr std::size_t gap = 2;

std::string per_cent(double probability) { return fixed_point(100.0 * probability, 1); }

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
    const auto [low, high] = probability.simultaneous;
    return per_cent(probability.estimate) + " [" + per_cent(low) + ", " + per_cent(high) + ']';
  }
  return ".";
}

std::string rest_of(const ConditionResult& condition, const std::vector<ResponseMode>& shown) {
  std::uint64_t count = 0;
  for (const auto& [mode, probability] : condition.modes) {
    if (std::find(shown.begin(), shown.end(), mode) == shown.end()) count += probability.counts.successes;
  }
  if (count == 0) return ".";
  return per_cent(static_cast<double>(count) / static_cast<double>(condition.realisations));
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
  return text.find('\n');
}

}  // namespace

std::string short_value(const experiment::Parameter& parameter) {
  const Json value = Json::parse(parameter.value);
  if (value.is_number_float()) return significant(value.get<double>(), 6);
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_object()) return brief(value);
  std::string text;
  for (const auto& [key, part] : value.items()) {
    if (!text.empty()) text += '/';
    text += part.is_number() ? significant(part.get<double>(), 6) : brief(part);
  }
  return text;
}

std::string mode_table(const Experiment& experiment, const ExperimentResult& result) {
  if (result.conditions.empty()) return {};
  std::vector<TextRow> rows = leading_columns(experiment, result);
  constexpr std::size_t cell_width = std::string_view("100.0 [100.0, 100.0]").size() + gap;
  constexpr std::size_t rest_width = std::string_view("others").size() + gap;
  const std::size_t used = width_of(rows) + rest_width;
  const std::size_t room = used < widest ? std::max<std::size_t>(1, (widest - used) / cell_width) : 1;

  const auto occurring = occurring_modes(result);
  const std::vector<ResponseMode> shown = chosen_modes(occurring, room);
  const bool with_others = shown.size() < occurring.size();
  for (const ResponseMode& mode : shown) rows[0].push_back(to_string(mode));
  if (with_others) rows[0].emplace_back("others");
  for (std::size_t i = 0; i < result.conditions.size(); ++i) {
    for (const ResponseMode& mode : shown) rows[i + 1].push_back(cell(result.conditions[i], mode));
    if (with_others) rows[i + 1].push_back(rest_of(result.conditions[i], shown));
  }
  return aligned(rows);
}

}  // namespace rocking::report
