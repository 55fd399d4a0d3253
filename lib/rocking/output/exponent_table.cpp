#include "rocking/output/exponent_table.hpp"

#include <algorithm>
#include <vector>

#include "rocking/output/mode_table.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

constexpr int digits = 3;

std::string quantile_at(const Exponents& found, double level, bool with_interval) {
  const auto quantile = std::ranges::find(found.quantiles.levels, level, &stats::QuantileEstimate::level);
  if (quantile == found.quantiles.levels.end() || !quantile->value) return "-";
  const std::string value = significant(*quantile->value, digits);
  if (!with_interval) return value;
  const auto end = [](const std::optional<double>& at) { return at ? significant(*at, digits) : "-"; };
  return value + " [" + end(quantile->low) + ", " + end(quantile->high) + ']';
}

}  // namespace

std::string exponent_table(const Report& report) {
  TextRow header;
  for (const std::string& pointer : report.swept) header.push_back(last_key(pointer));
  header.insert(header.end(), {"n", "exponents", "median", "5 %", "95 %", "mean", "its error", "error of one"});
  std::vector<TextRow> rows{header};
  for (const ReportedCondition& condition : report.conditions) {
    if (!condition.result.exponents) continue;
    const Exponents& found = *condition.result.exponents;
    TextRow& row = rows.emplace_back();
    for (const Parameter& parameter : condition.parameters) row.push_back(short_value(parameter));
    row.insert(row.end(), {std::to_string(condition.result.realisations), std::to_string(found.quantiles.realisations),
                           quantile_at(found, 0.5, true), quantile_at(found, 0.05, false),
                           quantile_at(found, 0.95, false), significant(found.mean, digits),
                           found.standard_error ? significant(*found.standard_error, digits) : "-",
                           significant(found.error_of_one, digits)});
  }
  if (rows.size() == 1) return {};
  return "\nlargest Lyapunov exponent per excitation period, of the realisations whose classification needed it\n" +
         aligned(rows) +
         "median with its interval, quantiles and mean over realisations; error of one: of a single exponent; above 0: "
         "neighbouring motions part\n\n";
}

}  // namespace rocking
