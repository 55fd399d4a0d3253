// The response modes, and where each is the most likely one.

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "analysis/page/along.hpp"
#include "analysis/page/html.hpp"
#include "analysis/page/sections.hpp"
#include "analysis/run_figures.hpp"
#include "rocking/output/mode_look.hpp"
#include "rocking/output/overview.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

using section::ResponseMode;

/// `rocks once in three periods (1,3)`.
std::string mode_in_words(const ResponseMode& mode) {
  const std::string meaning = meaning_of(mode);
  return mode.kind == section::ResponseKind::periodic ? meaning + ' ' + escaped(to_string(mode)) : meaning;
}

/// `; largest slip 0.5 to 1.6 m`: the medians of the conditions in which blocks slid without rocking. Empty for another mode.
std::string slip_in_words(const Report& report, const ResponseMode& mode) {
  NumberRange medians;
  for (const ReportedCondition& condition : report.conditions) {
    const auto& slip = condition.result.peaks.slip;
    if (mode.kind != section::ResponseKind::slide || !slip || share_of(condition, mode).count == 0) continue;
    if (const auto median = quantile_at(slip->metres, 0.5).value) medians.add(*median);
  }
  return medians.least <= medians.largest ? "; largest slip " + range_in_words(medians, 2) + " m" : "";
}

/// `98.5 % [94.4, 99.8]`, or `95.5 to 100.0 %` for several conditions; empty if nothing is random.
std::string probability_along(const Along& along, const Range& range, const ResponseMode& mode) {
  double least = 1.0;
  double most = 0.0;
  bool random = false;
  for (std::size_t i = range.first; i <= range.last; ++i) {
    const double estimate = share_of(along.at(i), mode).estimate;
    least = std::min(least, estimate);
    most = std::max(most, estimate);
    random = random || along.at(i).result.is_random();
  }
  if (!random) return "";
  if (range.first == range.last) return ", " + probability_at(along.at(range.first), mode);
  if (per_cent(least) == per_cent(most)) return ", " + per_cent(most) + " % each";
  return ", " + per_cent(least) + " to " + per_cent(most) + " %";
}

/// What the drawings and the names of response modes mean.
std::string legend_of_modes(const Report& report) {
  const auto occurring = report.occurring();
  const bool has_periodic = std::ranges::any_of(
      occurring, [](const auto& entry) { return entry.first.kind == section::ResponseKind::periodic; });
  return std::string(has_periodic ? "(<i>m</i>,<i>n</i>): the block rocks <i>m</i> times, to the left and to the "
                                    "right, in <i>n</i> periods of the shaking, and repeats this. "
                                  : "") +
         "Drawings: tilt against time (thick line) above the acceleration of the floor (thin line); schematic.";
}

std::string responses_along(const Along& along) {
  const auto ranges = along.ranges(most_frequent_in);
  std::vector<std::string> parts;
  for (const Range& range : ranges) {
    const ResponseMode mode = most_frequent_in(along.at(range.first));
    parts.push_back(
        fmt::format("{}: {}{}", along.name(range), mode_in_words(mode), probability_along(along, range, mode)));
    if (parts.size() == most_stretches && ranges.size() > most_stretches) {
      parts.push_back(fmt::format("then {} further changes", ranges.size() - most_stretches));
      break;
    }
  }
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : "; ") + part;
  return text;
}

/// In how many conditions each mode is the most likely one.
std::string responses_anywhere(const Report& report) {
  std::vector<std::pair<std::uint64_t, ResponseMode>> ranked;
  for (const auto& [mode, prevalence] : prevalences_of(report)) {
    if (prevalence.most_likely > 0) ranked.emplace_back(prevalence.most_likely, mode);
  }
  std::ranges::stable_sort(ranked, std::greater{}, [](const auto& entry) { return entry.first; });
  std::string text;
  for (std::size_t i = 0; i < std::min(most_stretches, ranked.size()); ++i) {
    text += fmt::format("{}{}: {}in {} of {} conditions", text.empty() ? "" : "; ", mode_in_words(ranked[i].second),
                        report.is_random() ? "most likely " : "", ranked[i].first, report.conditions.size());
  }
  return text;
}

}  // namespace

std::string responses_in_brief(const Report& report) {
  const SweepView view = view_of(report);
  if (has_few_slices(view)) return by_slice(report, view, responses_along);
  return "<p>" + responses_anywhere(report) + ".</p>\n";
}

std::string modes_in_brief(const Report& report) {
  std::string entries;
  for (const ResponseMode& mode : modes_to_show(report.occurring(), most_stretches)) {
    entries += fmt::format("<li>{}<span><b>{}</b> {}</span></li>\n", mode_drawing(mode), escaped(to_string(mode)),
                           meaning_of(mode) + slip_in_words(report, mode));
  }
  return fmt::format("<ul class=\"modes\">\n{}</ul>\n<p class=\"small\">{}</p>\n", entries, legend_of_modes(report));
}

std::string shares_in_brief(const Report& report) {
  const ReportedCondition& condition = report.conditions.front();
  std::string entries;
  for (const ResponseMode& mode : shown_modes(report)) {
    const AnyShare share = share_of(condition, mode);
    const std::string value = probability_at(condition, mode);
    const std::string ends = !share.interval
                                 ? ""
                                 : fmt::format("<path d=\"M{0:.2f} 5H{1:.2f}M{0:.2f} 2.5v5M{1:.2f} 2.5v5\"/>",
                                               100.0 * share.interval->low, 100.0 * share.interval->high);
    entries += fmt::format(
        "<li><span>{}</span><span><b>{}</b> {}</span><svg class=\"share\" viewBox=\"0 0 100 10\" "
        "preserveAspectRatio=\"none\" role=\"img\" aria-label=\"{}\"><rect class=\"whole\" width=\"100\" "
        "height=\"10\"/><rect width=\"{:.2f}\" height=\"10\"/>{}</svg><span>{}{}</span></li>\n",
        mode_drawing(mode), escaped(to_string(mode)), meaning_of(mode) + slip_in_words(report, mode), value,
        100.0 * share.estimate, ends, value, count_at(condition, mode));
  }
  return fmt::format(
      "<ul class=\"shares\">\n{}</ul>\n<p class=\"small\">Bars: share of the realisations, from 0 to 100 %; lines with "
      "caps: {} interval, simultaneous for all modes. {}</p>\n",
      entries, escaped(report.level()), legend_of_modes(report));
}

}  // namespace rocking::analysis
