#include "analysis/page/sections.hpp"

#include <fmt/format.h>

#include "analysis/page/html.hpp"
#include "analysis/page/tables.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/output/settling_table.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

std::string remedies_html(const Report& report) {
  std::string entries;
  for (const ReportedCondition& condition : report.conditions) {
    const std::string remedy = limit_remedy(condition, name_of_condition(report, condition));
    if (!remedy.empty()) entries += "<li>" + with_symbols(remedy) + ".</li>\n";
  }
  return entries.empty() ? "" : "<p>The limit is too short:</p>\n<ul>\n" + entries + "</ul>\n";
}

std::string leaving_html(const Report& report) {
  std::string text = leaving_text(report);
  if (text.empty()) {
    return "<p>Settled responses were not watched, so that it is not known how often they are left again. "
           "<code>watch_windows</code> of <code>until_classified</code> watches them.</p>\n";
  }
  text.front() = text.front() == 'n' ? 'N' : 'S';
  return "<p>" + escaped(text) + ".</p>\n" + table_html(leaving_table(report), "responses that were left");
}

}  // namespace

std::string settling_html(const Report& report) {
  if (!report.has_settling()) return "";
  std::uint64_t realisations = 0;
  std::uint64_t unresolved = 0;
  std::uint64_t censored = 0;
  for (const ReportedCondition& condition : report.conditions) {
    if (!condition.result.settling) continue;
    realisations += condition.result.realisations;
    unresolved += unresolved_at_horizon(condition);
    censored += condition.result.settling->censored;
  }
  const std::string limit = common_limit(report);
  return fmt::format(
             "<p>All shares on this page are those in the end. A realisation that is unresolved at the fixed horizon "
             "goes on until its response is classified, for up to {}. {} of {} were unresolved at the fixed horizon; "
             "<strong>{}</strong> were not classified in the end.</p>\n",
             limit.empty() ? "its limit" : limit + " periods", unresolved, counted(realisations, "realisation"),
             censored) +
         remedies_html(report) + table_html(settling_table(report), "when responses settled") + leaving_html(report) +
         table_html(long_run_table(report), "long-run shares of time") +
         "<p class=\"small\">The charts show the interval at each time; the picture for printing and the files of "
         "<code>rocking report DIR</code> also have the band for all times at once.</p>\n";
}

}  // namespace rocking::analysis
