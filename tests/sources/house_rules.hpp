#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

/// The rules that house_test.cpp applies to the tree.
namespace rocking::house {

namespace fs = std::filesystem;

using Offences = std::vector<std::string>;

/// The rooms that a room may include, besides itself. No arrow is inherited. The build gives a room only the headers of
/// the rooms to which it links, so that an include against the arrows does not compile either.
inline const std::map<std::string, std::set<std::string>> allowed_uses = {
    {"base", {}},
    {"random", {"base"}},
    {"stats", {"base"}},
    {"dynamics", {"base"}},
    {"integrate", {"base"}},
    {"lanes", {"base", "dynamics", "integrate"}},
    {"section", {"base"}},
    {"scene", {"base", "random", "dynamics", "section", "text", "fields"}},
    {"realisation", {"base", "random", "dynamics", "integrate", "lanes", "section", "scene"}},
    {"store", {"base", "random", "dynamics", "section", "scene", "realisation"}},
    {"ensemble", {"base", "stats", "dynamics", "lanes", "section", "scene", "realisation", "store"}},
    {"text", {"base", "stats"}},  // its intervals
    {"look", {"base", "stats", "text"}},
    {"fields", {"base", "text"}},
    {"input", {"base", "dynamics", "section", "text", "fields", "scene"}},
    {"output",
     {"base", "stats", "dynamics", "section", "text", "look", "fields", "scene", "input", "realisation", "store",
      "ensemble", "plan"}},
    {"plan", {"base", "random", "dynamics", "lanes", "section", "scene", "realisation", "store", "ensemble"}},
    {"figures", {"base", "stats", "dynamics", "section", "text", "scene", "input", "realisation", "output"}},
    {"api",
     {"base", "stats", "section", "scene", "realisation", "store", "ensemble", "plan", "text", "fields", "input",
      "output"}},
    {"study", {"base", "scene", "text", "look", "fields", "output", "figures", "api"}},
};

/// The core: a study may use all of it.
inline const std::set<std::string> core = [] {
  std::set<std::string> rooms;
  for (const auto& [room, uses] : allowed_uses) rooms.insert(room);
  return rooms;
}();

/// The other studies that a study uses, with the reason.
inline const std::map<std::string, std::map<std::string, std::string>> studies_used = {
    {"bifurcation", {{"orbits", "branches are drawn over diagrams of the same parameter"}}},
    {"curves", {{"rare", "probabilities below the levels of a run"}}},
    {"incremental", {{"curves", "the stripes of a run"}}},
    {"fragility",
     {{"curves", "curves and rates, on which sheet, survival, exports and surface stand"},
      {"incremental", "--ida adds it"}}},
};

/// Rooms whose code affects the bits of the result of a realisation.
inline const std::set<std::string> portable_rooms = {"random",  "dynamics", "integrate",  "lanes",
                                                     "section", "scene",    "realisation"};

inline Offences matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  Offences found;
  for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match) {
    found.push_back(match->str());
  }
  return found;
}

/// The text without comments after `//`. A `//` within a string literal also hides the rest of that line.
inline std::string without_comments(const std::string& text) {
  std::istringstream lines(text);
  std::string code;
  for (std::string line; std::getline(lines, line);) code += line.substr(0, line.find("//")) + '\n';
  return code;
}

/// Whether a room, or a study's folder `studies/NAME`, may include headers of another one. The list of the studies alone,
/// in studies/, knows them all.
inline bool may_use(const std::string& room, const std::string& used) {
  const std::string folder = "studies/";
  if (room == "studies") return core.contains(used) || used.starts_with(folder);
  if (!room.starts_with(folder)) return allowed_uses.at(room).contains(used);
  if (!used.starts_with(folder)) return core.contains(used);
  const auto uses = studies_used.find(room.substr(folder.size()));
  return uses != studies_used.end() && uses->second.contains(used.substr(folder.size()));
}

/// Rooms that a source of `room` includes without permission.
inline Offences forbidden_uses(const std::string& room, const std::string& source) {
  static const std::regex include(R"(#\s*include\s*["<]rocking/(studies/\w+(?=/)|\w+)/)");
  Offences found;
  for (std::sregex_iterator match(source.begin(), source.end(), include), end; match != end; ++match) {
    const std::string used = match->str(1);
    if (used != room && !may_use(room, used)) found.push_back(room + " -> " + used);
  }
  return found;
}

/// Includes of a source of analysis/ that are not allowed: it uses results, in files and stores, but nothing that
/// computes them.
inline Offences forbidden_in_analysis(const std::string& source) {
  static const std::regex include(R"(#\s*include\s*["<](rocking/[\w/]+\.hpp|nlohmann/[^">]*))");
  static const std::regex allowed(
      R"(rocking/(base|stats|section|text|look|input|output|figures)/.*|rocking/store/(store|summary)\.hpp|rocking/ensemble/mode_family\.hpp)");
  Offences found;
  for (std::sregex_iterator match(source.begin(), source.end(), include), end; match != end; ++match) {
    if (!std::regex_match(match->str(1), allowed)) found.push_back(match->str(1));
  }
  return found;
}

/// Includes of the folder of a study. Who treats studies as values names none.
inline Offences named_studies(const std::string& source) {
  return matches(source, R"(#\s*include\s*["<]rocking/studies/\w+/[^">]*)");
}

/// Includes of the library that are not its public headers.
inline Offences private_includes(const std::string& source) {
  return matches(source, R"(#\s*include\s*["<]rocking/(?!(rocking|pages)\.hpp)[^">]*)");
}

/// Includes of the library that are not among its open headers.
inline Offences closed_includes(const std::string& source, const std::set<std::string>& open) {
  static const std::regex include("#include \"(rocking/[^\"]+)\"");
  Offences found;
  for (std::sregex_iterator match(source.begin(), source.end(), include), end; match != end; ++match) {
    if (!open.contains(match->str(1))) found.push_back(match->str(1));
  }
  return found;
}

/// The JSON library is included in one room only.
inline Offences stray_json(const std::string& room, const std::string& source) {
  return room == "text" ? Offences{} : matches(source, R"(#\s*include\s*["<]nlohmann/[^">]*)");
}

/// Calls of statistical functions. A writer formats fields of a result. The two functions that are allowed summarise a
/// check of a sampler.
inline Offences statistics_in_a_writer(const std::string& source) {
  return matches(without_comments(source), R"(\bstats::(?!is_refuted\b|smallest_p_value\b)[a-z_]+\s*\()");
}

/// What no library function may do: print, end the program, read the clock, the environment or an entropy source, draw
/// from a distribution whose bits the standard leaves open.
inline Offences outside_world(const std::string& source) {
  return matches(
      without_comments(source),
      R"(\bstd::(cout|cerr|clog|cin)\b|\b(v?f?printf|puts|fputs|putchar|perror)\s*\(|\bfmt::print\b)"
      R"(|\b(secure_)?getenv\b|\b(_exit|exit|quick_exit|abort|terminate)\s*\()"
      R"(|\b(system|steady|high_resolution|utc)_clock\b|\bclock_gettime\b|\btime\s*\(\s*(nullptr|NULL|0)\s*\))"
      R"(|\brandom_device\b|\bstd::\w+_distribution\b|\bs?rand\s*\()");
}

/// Calls of C library functions whose last bit differs between machines. sqrt, fma, abs, floor and the like are exact.
inline Offences unportable_functions(const std::string& source) {
  return matches(without_comments(source),
                 R"((\bstd::|(^|[^\w.:>~]))(a?(sin|cos|tan)h?|atan2|sincos|exp2?|expm1|log(2|10|1p)?|l?gamma|erfc?|)"
                 R"(pow|hypot|cbrt|fmod|remainder)[fl]?\s*\()");
}

/// Loops over a part of what a call returns, `for (x : f()["key"])`: what the call returned may be gone by then. In C++23 it
/// is not.
inline Offences loops_over_parts(const std::string& source) {
  const std::string code = without_comments(source);
  const std::string loop = "for (";
  Offences found;
  for (std::size_t start = code.find(loop); start != std::string::npos; start = code.find(loop, start + 1)) {
    std::size_t end = start + loop.size();
    for (int depth = 1; depth > 0 && end < code.size(); ++end)
      depth += code[end] == '(' ? 1 : code[end] == ')' ? -1 : 0;
    const std::string head = code.substr(start, end - start);
    const std::size_t colon = head.find(" : ");
    if (colon == std::string::npos || head.find(';') != std::string::npos || head[colon + 3] == '{') continue;
    if (!matches(head.substr(colon), R"(\)(\[|\.at\())").empty()) found.push_back(head);
  }
  return found;
}

/// A clone of the project is complete: no text may refer to a folder beside it.
inline Offences neighbours(const std::string& text) { return matches(text, R"(\.\./shared\b)"); }

/// Links of a document to files that do not exist. Links to the web and within the page are not checked.
inline Offences dead_links(const fs::path& folder, const std::string& document) {
  static const std::regex link(R"(\]\(([^)#:\s]+)\))");
  Offences found;
  for (std::sregex_iterator match(document.begin(), document.end(), link), end; match != end; ++match) {
    if (!fs::exists(folder / match->str(1))) found.push_back(match->str(1));
  }
  return found;
}

/// Files to which a document links, in its order, without their anchors. Links to the web are left out.
inline std::vector<std::string> linked_files(const std::string& document) {
  static const std::regex link(R"(\]\(([^)#:\s]+)(#[^)]*)?\))");
  std::vector<std::string> found;
  for (std::sregex_iterator match(document.begin(), document.end(), link), end; match != end; ++match) {
    found.push_back(match->str(1));
  }
  return found;
}

inline std::size_t words_of(const std::string& text) {
  std::istringstream words(text);
  std::size_t count = 0;
  for (std::string word; words >> word;) ++count;
  return count;
}

/// Lines with text that people wrote in a document: none of what scripts write or the program prints, which are the reports
/// but for the prose of their evidence, the tables of keys and of flags, and what the commands of a tutorial print. `path` is
/// relative to the root of the tree.
inline std::size_t lines_by_hand(const std::string& path, const std::string& document) {
  const bool is_evidence = path.starts_with("reports/evidence/");
  if (path.starts_with("reports/") && !is_evidence) return 0;
  if (path == "lib/docs/reference/keys.md" || path == "reports/evidence/published.md") return 0;
  const bool has_printed_tables = is_evidence || path == "lib/docs/formats.md" || path == "lib/docs/commands.md";
  const bool has_output = path.starts_with("lib/docs/tutorials/") || path == "lib/docs/loading.md";
  std::istringstream lines(document);
  std::size_t count = 0;
  bool is_output = false;  // tests/tutorials/follow writes it
  for (std::string line; std::getline(lines, line);) {
    if (has_output && line.starts_with("```")) is_output = line == "```text";
    const bool is_printed = (is_output && line != "```text") || (has_printed_tables && line.starts_with('|'));
    if (!line.empty() && !is_printed) ++count;
  }
  return count;
}

/// Headers of the library that `header` includes, directly or not, itself among them: paths after lib/.
inline std::set<std::string> included_by(const std::string& header) {
  static const std::regex include("#include \"(rocking/[^\"]+)\"");
  std::set<std::string> found;
  std::vector<std::string> waiting{header};
  while (!waiting.empty()) {
    const std::string next = waiting.back();
    waiting.pop_back();
    if (!found.insert(next).second) continue;
    std::ifstream stream(fs::path(ROCKING_SOURCE_DIR) / "lib" / next);
    EXPECT_TRUE(stream) << next;
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match) {
      waiting.push_back(match->str(1));
    }
  }
  return found;
}

/// Rooms that no public header may show: they compute, read or write.
inline const std::set<std::string> private_rooms = {"random", "integrate", "lanes",  "text",    "look",
                                                    "fields", "input",     "output", "figures", "study"};

inline Offences private_headers(const std::set<std::string>& headers) {
  Offences found;
  for (const std::string& header : headers) {
    const std::string room = header.substr(8, header.find('/', 8) - 8);
    if (private_rooms.contains(room)) found.push_back(header);
  }
  return found;
}

}  // namespace rocking::house
