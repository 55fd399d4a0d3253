#include "analysis/page/page.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "analysis/page/animation.hpp"
#include "analysis/page/html.hpp"
#include "analysis/page/sections.hpp"
#include "analysis/page/tables.hpp"
#include "analysis/run_figures.hpp"

namespace rocking::analysis {
namespace {

/// A part of the page, with the beginnings of the names of its figures.
struct Part {
  const char* id;
  const char* heading;
  std::vector<std::string> figures;  ///< beginnings of names
};

const std::vector<Part>& parts() {
  static const std::vector<Part> all{{"fragility", "All ground motions together", {"fragility", "incremental"}},
                                     {"responses", "Which responses occur, and how likely are they?", {"mode_"}},
                                     {"by-when", "Which response, and by when?", {"incidence"}},
                                     {"extent", "How far does the block move?", {"peak_", "final_"}},
                                     {"recurrence", "Is the response repeatable?", {"non_recurrence", "divergence"}},
                                     {"rare", "How does the rare event happen?", {"rare_"}},
                                     {"infer", "What do the counted tests tell?", {"infer_"}},
                                     {"question", "What was simulated?", {"scene"}},
                                     {"more", "More figures", {""}}};
  return all;
}

bool belongs(const Part& part, const Figure& figure) {
  return std::ranges::any_of(part.figures, [&](const std::string& start) { return figure.name.starts_with(start); });
}

/// `link`: address of more details; empty if there are none.
std::string card(const char* id, const char* heading, const std::string& content, const std::string& link) {
  const std::string more =
      link.empty() ? ""
                   : fmt::format("<p class=\"more\"><a href=\"#{}\">More on &ldquo;{}&rdquo;</a></p>\n", link, heading);
  return fmt::format("<article class=\"card\" aria-labelledby=\"{0}\">\n<h2 id=\"{0}\">{1}</h2>\n{2}{3}</article>\n",
                     id, heading, content, more);
}

std::string section(const char* id, const char* heading, const std::string& content) {
  return fmt::format(
      "<section id=\"{0}\" aria-labelledby=\"heading-{0}\">\n<h2 id=\"heading-{0}\">{1}</h2>\n{2}</section>\n", id,
      heading, content);
}

/// The figure that shows the answer: of a suite the probability against the intensity, otherwise the responses along the
/// sweep; null if there is neither.
const DrawnFigure* leading_of(const std::vector<DrawnFigure>& figures) {
  for (const std::string_view name : {"fragility", "mode_bands"}) {
    const auto found = std::ranges::find(figures, name, [](const DrawnFigure& drawn) { return drawn.figure.name; });
    if (found != figures.end()) return &*found;
  }
  return nullptr;
}

/// The figures below the leading one by part: each goes to the first part that has a beginning of its name. The answer
/// has the probabilities of one condition.
std::map<std::string, std::string> figures_by_part(const Report& report, const std::vector<DrawnFigure>& figures) {
  std::map<std::string, std::string> content;
  const DrawnFigure* leading = leading_of(figures);
  for (const DrawnFigure& drawn : figures) {
    if (report.conditions.size() == 1 && drawn.figure.name == "mode_probabilities") continue;
    const auto part = std::ranges::find_if(parts(), [&](const Part& each) { return belongs(each, drawn.figure); });
    const std::string html =
        &drawn == leading ? tables_html(report, drawn.figure) : figure_with_tables_html(report, drawn);
    if (!html.empty()) content[part->id] += html;
  }
  return content;
}

/// Lines of text below a figure.
std::string paragraphs(std::string_view lines) {
  std::string text;
  while (!lines.empty()) {
    const std::size_t end = std::min(lines.find('\n'), lines.size());
    if (end > 0) text += "<p class=\"description\">" + with_symbols(lines.substr(0, end)) + "</p>\n";
    lines.remove_prefix(std::min(end + 1, lines.size()));
  }
  return text;
}

/// The motions of one condition.
std::string animations_section(const ShownAnimations& shown) {
  if (shown.explanation.empty()) return "";
  return section("motion", "See it move",
                 "<p>" + with_symbols(shown.explanation) + "</p>\n" +
                     (shown.motions.empty() ? "" : animations_html(shown.motions)));
}

}  // namespace

std::string page_text(const Report& report, const std::vector<DrawnFigure>& figures, const ShownAnimations& motions) {
  const std::string title = report.title().empty() ? "A rocking block" : report.title();
  const std::vector<Finding> findings = findings_of(report);
  auto content = figures_by_part(report, figures);
  if (const std::string settling = settling_html(report); !settling.empty()) {
    content["by-when"] = settling + content["by-when"];
  }
  const auto link = [&content](const char* id) { return content.contains(id) ? id : ""; };
  const DrawnFigure* leading = leading_of(figures);
  const std::string about_suite = leading != nullptr ? leading->figure.description : "";
  const std::size_t headline = std::min(about_suite.find('\n'), about_suite.size());
  std::string shown;
  if (leading != nullptr) {
    shown = figure_html(*leading, paragraphs(about_suite.substr(headline)));
  } else if (report.conditions.size() == 1) {
    shown = data_table_html(quantiles_of_condition(report, report.conditions.front()), "How far the block moves");
  }
  std::string text = "<div class=\"asked\">" + question_at_once(report) + "</div>\n" +
                     section("answer", "In short",
                             (about_suite.empty() ? answer_in_brief(report)
                                                  : suite_in_brief(report, about_suite.substr(0, headline))) +
                                 shown);
  text += "<div class=\"cards\">\n";
  if (const std::string repeats = recurrence_in_brief(report); !repeats.empty()) {
    text += card("repeats", "Is the response repeatable?", repeats, link("recurrence"));
  }
  text += card("believe", "Can the results be trusted?", trust_in_brief(findings), "trust");
  text += "</div>\n" + animations_section(motions);
  for (const Part& part : parts()) {
    if (part.id != std::string_view("question") && content.contains(part.id)) {
      text += section(part.id, part.heading, content[part.id]);
    }
  }
  text += section("trust", "Can the results be trusted?", trust_in_full(findings));
  text += section("limits", "What is not modelled", limits_html());
  text += section("question", "What was simulated?", content["question"] + question_in_full(report));
  text += section("again", "Origin of the results", provenance(report));
  return framed({.title = title}, text);
}

}  // namespace rocking::analysis
