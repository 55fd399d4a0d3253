// reports/evidence/hard-cases.md names tests as evidence. Each of them must exist, and each test of tests/hard_cases must be
// named.

#include <filesystem>
#include <fstream>
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

using Names = std::set<std::string>;

std::string text_of(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// `Suite.Name` of each test that a source defines, whatever its macro.
Names defined_tests(const std::string& source) {
  static const std::regex macro(R"((?:^|\n)(?:TYPED_)?TEST(?:_[FP])?\(\s*(\w+)\s*,\s*(\w+)\s*\))");
  Names names;
  for (std::sregex_iterator match(source.begin(), source.end(), macro), end; match != end; ++match) {
    names.insert(match->str(1) + "." + match->str(2));
  }
  return names;
}

/// Texts of a document between backquotes of the form `Suite.Name`.
Names named_tests(const std::string& document) {
  static const std::regex name(R"(`([A-Z]\w*\.[A-Z]\w*)`)");
  Names names;
  for (std::sregex_iterator match(document.begin(), document.end(), name), end; match != end; ++match) {
    names.insert(match->str(1));
  }
  return names;
}

/// Rows of tables with an empty cell, or whose last cell names no test. The header of a table is the line above its
/// rule.
std::vector<std::string> rows_without_evidence(const std::string& document) {
  static const std::regex full(R"(\|( [^|]*[^| ] \|)+ [^|]*`[A-Z]\w*\.[A-Z]\w*`[^|]*\|)");
  std::vector<std::string> found;
  std::istringstream lines(document);
  bool is_in_body = false;
  for (std::string line; std::getline(lines, line);) {
    if (is_in_body && line.starts_with("|") && !std::regex_match(line, full)) found.push_back(line);
    is_in_body = line.starts_with("| ---") || (is_in_body && line.starts_with("|"));
  }
  return found;
}

/// Tests below tests/`folder`.
Names tests_of(const std::string& folder) {
  Names names;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(ROCKING_SOURCE_DIR) / "tests" / folder)) {
    if (entry.path().extension() == ".cpp") names.merge(defined_tests(text_of(entry.path())));
  }
  return names;
}

Names difference(const Names& all, const Names& without) {
  Names rest;
  for (const std::string& name : all) {
    if (!without.contains(name)) rest.insert(name);
  }
  return rest;
}

std::string hard_cases() { return text_of(fs::path(ROCKING_SOURCE_DIR) / "reports/evidence/hard-cases.md"); }

TEST(TableOfHardCases, NamesOnlyTestsThatExist) {
  const Names named = named_tests(hard_cases());
  EXPECT_FALSE(named.empty());
  EXPECT_THAT(difference(named, tests_of(".")), IsEmpty());
}

TEST(TableOfHardCases, NamesEveryTestWrittenForIt) {
  EXPECT_THAT(difference(tests_of("hard_cases"), named_tests(hard_cases())), IsEmpty());
}

TEST(TableOfHardCases, HasEvidenceInEveryRow) { EXPECT_THAT(rows_without_evidence(hard_cases()), IsEmpty()); }

TEST(RulesOfTheTable, FindTestsOfEveryMacro) {
  EXPECT_THAT(
      defined_tests("TEST(A, B) {\nTEST_P(C,\n       D) {\nTEST_F(E, F) {\nTYPED_TEST(G, H) {\n// TEST(I, J)\n"),
      ElementsAre("A.B", "C.D", "E.F", "G.H"));
  EXPECT_THAT(difference(named_tests("`A.B`, `Grazing.Touch`; `base.hpp`, A.C"), {"A.B"}),
              ElementsAre("Grazing.Touch"));
}

TEST(RulesOfTheTable, FindARowWithoutEvidence) {
  const std::string good = "| case | what | test |\n| --- | --- | --- |\n| a | b | `A.B`, `C.D` |\n";
  EXPECT_THAT(rows_without_evidence(good), IsEmpty());
  EXPECT_THAT(rows_without_evidence(good + "| a | | `A.B` |\n\n| a |"), ElementsAre("| a | | `A.B` |"));
  EXPECT_THAT(rows_without_evidence(good + "| a | b | none |\n"), ElementsAre("| a | b | none |"));
  EXPECT_THAT(rows_without_evidence(good + "| `A.B` |\n"), ElementsAre("| `A.B` |"));
}

}  // namespace
