#include "analysis/page/sections.hpp"

#include <fmt/format.h>

#include "analysis/page/html.hpp"

namespace rocking::analysis {
namespace {

/// Sentences about a suite, one line for each of its curves.
std::string suite_in_brief(const std::string& sentences) {
  std::string text = "<p>" + with_symbols(sentences) + "</p>\n";
  for (auto at = text.find('\n'); at + 1 < text.size(); at = text.find('\n', at)) text.replace(at, 1, "</p><p>");
  return text;
}

}  // namespace

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
