#include "rocking/output/comparison.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "rocking/output/mode_table.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/scene/shaking.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

std::string level_of(const Comparison& found) {
  return found.confidence ? level_text(*found.confidence) + " % interval"
                          : "interval at the confidence of each condition";
}

/// ` = 1.1 g`, the other form of a swept amplitude or frequency; empty for other parameters.
std::string form_beside(const Parameter& parameter, const std::optional<Shaking>& shaking) {
  for (const ShakingNumber& each : shaking_numbers) {
    if (!shaking || parameter.pointer != "/excitation/" + std::string(each.key)) continue;
    const std::string_view other = other_form_of(each.key);
    return " = " + in_unit(other, significant(number_of(*shaking, other), 3));
  }
  return "";
}

std::string name_of(const Experiment& first, std::size_t condition) {
  std::string name;
  const auto shaking = shaking_of(first.conditions[condition].scene);
  for (const Parameter& parameter : first.conditions[condition].parameters) {
    name += (name.empty() ? "" : ", ") + short_value(parameter) + form_beside(parameter, shaking);
  }
  return name.empty() ? std::to_string(condition) : name;
}

}  // namespace

std::string comparison_table(const Comparison& found, const Experiment& first) {
  std::string text;
  for (const std::string& difference : found.settings) {
    text += "first run: " + difference + " as in the second\n";
  }
  if (!text.empty()) text += '\n';
  std::uint64_t most = 0;
  std::vector<TextRow> rows{
      {"condition", "n", "changed", "mode", "first", "second", "difference", "interval", "p", "worth"}};
  for (std::size_t i = 0; i < found.conditions.size(); ++i) {
    const auto& compared = found.conditions[i];
    most = std::max(most, compared.realisations);
    for (const auto& [mode, pair] : compared.modes) {
      const auto& factor = pair.variance_reduction;
      const std::uint64_t in_first = pair.counts.both + pair.counts.first_only;
      const std::uint64_t in_second = pair.counts.both + pair.counts.second_only;
      rows.push_back(
          {name_of(first, i), std::to_string(compared.realisations), std::to_string(compared.changed.counts.successes),
           to_string(mode), per_cent(pair.in_first) + count_if_open(in_first, compared.realisations),
           per_cent(pair.in_second) + count_if_open(in_second, compared.realisations), per_cent(pair.difference),
           per_cent(pair.exact), significant(pair.test.p_value, 2), factor ? significant(*factor, 2) + "x" : "."});
    }
  }
  return text + aligned(rows) +
         "\nper cent of n realisations with common random numbers; difference = first - second with its exact " +
         level_of(found) + ";\np: exact McNemar test, one of " + std::to_string(number_of_tests(found.conditions)) +
         "; worth: variance with independent random numbers over that with common ones" + count_legend(most) + '\n';
}

}  // namespace rocking
