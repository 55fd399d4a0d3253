// Whether the block overturns, how likely, and where.

#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "analysis/page/along.hpp"
#include "analysis/page/html.hpp"
#include "analysis/page/sections.hpp"
#include "analysis/run_figures.hpp"
#include "rocking/output/overview.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

using section::ResponseMode;

constexpr ResponseMode overturned{.kind = section::ResponseKind::overturned};

bool overturns(const ReportedCondition& condition) { return share_of(condition, overturned).count > 0; }

/// Whether it is not known of some realisation.
bool is_open(const ReportedCondition& condition) { return condition.result.without_answer() > 0; }

std::string level_of(const ReportedCondition& condition) { return level_text(condition.asked.confidence) + " %"; }

/// `(at most 2.8 % there, 95 %)`; empty if the report has no bound.
std::string bound_at(const ReportedCondition& condition) {
  const AnyShare share = share_of(condition, overturned);
  if (!share.interval) return "";
  return fmt::format(" (at most {} % there, {})", per_cent(share.interval->high), level_of(condition));
}

std::string list_of(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  }
  return text;
}

/// `at A_h = 4.2`, or `in 89 conditions, first at A_h = 4.2` where so many conditions have the largest share.
std::string place_of_largest(std::size_t equal, const std::string& first) {
  return equal == 1 ? "at " + first : fmt::format("in {} conditions, first at {}", equal, first);
}

/// The stretches in which the block overturns.
std::string where_it_overturns(const Along& along) {
  std::vector<std::string> stretches;
  std::size_t number = 0;
  for (const Range& range : along.ranges(overturns)) {
    if (!overturns(along.at(range.first))) continue;
    number += range.last - range.first + 1;
    stretches.push_back((range.first == range.last ? "at " : "from ") + along.name(range));
  }
  if (number == along.size()) return "at every value, " + stretches.front();
  if (stretches.size() > 3) return fmt::format("in {} of {} conditions", number, along.size());
  return list_of(stretches);
}

std::string never_overturns(const Along& along) {
  const std::size_t last = along.size() - 1;
  bool random = along.at(last).result.is_random();
  for (std::size_t i = 0; i <= last; ++i) random = random || is_open(along.at(i));
  if (last == 0) return (random ? "None seen at " : "Does not overturn at ") + along.name(0) + bound_at(along.at(0));
  if (!random) return "Does not overturn from " + along.name(Range{0, last});
  return "No overturning seen up to " + along.name(last) + bound_at(along.at(last));
}

/// `No overturning seen up to 1.05 g (at most 2.8 % there, 95 %); seen from 1.1 g to 1.5 g, most likely at 1.5 g: 13 %
/// [5.5, 24.4]`.
std::string overturning_along(const Along& along) {
  std::size_t first = 0;
  std::size_t most = 0;
  std::size_t equal = 0;
  while (first < along.size() && !overturns(along.at(first))) ++first;
  if (first == along.size()) return never_overturns(along);
  const auto share_at = [&along](std::size_t i) { return share_of(along.at(i), overturned).estimate; };
  for (std::size_t i = 0; i < along.size(); ++i) {
    if (share_at(i) > share_at(most)) most = i;
  }
  for (std::size_t i = 0; i < along.size(); ++i) equal += share_at(i) == share_at(most) ? 1 : 0;
  if (!along.at(most).result.is_random()) {
    return (first > 0 ? "Does not overturn up to " + along.name(first - 1) + "; overturns " : "Overturns ") +
           where_it_overturns(along);
  }
  std::string text;
  if (first > 0) text = "No overturning seen up to " + along.name(first - 1) + bound_at(along.at(first - 1)) + "; ";
  text += (first > 0 ? "seen " : "Overturning seen ") + where_it_overturns(along);
  return text + fmt::format("; most likely {}: <strong>{}</strong>{}", place_of_largest(equal, along.name(most)),
                            probability_at(along.at(most), overturned), count_at(along.at(most), overturned));
}

/// `; the least base amplitude is at friction 0.4/0.35, base amplitude 6`: the first condition along the sweep that
/// overturns; empty if the sweep has no order.
std::string least_place(const Report& report) {
  const SweepView view = view_of(report);
  if (!view.is_line) return "";
  std::optional<std::size_t> least;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    if (overturns(report.conditions[i]) && (!least || view.x[i] < view.x[*least])) least = i;
  }
  if (!least) return "";
  return fmt::format("; the least {} is at {}", escaped(view.axis.quantity),
                     with_symbols(condition_name(report, *least)));
}

/// All conditions together, where they are too many or have no order.
std::string overturning_anywhere(const Report& report) {
  const std::size_t worst = extreme_of(report, overturned);
  const ReportedCondition& condition = report.conditions[worst];
  const auto number = std::ranges::count_if(report.conditions, overturns);
  const bool has_open = std::ranges::any_of(report.conditions, is_open);
  if (number == 0 && !report.is_random() && !has_open) return "The block does not overturn";
  if (number == 0) {
    const AnyShare share = share_of(condition, overturned);
    std::string text = fmt::format("None in {}", counted(realisations_of(report), "realisation"));
    if (report.conditions.size() > 1) text += fmt::format(" of {} conditions", report.conditions.size());
    if (!share.interval) return text;
    return text + fmt::format(": at most {} %{} ({} confidence)", per_cent(share.interval->high),
                              report.conditions.size() > 1 ? " in each condition" : "", level_of(condition));
  }
  const std::string place = with_symbols(condition_name(report, worst));
  if (report.conditions.size() == 1) {
    if (!condition.result.is_random()) return "The block overturns";
    return fmt::format("Probability <strong>{}</strong>{}", probability_at(condition, overturned),
                       count_at(condition, overturned));
  }
  const std::string where =
      fmt::format("in {} of {} conditions{}", number, report.conditions.size(), least_place(report));
  if (!condition.result.is_random()) return "The block overturns " + where;
  const auto equal = std::ranges::count_if(report.conditions, [&condition](const ReportedCondition& other) {
    return share_of(other, overturned).estimate == share_of(condition, overturned).estimate;
  });
  return fmt::format("Seen {}; most likely {}: <strong>{}</strong>{}", where,
                     place_of_largest(static_cast<std::size_t>(equal), place), probability_at(condition, overturned),
                     count_at(condition, overturned));
}

/// How many realisations of all conditions overturned to each side, where the edges differ; empty if none did.
std::string sides_in_brief(const Report& report) {
  if (!has_unlike_edges(report)) return "";
  std::uint64_t left = 0, right = 0;
  for (const ReportedCondition& condition : report.conditions) {
    if (const auto& side = condition.result.overturned_left) left += side->probability.counts.successes;
    if (const auto& side = condition.result.overturned_right) right += side->probability.counts.successes;
  }
  if (left + right == 0) return "";
  return fmt::format("<p>Of all conditions together, {} overturned to the left and {} to the right.</p>\n", left,
                     right);
}

}  // namespace

std::string overturning_in_brief(const Report& report) {
  std::uint64_t open = 0;
  for (const ReportedCondition& condition : report.conditions) open += condition.result.without_answer();
  const std::string notes =
      sides_in_brief(report) +
      (open == 0
           ? ""
           : fmt::format("<p class=\"warning\">Of {} whether they overturn is not known: they ended without an answer, "
                         "by a budget of steps or by Painlev&eacute;&#39;s paradox. The intervals cover both.</p>\n",
                         counted(open, "realisation")));
  const SweepView view = view_of(report);
  if (has_few_slices(view)) return by_slice(report, view, overturning_along) + notes;
  return "<p>" + overturning_anywhere(report) + ".</p>\n" + notes;
}

}  // namespace rocking::analysis
