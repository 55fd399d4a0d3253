#include "analysis/page/page.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "analysis/page/answer.hpp"
#include "analysis/page/assets.hpp"
#include "analysis/page/html.hpp"
#include "analysis/page/question.hpp"
#include "analysis/page/trust.hpp"

namespace rocking::analysis {
namespace {

/// A part of the page, with the beginnings of the names of its figures.
struct Part {
  const char* id;
  const char* heading;
  std::vector<std::string> figures;  ///< beginnings of names
};

const std::vector<Part>& parts() {
  static const std::vector<Part> all{{"responses", "Which responses occur, and how likely are they?", {"mode_"}},
                                     {"extent", "How far does the block move?", {"peak_", "final_"}},
                                     {"recurrence", "Is the response repeatable?", {"non_recurrence", "parting"}},
                                     {"question", "What was simulated?", {"scene"}},
                                     {"more", "More figures", {""}}};
  return all;
}

bool belongs(const Part& part, const Figure& figure) {
  return std::ranges::any_of(part.figures, [&](const std::string& start) { return figure.name.starts_with(start); });
}

std::string head(const std::string& title) {
  const std::string style = dygraphs_style() + page_style();
  const std::string library = dygraphs_script();
  const std::string script = page_script();
  const std::string scripts = library.empty() ? policy_hash(script) : policy_hash(library) + ' ' + policy_hash(script);
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta "
      "http-equiv=\"Content-Security-Policy\" "
      "content=\"default-src 'none'; style-src {}; script-src {}; img-src data:; base-uri 'none'; form-action "
      "'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n<link rel=\"icon\" "
      "href=\"data:,\">\n<style>{}</style>\n</head>\n",
      policy_hash(style), scripts, escaped(title), style);
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

/// Figures by part: each goes to the first part that has a beginning of its name.
std::map<std::string, std::string> figures_by_part(const RunReport& report, const std::vector<DrawnFigure>& figures) {
  std::map<std::string, std::string> content;
  for (const DrawnFigure& drawn : figures) {
    const auto part = std::ranges::find_if(parts(), [&](const Part& each) { return belongs(each, drawn.figure); });
    content[part->id] += figure_html(report, drawn);
  }
  return content;
}

constexpr std::string_view dygraphs_licence =
    "Copyright (c) 2006, 2009, 2011, 2012, 2013, 2017 Dan Vanderkam and other contributors. Permission is hereby "
    "granted, free "
    "of charge, to any person obtaining a copy of this software and associated documentation files (the \"Software\"), "
    "to deal "
    "in the Software without restriction, including without limitation the rights to use, copy, modify, merge, "
    "publish, "
    "distribute, sublicense, and/or sell copies of the Software, and to permit persons to whom the Software is "
    "furnished to do "
    "so, subject to the following conditions: The above copyright notice and this permission notice shall be included "
    "in all "
    "copies or substantial portions of the Software. THE SOFTWARE IS PROVIDED \"AS IS\", WITHOUT WARRANTY OF ANY KIND, "
    "EXPRESS "
    "OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND "
    "NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER "
    "LIABILITY, "
    "WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR "
    "THE USE OR "
    "OTHER DEALINGS IN THE SOFTWARE.";

std::string footer() {
  if (dygraphs_script().empty()) return "";
  return fmt::format(
      "<footer>\n<details><summary>Charts by dygraphs, under the MIT licence</summary>\n<p>{}</p></details>\n"
      "</footer>\n",
      escaped(dygraphs_licence));
}

std::string scripts() {
  const std::string library = dygraphs_script();
  std::string text;
  if (!library.empty()) text += "<script>" + library + "</script>\n";
  return text + "<script>" + page_script() + "</script>\n";
}

}  // namespace

std::string page_text(const RunReport& report, const std::vector<DrawnFigure>& figures) {
  const std::string title = report.title.empty() ? "A rocking block" : report.title;
  const auto checks = checks_of(report);
  std::string text = head(title);
  text += fmt::format(
      "<body>\n<a class=\"skip\" href=\"#main\">To the results</a>\n<header>\n<h1>{}</h1>\n</header>\n<main "
      "id=\"main\">\n<div class=\"cards\">\n",
      escaped(title));
  auto content = figures_by_part(report, figures);
  const auto link = [&content](const char* id) { return content.contains(id) ? id : ""; };
  text += card("asked", "What was simulated?", question_in_brief(report), "question");
  text +=
      card("likely", "Which responses occur, and how likely are they?", responses_in_brief(report), link("responses"));
  text += card("repeats", "Is the response repeatable?", recurrence_in_brief(report), link("recurrence"));
  text += card("believe", "Can the results be trusted?", trust_in_brief(checks), "trust");
  text += "</div>\n";
  for (const Part& part : parts()) {
    if (part.id != std::string_view("question") && content.contains(part.id)) {
      text += section(part.id, part.heading, content[part.id]);
    }
  }
  text += section("trust", "Can the results be trusted?", trust_in_full(checks));
  text += section("question", "What was simulated?", content["question"] + question_in_full(report));
  text += section("again", "Origin of the results", provenance(report));
  return text + "</main>\n" + footer() + scripts() + "</body>\n</html>\n";
}

}  // namespace rocking::analysis
