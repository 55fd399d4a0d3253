// experiments/beyond_the_paper and reports/beyond_the_paper: the files are valid, and the report is the output of its
// script.

#include <gtest/gtest.h>

#include "cli/program.hpp"
#include "support/json_schema.hpp"

namespace {

namespace fs = std::filesystem;
using rocking::support::objections;

const fs::path experiments = ROCKING_SOURCE_DIR "/experiments/beyond_the_paper";
const fs::path published_reports = ROCKING_SOURCE_DIR "/reports/beyond_the_paper";

class BeyondThePaper : public rocking::support::ProgramTest {
 protected:
  static std::string text_of(const fs::path& path) {
    std::ostringstream content;
    content << std::ifstream(path, std::ios::binary).rdbuf();
    return content.str();
  }

  /// Experiment files, relative to their folder.
  static std::vector<fs::path> files() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(experiments)) {
      if (entry.path().extension() == ".json") found.push_back(fs::relative(entry.path(), experiments));
    }
    return found;
  }
};

TEST_F(BeyondThePaper, AsksQuestionsThatAreValidAndPublishesTheAnswersToThem) {
  EXPECT_EQ(files().size(), 19U);
  if (shell("python3 -c 'import lzma'").exit_code != 0) GTEST_SKIP() << "skipped: no python3 (Debian: python3)";
  const auto unpacked = shell("xz=" + (published_reports / "runs.json.xz").string() +
                              "; python3 -c 'import lzma, sys; print(lzma.open(sys.argv[1], \"rt\").read())' \"$xz\"");
  ASSERT_EQ(unpacked.exit_code, 0) << unpacked.errors;
  const auto runs = rocking::Json::parse(unpacked.output);
  for (const fs::path& file : files()) {
    const auto validated = rocking("validate '" + (experiments / file).string() + "' --json");
    EXPECT_EQ(validated.exit_code, 0) << file << validated.errors;
    const std::string name = fs::path(file).replace_extension().string();
    const auto sha256 = rocking::Json::parse(validated.output)["sha256"];
    if (runs.contains(name)) {
      EXPECT_EQ(runs[name]["sha256"], sha256) << file;
      continue;
    }
    const auto published = rocking::Json::parse(text_of(published_reports / name / "report.json"));
    EXPECT_EQ(published["input"]["sha256"], sha256) << file;
  }
}

TEST_F(BeyondThePaper, SeesEffectsOfFivePercentagePointsWithAProbabilityOfNineTenths) {
  if (python_with_module().empty()) {
    GTEST_SKIP() << "skipped: the Python module is not built (Debian: python3-dev pybind11-dev python3-numpy)";
  }
  const auto outcome = shell("PYTHONPATH='" + experiments.string() + "' " + python_with_module() + R"( -B - <<'END'
from design import MOMENTS, Design
import json, lzma
runs = json.loads(lzma.open(")" +
                             published_reports.string() +
                             R"(/runs.json.xz", "rt").read())
for folder in ("five_per_cent", "one_per_cent"):
    for moment in MOMENTS:
        assert Design(runs, folder, moment).power(0.05) >= 0.9
END)");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
}

TEST_F(BeyondThePaper, IsWrittenUpByScriptsFromThePublishedResultsLikeOtherReports) {
  if (python_with_module().empty()) {
    GTEST_SKIP() << "skipped: the Python module is not built (Debian: python3-dev pybind11-dev python3-numpy)";
  }
  for (const char* script :
       {"beyond_the_paper/write_report.py", "beyond_the_paper/friction_scatter.py", "published_tests/free_rocking.py",
        "cemetery/coverage.py", "p58_bookcases/p58_bookcases.py", "bookcase_on_floors/bookcase_on_floors.py",
        "paper/write.py"}) {
    const auto checked =
        shell("exec " + python_with_module() + " -B '" ROCKING_SOURCE_DIR "/experiments/" + script + "' --check");
    EXPECT_EQ(checked.exit_code, 0) << checked.errors;
  }
}

TEST_F(BeyondThePaper, PublishesFragilityAsTheFormatSays) {
  EXPECT_EQ(objections("fragility", text_of(published_reports / "fragility.json")), "");
}

}  // namespace
