#include "analysis/page/answer.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "analysis/mode_figures.hpp"
#include "analysis/overview.hpp"
#include "analysis/page/html.hpp"
#include "analysis/page/mode_drawing.hpp"
#include "analysis/page/words.hpp"
#include "analysis/sweep_view.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

using section::ResponseMode;

constexpr ResponseMode overturned{.kind = section::ResponseKind::overturned};

/// Neighbouring conditions of a slice; places in it, both included.
struct Range {
  std::size_t first, last;
};

/// The conditions of a slice, with their names as positions along the sweep.
class Along {
 public:
  Along(const Report& report, const SweepView& view, const Slice& slice)
      : report_(&report), slice_(&slice), entry_(view.entry) {}

  [[nodiscard]] std::size_t size() const { return slice_->conditions.size(); }
  [[nodiscard]] const ReportedCondition& at(std::size_t place) const {
    return report_->conditions[slice_->conditions[place]];
  }
  /// `A_h = 4.5`, as HTML.
  [[nodiscard]] std::string name(std::size_t place) const {
    const Parameter& parameter = at(place).parameters[entry_];
    return place_html(parameter.pointer, value_of(parameter));
  }
  /// The value only, where the quantity has been named.
  [[nodiscard]] std::string value(std::size_t place) const {
    const Parameter& parameter = at(place).parameters[entry_];
    return place_value_html(parameter.pointer, value_of(parameter));
  }
  [[nodiscard]] std::string name(const Range& range) const {
    if (range.first == range.last) return name(range.first);
    return name(range.first) + " to " + value(range.last);
  }

  /// Neighbouring conditions for which `kind` has the same value.
  template <class Kind>
  [[nodiscard]] std::vector<Range> ranges(const Kind& kind) const {
    std::vector<Range> found;
    for (std::size_t i = 0; i < size(); ++i) {
      if (i > 0 && kind(at(i)) == kind(at(i - 1))) {
        found.back().last = i;
      } else {
        found.push_back({.first = i, .last = i});
      }
    }
    return found;
  }

 private:
  const Report* report_;
  const Slice* slice_;
  std::size_t entry_;
};

bool is_suite(const Report& report) { return report.input.experiment.at("excitation").contains("suite"); }

bool overturns(const ReportedCondition& condition) { return share_of(condition, overturned).count > 0; }

std::string level_of(const ReportedCondition& condition) { return level_text(condition.confidence) + " %"; }

/// `(at most 2.8 % there, 95 %)`; empty if the report has no bound.
std::string bound_at(const ReportedCondition& condition) {
  const AnyShare share = share_of(condition, overturned);
  if (!share.interval) return "";
  return fmt::format(" (at most {} % there, {})", per_cent(share.interval->high), level_of(condition));
}

std::string probability_at(const ReportedCondition& condition, const ResponseMode& mode) {
  const AnyShare share = share_of(condition, mode);
  return share.interval ? probability_text(share.estimate, *share.interval) : per_cent(share.estimate) + " %";
}

/// `, 48 of 300000 realisations`.
std::string count_at(const ReportedCondition& condition, const ResponseMode& mode) {
  return fmt::format(", {} of {}", share_of(condition, mode).count,
                     counted(condition.result.realisations, "realisation"));
}

std::string list_of(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  }
  return text;
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
  const bool random = along.at(last).result.is_random();
  if (last == 0) return (random ? "None seen at " : "Does not overturn at ") + along.name(0) + bound_at(along.at(0));
  if (!random) return "Does not overturn from " + along.name(Range{0, last});
  return "No overturning seen up to " + along.name(last) + bound_at(along.at(last));
}

/// `No overturning seen up to 1.05 g (at most 2.8 % there, 95 %); seen from 1.1 g to 1.5 g, most likely at 1.5 g: 13 %
/// [5.5, 24.4]`.
std::string overturning_along(const Along& along) {
  std::size_t first = 0;
  std::size_t most = 0;
  while (first < along.size() && !overturns(along.at(first))) ++first;
  if (first == along.size()) return never_overturns(along);
  for (std::size_t i = 0; i < along.size(); ++i) {
    if (share_of(along.at(i), overturned).estimate > share_of(along.at(most), overturned).estimate) most = i;
  }
  if (!along.at(most).result.is_random()) {
    return (first > 0 ? "Does not overturn up to " + along.name(first - 1) + "; overturns " : "Overturns ") +
           where_it_overturns(along);
  }
  std::string text;
  if (first > 0) text = "No overturning seen up to " + along.name(first - 1) + bound_at(along.at(first - 1)) + "; ";
  text += (first > 0 ? "seen " : "Overturning seen ") + where_it_overturns(along);
  return text + fmt::format("; most likely at {}: <strong>{}</strong>{}", along.name(most),
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
  if (number == 0 && !report.is_random()) return "The block does not overturn";
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
  return fmt::format("Seen {}; most likely at {}: <strong>{}</strong>{}", where, place,
                     probability_at(condition, overturned), count_at(condition, overturned));
}

/// A sentence for each slice, after its name.
std::string by_slice(const Report& report, const SweepView& view,
                     const std::function<std::string(const Along&)>& sentence) {
  if (view.slices.size() == 1) return "<p>" + sentence(Along(report, view, view.slices.front())) + ".</p>\n";
  std::string text = "<ul>\n";
  for (const Slice& slice : view.slices) {
    text += fmt::format("<li><b>{}:</b> {}.</li>\n", with_symbols(slice.name), sentence(Along(report, view, slice)));
  }
  return text + "</ul>\n";
}

bool has_few_slices(const SweepView& view) { return view.is_line && view.slices.size() <= most_answers; }

/// The most frequent mode of a condition; of equally frequent ones the first.
ResponseMode most_likely(const ReportedCondition& condition) {
  ResponseMode mode;
  std::uint64_t highest = 0;
  for (const auto& [each, probability] : condition.result.modes) {
    if (probability.counts.successes <= highest) continue;
    highest = probability.counts.successes;
    mode = each;
  }
  return mode;
}

/// `rocks once in three periods (1,3)`.
std::string mode_in_words(const ResponseMode& mode) {
  const std::string meaning = meaning_of(mode);
  return mode.kind == section::ResponseKind::periodic ? meaning + ' ' + escaped(to_string(mode)) : meaning;
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
  return std::string(has_periodic
                         ? "(<i>m</i>,<i>n</i>): the block rocks <i>m</i> times, to the left and to the right, in "
                           "<i>n</i> periods of the shaking, and repeats this. "
                         : "") +
         "Drawings: tilt against time (thick line) above the acceleration of the floor (thin line); schematic.";
}

/// Sentences about a suite, one line for each of its curves.
std::string suite_in_brief(const std::string& sentences) {
  std::string text = "<p>" + with_symbols(sentences) + "</p>\n";
  for (auto at = text.find('\n'); at + 1 < text.size(); at = text.find('\n', at)) text.replace(at, 1, "</p><p>");
  return text;
}

std::string responses_along(const Along& along) {
  const auto ranges = along.ranges(most_likely);
  std::vector<std::string> parts;
  for (const Range& range : ranges) {
    const ResponseMode mode = most_likely(along.at(range.first));
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

/// The response modes of the only condition, each with a bar from 0 to 100 % and its interval as a line with caps.
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
        "preserveAspectRatio=\"none\" "
        "role=\"img\" aria-label=\"{}\"><rect class=\"whole\" width=\"100\" height=\"10\"/><rect "
        "width=\"{:.2f}\" height=\"10\"/>{}</svg><span>{}{}</span></li>\n",
        mode_drawing(mode), escaped(to_string(mode)), meaning_of(mode), value, 100.0 * share.estimate, ends, value,
        count_at(condition, mode));
  }
  return fmt::format(
      "<ul class=\"shares\">\n{}</ul>\n<p class=\"small\">Bars: share of the realisations, from 0 to 100 %; lines with "
      "caps: {} interval, simultaneous for all modes. {}</p>\n",
      entries, escaped(report.level()), legend_of_modes(report));
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

std::string divergences(const Report& report, const char* cause, DivergenceTimes NonRecurrence::*member) {
  const PooledDivergence pooled = pooled_divergence(report, member);
  if (pooled.pairs == 0) return "";
  std::string text = fmt::format("{}: {} of {} diverge", cause, pooled.diverged, counted(pooled.pairs, "pair"));
  if (pooled.median) {
    text += fmt::format("; median divergence time (median over the conditions): {} {}", significant(*pooled.median, 4),
                        *pooled.median == 1.0 ? "period" : "periods");
  }
  return "<li>" + text + ".</li>\n";
}

/// Where nothing differs within any condition.
std::string alike(const Report& report) {
  if (const auto unresolved = unresolved_responses(report); unresolved.count > 0) {
    return fmt::format(
        "Not known: the realisations of each condition were classified alike, but {} of {} as unresolved.",
        unresolved.count, counted(realisations_of(report), "realisation"));
  }
  double most = 0.0;
  for (const ReportedCondition& condition : report.conditions) {
    if (condition.result.non_recurrence) most = std::max(most, condition.result.non_recurrence->differ_interval.high);
  }
  const bool lone = report.conditions.size() == 1;
  const std::string limit = fmt::format(" {} runs differ with a probability of at most {} % ({}).",
                                        lone ? "Two" : "In any one of them, two", per_cent(most), report.level());
  if (is_suite(report)) {
    return "Under each ground motion, at each level, all realisations responded alike, although the block is random: "
           "one realisation of each suffices for the response mode. What differs is the ground motion." +
           limit;
  }
  return (lone ? std::string("All realisations") : std::string("Within each condition all realisations")) +
         " responded alike, although something is random: one realisation" + (lone ? "" : " of each") +
         " suffices for the response mode." + limit;
}

std::string repeatability(const Report& report) {
  const Repeatability found = repeatability_of(report);
  if (!report.is_random()) return "<p>Nothing is random: the same shaking gives the same response.</p>\n";
  if (found.compared == 0) return "<p>There is one realisation per condition, so that none can be compared.</p>\n";
  if (found.alike == found.compared) return "<p>" + alike(report) + "</p>\n";
  const NonRecurrence& worst = *report.conditions[*found.least].result.non_recurrence;
  const bool lone = report.conditions.size() == 1;
  return fmt::format(
      "<p>{}wo runs under the same shaking respond differently with probability <strong>{}</strong>{}.</p>\n",
      lone ? "T" : fmt::format("Least repeatable at {}: t", with_symbols(condition_name(report, *found.least))),
      probability_text(worst.differ, worst.differ_interval),
      lone ? ""
           : fmt::format(". In {} of {} all realisations have the same response mode", found.alike,
                         counted(found.compared, "condition")));
}

}  // namespace

std::string overturning_in_brief(const Report& report) {
  const SweepView view = view_of(report);
  if (has_few_slices(view)) return by_slice(report, view, overturning_along);
  return "<p>" + overturning_anywhere(report) + ".</p>\n";
}

std::string responses_in_brief(const Report& report) {
  const SweepView view = view_of(report);
  if (has_few_slices(view)) return by_slice(report, view, responses_along);
  return "<p>" + responses_anywhere(report) + ".</p>\n";
}

std::string recurrence_in_brief(const Report& report) {
  if (repeatability_of(report).compared == 0) return repeatability(report);
  return "<p>Two runs under the same shaking have diverged when tilt and tilt rate, compared once a period, differ by "
         "more "
         "than 0.01. With</p>\n<ul>\n" +
         divergences(report, "independent random numbers", &NonRecurrence::friction) +
         divergences(report, "common random numbers and another tolerance", &NonRecurrence::arithmetic) + "</ul>\n";
}

std::string modes_in_brief(const Report& report) {
  std::string entries;
  for (const ResponseMode& mode : modes_to_show(report.occurring(), most_stretches)) {
    entries += fmt::format("<li>{}<span><b>{}</b> {}</span></li>\n", mode_drawing(mode), escaped(to_string(mode)),
                           meaning_of(mode));
  }
  return fmt::format("<ul class=\"modes\">\n{}</ul>\n<p class=\"small\">{}</p>\n", entries, legend_of_modes(report));
}

std::string answer_in_brief(const Report& report, const std::string& suite) {
  const bool is_random = report.is_random();
  const bool lone = report.conditions.size() == 1;
  const std::string responses = lone && is_random ? shares_in_brief(report)
                                : lone            ? modes_in_brief(report)
                                                  : responses_in_brief(report) + modes_in_brief(report);
  return fmt::format(
      "<dl class=\"short\">\n<dt>Overturning</dt><dd>{}</dd>\n<dt>{}</dt><dd>{}</dd>\n"
      "<dt>Repeatability</dt><dd>{}</dd>\n</dl>\n",
      suite.empty() ? overturning_in_brief(report) : suite_in_brief(suite),
      is_random && !lone ? "Most likely response" : "Response", responses, repeatability(report));
}

}  // namespace rocking::analysis
