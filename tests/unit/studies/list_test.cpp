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

TEST(Answer, RefusesWhatACommandLineRefusesByTheNamesOfItsFlags) {
  EXPECT_THAT(fault("fragility", R"({"survived": 100})"), HasSubstr("survived = 100: needs hazard"));
  EXPECT_THAT(fault("fragility", R"({"joint_hazard": "h.csv"})"), HasSubstr("joint_hazard = \"h.csv\": needs surface"));
  EXPECT_THAT(fault("cost", R"({"sample": 3, "max_time": 1})"), HasSubstr("sample = 3: excludes max_time"));
  EXPECT_THAT(fault("cost", R"({"sample": 3, "max_time": 60})"), Not(HasSubstr("excludes"))) << "the default";
  EXPECT_THAT(fault("motion", R"({"files": ["a"], "block": [1]})"), HasSubstr("block = [1]: must be 2 numbers"));
  EXPECT_THAT(fault("infer", "{}"), HasSubstr("tests: is missing"));
}

TEST(Answer, IsAboutAsManyRunsAsItsStudy) {
  EXPECT_THAT(fault("fragility", "{}"), HasSubstr("source = 0 runs: must be at least one run"));
  EXPECT_THAT(fault("compare", "{}"), HasSubstr("source = 0 runs: must be two runs"));
  const StudySubject about{.earlier = "{}"};
  EXPECT_THROW(static_cast<void>(answer("check_normal", "{}", about, {})), base::InputError);
}

TEST(Answer, IsOneSentence) {
  EXPECT_EQ(answer("check_normal", R"({"n": 200, "seed": "7"})", {}, {}).sentence,
            "200 numbers from N(0.4, 0.03^2), sampler box-muller, seed 0x7: not refuted.");
  const std::string file = ROCKING_SOURCE_DIR "/experiments/recorded/pulses.txt";
  const std::string asked = R"({"files": [")" + file + R"("], "time_step": 0.01, "block": [1, 4]})";
  EXPECT_EQ(answer("motion", asked, {}, {}).sentence.find("The ground motion " + file + " has a PGA of "), 0U);
}

TEST(Answer, HasTheNumbersOfTheTypedCall) {
  SamplerQuestion question{.n = 200, .seed = 7};
  const auto mean_of = [](std::string_view asked) {
    return Json::parse(answer("check_normal", asked, {}, {}).document)["mean"]["value"].get<double>();
  };
  EXPECT_EQ(mean_of(R"({"n": 200, "seed": "7"})"), check_normal(question).mean.moment.value);
  question.distribution = FluctuationLaw::uniform;
  EXPECT_EQ(mean_of(R"({"n": 200, "seed": "7", "law": "uniform"})"), check_normal(question).mean.moment.value);
}

}  // namespace
}  // namespace rocking
