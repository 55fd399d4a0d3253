#include "analysis/page/sections.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "analysis/page/html.hpp"
#include "rocking/base/digest.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::analysis {
namespace {

std::string badge(Rating rating) {
  constexpr std::array<const char*, rating_names.size()> signs{"&#10003;", "&#8226;", "!"};
  const auto place = static_cast<std::size_t>(rating);
  return fmt::format("<span class=\"badge {0}\"><span aria-hidden=\"true\">{1}</span> {0}</span>", rating_names[place],
                     signs[place]);
}

std::string sentence(const Finding& finding) { return with_symbols(in_words(finding)) + '.'; }

}  // namespace

std::string trust_in_brief(const std::vector<Finding>& findings) {
  const auto fine = std::ranges::count(findings, Rating::fine, &Finding::rating);
  std::string text =
      fmt::format("<p>{} of {} checks passed without remark.</p>\n<ul class=\"checks\">\n", fine, findings.size());
  for (const Rating rating : {Rating::look, Rating::note}) {
    for (const Finding& each : findings) {
      if (each.rating != rating) continue;
      text += fmt::format("<li>{} {}{}</li>\n", badge(rating), escaped(each.name),
                          rating == Rating::look ? ": " + sentence(each) : "");
    }
  }
  return text + "</ul>\n";
}

std::string trust_in_full(const std::vector<Finding>& findings) {
  std::string remarks, fine;
  for (const Finding& each : findings) {
    (each.rating == Rating::fine ? fine : remarks) +=
        fmt::format("<li>{} <b>{}</b><span>{}</span></li>\n", badge(each.rating), escaped(each.name), sentence(each));
  }
  const auto list = [](const std::string& entries) {
    return entries.empty() ? "" : "<ul class=\"checks all\">\n" + entries + "</ul>\n";
  };
  const auto passed = static_cast<std::size_t>(std::ranges::count(findings, Rating::fine, &Finding::rating));
  return "<p>Possible causes of a wrong result, and what was found:</p>\n" + list(remarks) +
         (fine.empty() ? "" : folded(counted(passed, "check") + " without remark", list(fine))) +
         "<p><code>rocking trajectory</code> with this folder and the numbers of a condition and a realisation prints "
         "this realisation in full.</p>\n";
}

std::string provenance(const Report& report) {
  const SystemFacts& system = report.system;
  return fmt::format(
      "<p>The same experiment file gives the same numbers on every machine: <code>rocking verify</code> runs it again "
      "and compares the bits.</p>\n<dl class=\"settings\">\n<dt>seed</dt><dd>{}</dd>\n<dt>digest of the "
      "input</dt><dd><code>{}</code></dd>\n<dt>digest of the "
      "realisations</dt><dd><code>{}</code></dd>\n<dt>program</dt><dd>rocking {} {}</dd>\n<dt>built with</dt><dd>{} "
      "{}</dd>\n<dt>machine</dt><dd>{}</dd>\n<dt>begun</dt><dd>{}</dd>\n<dt>time</dt><dd>{} s on {}</dd>\n</dl>\n",
      escaped(report.input.experiment.at("seed").get<std::string>()), escaped(report.input.sha256),
      base::to_hex(report.digest), escaped(system.build.version), escaped(system.build.revision),
      escaped(system.build.compiler), escaped(system.build.flags), escaped(system.machine), escaped(system.start),
      significant(system.duration_s, 3), counted(system.threads, "thread"));
}

}  // namespace rocking::analysis
