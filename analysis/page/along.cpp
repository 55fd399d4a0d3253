#include "analysis/page/along.hpp"

#include <fmt/format.h>

#include "analysis/page/html.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {

bool has_few_slices(const SweepView& view) { return view.is_line && view.slices.size() <= most_answers; }

std::string by_slice(const Report& report, const SweepView& view,
                     const std::function<std::string(const Along&)>& sentence) {
  if (view.slices.size() == 1) return "<p>" + sentence(Along(report, view, view.slices.front())) + ".</p>\n";
  std::string text = "<ul>\n";
  for (const Slice& slice : view.slices) {
    text += fmt::format("<li><b>{}:</b> {}.</li>\n", with_symbols(slice.name), sentence(Along(report, view, slice)));
  }
  return text + "</ul>\n";
}

std::string probability_at(const ReportedCondition& condition, const section::ResponseMode& mode) {
  const AnyShare share = share_of(condition, mode);
  return share.interval ? probability_text(share.estimate, *share.interval) : per_cent(share.estimate) + " %";
}

std::string count_at(const ReportedCondition& condition, const section::ResponseMode& mode) {
  return fmt::format(", {} of {}", share_of(condition, mode).count,
                     counted(condition.result.realisations, "realisation"));
}

}  // namespace rocking::analysis
