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
  for (const fs::path& file : files()) {
    const auto validated = rocking("validate '" + (experiments / file).string() + "' --json");
    EXPECT_EQ(validated.exit_code, 0) << file << validated.errors;
    fs::path report = published_reports / file;
    const auto published = rocking::Json::parse(text_of(report.replace_extension() / "report.json"));
    EXPECT_EQ(published["input"]["sha256"], rocking::Json::parse(validated.output)["sha256"]) << file;
  }
}

TEST_F(BeyondThePaper, IsWrittenUpByTheScriptFromThePublishedReports) {
  if (python_with_module().empty()) {
    GTEST_SKIP() << "skipped: the Python module is not built (Debian: python3-dev pybind11-dev python3-numpy)";
  }
  for (const char* script : {"write_report.py", "friction_scatter.py"}) {
    const auto checked =
        shell("exec " + python_with_module() + " -B '" + (experiments / script).string() + "' --check");
    EXPECT_EQ(checked.exit_code, 0) << checked.errors;
  }
}

TEST_F(BeyondThePaper, ComparesWithMeasuredRestitutionsByItsScript) {
  if (python_with_module().empty()) {
    GTEST_SKIP() << "skipped: the Python module is not built (Debian: python3-dev pybind11-dev python3-numpy)";
  }
  const fs::path script = ROCKING_SOURCE_DIR "/experiments/published_tests/free_rocking.py";
  const auto checked = shell("exec " + python_with_module() + " -B '" + script.string() + "' --check");
  EXPECT_EQ(checked.exit_code, 0) << checked.errors;
}

TEST_F(BeyondThePaper, PublishesFragilityAsTheFormatSays) {
  EXPECT_EQ(objections("fragility", text_of(published_reports / "fragility.json")), "");
}

}  // namespace
