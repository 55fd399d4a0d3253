// The list of the studies, and what follows from the constants in it.

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/rocking.hpp"
#include "rocking/studies/studies.hpp"

namespace rocking {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string text_of_file(const std::string& path) {
  std::ifstream stream(std::filesystem::path(ROCKING_SOURCE_DIR) / path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string fault(std::string_view study, std::string_view question) {
  try {
    static_cast<void>(answer(study, question, {}, {}));
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Studies, StandInTheFileFromWhichThePythonModuleIsMade) {
  EXPECT_TRUE(text_of_file("reports/schemas/studies.json") == studies_text())
      << "rocking schema studies > reports/schemas/studies.json";
}

TEST(Studies, HaveNamesDocumentsAndFlagsOfTheirOwn) {
  std::set<std::string> seen;
  for (const Study* study : studies()) {
    EXPECT_TRUE(seen.insert(std::string(study->name)).second) << study->name;
    EXPECT_TRUE(seen.insert(std::string(study->document.format())).second) << study->document.format();
    std::set<std::string> flags;
    std::set<std::string> keywords;
    for (const Field& field : study->question->fields()) {
      if (field.flag.names.empty()) continue;
      EXPECT_TRUE(flags.insert(std::string(field.flag.names)).second) << study->name << ' ' << field.flag.names;
      EXPECT_THAT(std::string(field.sentence), Not(testing::EndsWith("."))) << study->name << ' ' << field.key;
      const std::string keyword = keyword_of(field);
      EXPECT_TRUE(keyword.empty() || keywords.insert(keyword).second) << study->name << ' ' << keyword;
    }
  }
  EXPECT_GE(studies().size(), 9U);
}

TEST(Studies, CanGoOnOnlyIfTheyKeepSomething) {
  for (const Study* study : studies()) {
    EXPECT_EQ(study->kept.empty(), study->resume == nullptr) << study->name;
    EXPECT_TRUE(study->kept.empty() || !study->file.empty()) << study->name;
  }
}

TEST(Answer, RefusesKeywordsThatAreUnknownOrWrong) {
  EXPECT_THAT(fault("check_normal", R"({"sigmas": 1})"), HasSubstr("sigmas"));
  EXPECT_THAT(fault("check_normal", R"({"n": "many"})"), HasSubstr("n"));
  EXPECT_THAT(fault("check_normal", R"({"n": 3})"), HasSubstr("20"));
  EXPECT_THAT(fault("cost", R"({"seconds": 3.0})"), HasSubstr("is not a keyword"));
  EXPECT_THAT(fault("cost", R"({"max_time": -3.0})"), HasSubstr("max_time = -3"));
  EXPECT_THROW(static_cast<void>(answer("checks", "{}", {}, {})), std::invalid_argument);
}

TEST(Answer, IsTheDocumentOfTheTypedCall) {
  SamplerQuestion question{.n = 200, .seed = 7};
  EXPECT_EQ(answer("check_normal", R"({"n": 200, "seed": "7"})", {}, {}).document,
            check_normal_text(question, check_normal(question)));
  question.distribution = FluctuationLaw::uniform;
  EXPECT_EQ(answer("check_normal", R"({"n": 200, "seed": "7", "law": "uniform"})", {}, {}).document,
            check_normal_text(question, check_normal(question)));
}

}  // namespace
}  // namespace rocking
