// Rules of the project that can be checked in the sources: which room may use which, what a library must not do, which
// functions would make results depend on the C library of a machine. Each rule is a pure function from a text to its
// offences, and is tested with invented offences before it is applied to the tree.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using Offences = std::vector<std::string>;

/// The rooms that a room may include, besides itself. No arrow is inherited. The build gives a room only the headers of
/// the rooms to which it links, so that an include against the arrows does not compile either.
const std::map<std::string, std::set<std::string>> allowed_uses = {
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
const std::set<std::string> core = [] {
  std::set<std::string> rooms;
  for (const auto& [room, uses] : allowed_uses) rooms.insert(room);
  return rooms;
}();

/// The other studies that a study uses, with the reason.
const std::map<std::string, std::map<std::string, std::string>> studies_used = {
    {"bifurcation", {{"orbits", "branches are drawn over diagrams of the same parameter"}}},
    {"fragility", {{"rare", "probabilities below the levels of a run"}}},
};

/// Rooms whose code affects the bits of the result of a realisation.
const std::set<std::string> portable_rooms = {"random",  "dynamics", "integrate",  "lanes",
                                              "section", "scene",    "realisation"};

Offences matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  Offences found;
  for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match) {
    found.push_back(match->str());
  }
  return found;
}

/// The text without comments after `//`. A `//` within a string literal also hides the rest of that line.
std::string without_comments(const std::string& text) {
  std::istringstream lines(text);
  std::string code;
  for (std::string line; std::getline(lines, line);) code += line.substr(0, line.find("//")) + '\n';
  return code;
}

/// Whether a room, or a study's folder `studies/NAME`, may include headers of another one. The list of the studies alone,
/// in studies/, knows them all.
bool may_use(const std::string& room, const std::string& used) {
  const std::string folder = "studies/";
  if (room == "studies") return core.contains(used) || used.starts_with(folder);
  if (!room.starts_with(folder)) return allowed_uses.at(room).contains(used);
  if (!used.starts_with(folder)) return core.contains(used);
  const auto uses = studies_used.find(room.substr(folder.size()));
  return uses != studies_used.end() && uses->second.contains(used.substr(folder.size()));
}

/// Rooms that a source of `room` includes without permission.
Offences forbidden_uses(const std::string& room, const std::string& source) {
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
Offences forbidden_in_analysis(const std::string& source) {
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
Offences named_studies(const std::string& source) {
  return matches(source, R"(#\s*include\s*["<]rocking/studies/\w+/[^">]*)");
}

/// Includes of the library that are not its public headers.
Offences private_includes(const std::string& source) {
  return matches(source, R"(#\s*include\s*["<]rocking/(?!(rocking|pages)\.hpp)[^">]*)");
}

/// Includes of the library that are not among its open headers.
Offences closed_includes(const std::string& source, const std::set<std::string>& open) {
  static const std::regex include("#include \"(rocking/[^\"]+)\"");
  Offences found;
  for (std::sregex_iterator match(source.begin(), source.end(), include), end; match != end; ++match) {
    if (!open.contains(match->str(1))) found.push_back(match->str(1));
  }
  return found;
}

/// The JSON library is included in one room only.
Offences stray_json(const std::string& room, const std::string& source) {
  return room == "text" ? Offences{} : matches(source, R"(#\s*include\s*["<]nlohmann/[^">]*)");
}

/// Calls of statistical functions. A writer formats fields of a result. The two functions that are allowed summarise a
/// check of a sampler.
Offences statistics_in_a_writer(const std::string& source) {
  return matches(without_comments(source), R"(\bstats::(?!is_refuted\b|smallest_p_value\b)[a-z_]+\s*\()");
}

/// What no library function may do: print, end the program, read the clock, the environment or an entropy source, draw
/// from a distribution whose bits the standard leaves open.
Offences outside_world(const std::string& source) {
  return matches(
      without_comments(source),
      R"(\bstd::(cout|cerr|clog|cin)\b|\b(v?f?printf|puts|fputs|putchar|perror)\s*\(|\bfmt::print\b)"
      R"(|\b(secure_)?getenv\b|\b(_exit|exit|quick_exit|abort|terminate)\s*\()"
      R"(|\b(system|steady|high_resolution|utc)_clock\b|\bclock_gettime\b|\btime\s*\(\s*(nullptr|NULL|0)\s*\))"
      R"(|\brandom_device\b|\bstd::\w+_distribution\b|\bs?rand\s*\()");
}

/// Calls of C library functions whose last bit differs between machines. sqrt, fma, abs, floor and the like are exact.
Offences unportable_functions(const std::string& source) {
  return matches(without_comments(source),
                 R"((\bstd::|(^|[^\w.:>~]))(a?(sin|cos|tan)h?|atan2|sincos|exp2?|expm1|log(2|10|1p)?|l?gamma|erfc?|)"
                 R"(pow|hypot|cbrt|fmod|remainder)[fl]?\s*\()");
}

/// A clone of the project is complete: no text may refer to a folder beside it.
Offences neighbours(const std::string& text) { return matches(text, R"(\.\./shared\b)"); }

/// Links of a document to files that do not exist. Links to the web and within the page are not checked.
Offences dead_links(const fs::path& folder, const std::string& document) {
  static const std::regex link(R"(\]\(([^)#:\s]+)\))");
  Offences found;
  for (std::sregex_iterator match(document.begin(), document.end(), link), end; match != end; ++match) {
    if (!fs::exists(folder / match->str(1))) found.push_back(match->str(1));
  }
  return found;
}

/// Headers of the library that `header` includes, directly or not, itself among them: paths after lib/.
std::set<std::string> included_by(const std::string& header) {
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
const std::set<std::string> private_rooms = {"random", "integrate", "lanes",  "text",    "look",
                                             "fields", "input",     "output", "figures", "study"};

Offences private_headers(const std::set<std::string>& headers) {
  Offences found;
  for (const std::string& header : headers) {
    const std::string room = header.substr(8, header.find('/', 8) - 8);
    if (private_rooms.contains(room)) found.push_back(header);
  }
  return found;
}

struct File {
  fs::path path;
  std::string room;  ///< of the library; empty elsewhere
  std::string text;
};

std::string text_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// The room of a file in lib/rocking; `studies/NAME` of one in the folder of a study. Empty: beside the rooms.
std::string room_of(const fs::path& file) {
  const std::string folder = file.parent_path().generic_string();
  return folder.substr(0, folder.starts_with("studies/") ? folder.find('/', 8) : folder.find('/'));
}

/// The project's own files, without those of version control and of builds and runs.
std::vector<File> files_of_tree() {
  const fs::path root = ROCKING_SOURCE_DIR;
  const fs::path library = root / "lib/rocking";
  const std::set<fs::path> skipped = {root / ".git", root / "build", root / "reports/local"};
  std::vector<File> files;
  for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator(); ++entry) {
    if (skipped.contains(entry->path())) {
      entry.disable_recursion_pending();
    } else if (entry->is_regular_file()) {
      const fs::path below = entry->path().lexically_relative(library);
      const bool inside = *below.begin() != "..";
      files.push_back({entry->path(), inside ? room_of(below) : "", text_of(entry->path())});
    }
  }
  return files;
}

std::vector<File> sources_of_library() {
  std::vector<File> sources;
  for (File& file : files_of_tree()) {
    const std::string extension = file.path.extension().string();
    if (!file.room.empty() && (extension == ".hpp" || extension == ".cpp" || extension == ".in")) {
      sources.push_back(std::move(file));
    }
  }
  return sources;
}

TEST(TheHouse, HasOnlyTheRoomsOfTheTable) {
  std::set<std::string> rooms;
  for (const File& file : sources_of_library()) {
    if (!file.room.starts_with("studies/")) rooms.insert(file.room);
  }
  std::set<std::string> table{core};
  table.insert("studies");
  EXPECT_EQ(rooms, table);
}

TEST(TheHouse, HasArrowsOneWayOnly) {
  for (const File& file : sources_of_library()) {
    EXPECT_THAT(forbidden_uses(file.room, file.text), IsEmpty()) << file.path;
  }
}

TEST(TheHouse, DrawsWithoutSimulating) {
  std::size_t sources = 0;
  for (const File& file : files_of_tree()) {
    if (*file.path.lexically_relative(ROCKING_SOURCE_DIR).begin() != "analysis") continue;
    ++sources;
    EXPECT_THAT(forbidden_in_analysis(file.text), IsEmpty()) << file.path;
    EXPECT_THAT(matches(without_comments(file.text), "\\brealise\\b|trajectory_of"), IsEmpty()) << file.path;
  }
  EXPECT_GT(sources, 10U);
}

TEST(TheHouse, NamesNoStudyInPagesAndProgram) {
  std::size_t sources = 0;
  for (const File& file : files_of_tree()) {
    const std::string path = file.path.lexically_relative(ROCKING_SOURCE_DIR).generic_string();
    if (!path.starts_with("lib/pages/") && !path.starts_with("experiments/rocking/")) continue;
    ++sources;
    EXPECT_THAT(named_studies(file.text), IsEmpty()) << file.path;
  }
  EXPECT_GT(sources, 40U);
}

TEST(TheHouse, ShowsAtMostFiftyHeadersThatComputeNothing) {
  const std::set<std::string> headers = included_by("rocking/rocking.hpp");
  EXPECT_GT(headers.size(), 20U);
  EXPECT_LT(headers.size(), 50U);  // pages.hpp is the other one
  EXPECT_THAT(private_headers(headers), IsEmpty());
}

TEST(TheHouse, LetsPythonSeeWhatEveryUserSees) {
  std::size_t sources = 0;
  for (const File& file : files_of_tree()) {
    if (file.path.parent_path() != fs::path(ROCKING_SOURCE_DIR) / "lib/python") continue;
    if (file.path.extension() == ".cpp" || file.path.extension() == ".hpp") ++sources;
    EXPECT_THAT(private_includes(file.text), IsEmpty()) << file.path;
  }
  EXPECT_GT(sources, 4U);
}

TEST(TheHouse, LetsCommandsParseCallAndPrint) {
  std::set<std::string> open = included_by("rocking/rocking.hpp");
  open.insert({"rocking/pages.hpp", "rocking/studies/studies.hpp"});
  std::size_t commands = 0;
  for (const File& file : files_of_tree()) {
    const std::string name = file.path.filename().string();
    if (!name.ends_with("_command.cpp")) continue;
    ++commands;
    EXPECT_THAT(closed_includes(file.text, open), IsEmpty()) << file.path;
    EXPECT_LE(std::ranges::count(file.text, '\n'), 80) << file.path;
  }
  EXPECT_GT(commands, 10U);
}

TEST(TheHouse, ComputesNoStatisticsInAWriter) {
  for (const File& file : files_of_tree()) {
    const bool draws = *file.path.lexically_relative(ROCKING_SOURCE_DIR).begin() == "analysis";
    if (draws || file.room == "output") {
      EXPECT_THAT(statistics_in_a_writer(file.text), IsEmpty()) << file.path;
    }
  }
}

TEST(TheHouse, IncludesTheJsonLibraryInOneRoom) {
  for (const File& file : sources_of_library()) EXPECT_THAT(stray_json(file.room, file.text), IsEmpty()) << file.path;
}

TEST(TheHouse, NeverPrintsExitsNorReadsClockOrEnvironment) {
  for (const File& file : sources_of_library()) EXPECT_THAT(outside_world(file.text), IsEmpty()) << file.path;
}

TEST(TheHouse, LetsNoMachinesLibraryReachARealisationResult) {
  for (const File& file : sources_of_library()) {
    if (portable_rooms.contains(file.room)) {
      EXPECT_THAT(unportable_functions(file.text), IsEmpty()) << file.path;
    }
  }
}

TEST(TheHouse, StandsAlone) {
  const std::vector<File> files = files_of_tree();
  EXPECT_GT(files.size(), 50U);
  for (const File& file : files) EXPECT_THAT(neighbours(file.text), IsEmpty()) << file.path;
}

TEST(TheHouse, LeadsItsReadersSomewhere) {
  for (const File& file : files_of_tree()) {
    if (file.path.extension() == ".md") {
      EXPECT_THAT(dead_links(file.path.parent_path(), file.text), IsEmpty()) << file.path;
    }
  }
}

TEST(TheHouseRules, FindAnArrowThatGoesUpOrSideways) {
  EXPECT_THAT(forbidden_uses("dynamics", "#include \"rocking/integrate/step.hpp\"\n"),
              ElementsAre("dynamics -> integrate"));
  EXPECT_THAT(forbidden_uses("base", "# include <rocking/text/json.hpp>\n"), ElementsAre("base -> text"));
  EXPECT_THAT(forbidden_uses("output", "#include \"rocking/random/normal.hpp\""), ElementsAre("output -> random"));
  EXPECT_THAT(forbidden_uses("output", "#include \"rocking/studies/rare/question.hpp\""),
              ElementsAre("output -> studies/rare"));
  EXPECT_THAT(forbidden_uses("studies/rare",
                             "#include \"rocking/studies/orbits/question.hpp\"\n"
                             "#include \"rocking/studies/rare/rare.hpp\"\n"
                             "#include \"rocking/stats/interval.hpp\"\n"),
              ElementsAre("studies/rare -> studies/orbits"));
  EXPECT_THAT(forbidden_uses("section", "#include \"rocking/base/lane.hpp\"\n#include \"rocking/section/a.hpp\"\n"),
              IsEmpty());
}

TEST(TheHouseRules, FindTheNameOfAStudy) {
  EXPECT_THAT(
      named_studies("#include \"rocking/studies/rare/question.hpp\"\n#include \"rocking/studies/studies.hpp\"\n"),
      ElementsAre("#include \"rocking/studies/rare/question.hpp"));
}

TEST(TheHouseRules, FindAPrivateHeader) {
  EXPECT_THAT(private_headers({"rocking/api/run.hpp", "rocking/integrate/step.hpp", "rocking/text/json.hpp"}),
              ElementsAre("rocking/integrate/step.hpp", "rocking/text/json.hpp"));
}

TEST(TheHouseRules, FindAnIncludeThatIsNotForEveryUser) {
  EXPECT_THAT(private_includes("#include \"rocking/rocking.hpp\"\n#include <rocking/pages.hpp>\n"), IsEmpty());
  EXPECT_THAT(private_includes("#include \"rocking/store/store.hpp\"\n"),
              ElementsAre("#include \"rocking/store/store.hpp"));
}

TEST(TheHouseRules, FindAnIncludeThatIsNotOpen) {
  EXPECT_THAT(
      closed_includes("#include \"rocking/api/run.hpp\"\n#include \"rocking/store/store.hpp\"\n#include \"a.hpp\"\n",
                      {"rocking/api/run.hpp"}),
      ElementsAre("rocking/store/store.hpp"));
}

TEST(TheHouseRules, FindASimulatingFigure) {
  EXPECT_THAT(
      forbidden_in_analysis("#include \"rocking/realisation/realisation_result.hpp\"\n#include <nlohmann/json.hpp>\n"),
      SizeIs(2));
  EXPECT_THAT(forbidden_in_analysis("#include \"rocking/store/store.hpp\"\n#include \"analysis/a.hpp\"\n"), IsEmpty());
}

TEST(TheHouseRules, FindStatisticsInAWriter) {
  EXPECT_THAT(statistics_in_a_writer("p = stats::mcnemar(counts).p_value;\nauto i = stats::wilson (counts, 0.95);"),
              SizeIs(2));
  EXPECT_THAT(statistics_in_a_writer("void f(const stats::Interval& interval);  // stats::wilson(x)\n"
                                     "json[\"refuted\"] = stats::is_refuted(found);"),
              IsEmpty());
}

TEST(TheHouseRules, FindTheJsonLibraryOutsideItsRoom) {
  EXPECT_THAT(stray_json("ensemble", "#include <nlohmann/json.hpp>\n"), SizeIs(1));
  EXPECT_THAT(stray_json("text", "#include <nlohmann/json.hpp>\n"), IsEmpty());
}

TEST(TheHouseRules, FindWhatALibraryMayNotDo) {
  for (const char* offence :
       {"std::cerr << 1;", "printf(\"%d\", 1);", "std::fprintf(stderr, x);", "std::getenv(\"HOME\");", "std::exit(1);",
        "std::chrono::steady_clock::now();", "std::time(nullptr);", "std::random_device source;",
        "std::normal_distribution<double> law;", "fmt::print(\"x\");"}) {
    EXPECT_THAT(outside_world(offence), SizeIs(1)) << offence;
  }
  EXPECT_THAT(outside_world("// as printf( does\nboost::math::normal_distribution<> law; std::snprintf(a, n, f);"),
              IsEmpty());
}

TEST(TheHouseRules, FindACallOfTheMachinesLibrary) {
  for (const char* offence :
       {"double y = std::sin(x);", "return atan2(y, x);", "x = -exp (2);", "std::logf(x)", "cos(x)"}) {
    EXPECT_THAT(unportable_functions(offence), SizeIs(1)) << offence;
  }
  EXPECT_THAT(
      unportable_functions("/// sin(phi)\nbase::sin_cos(x); std::sqrt(x); geometry.tan(x); log_event(x); asinine(x)"),
      IsEmpty());
}

TEST(TheHouseRules, FindAReferenceToANeighbour) {
  EXPECT_THAT(neighbours(std::string("see ..") + "/shared/MODEL.md"), SizeIs(1));
  EXPECT_THAT(neighbours("shared memory"), IsEmpty());
}

TEST(TheHouseRules, FindALinkToNowhere) {
  EXPECT_THAT(dead_links(ROCKING_SOURCE_DIR, "[a](README.md), [b](nowhere.md), [c](https://example.org), [d](#here)"),
              ElementsAre("nowhere.md"));
}

}  // namespace
