// experiments/jeong_yang_2012 and reports/jeong_yang_2012: the published text follows from the published results, and
// these from the files.

#include <algorithm>

#include <gtest/gtest.h>

#include "cli/program.hpp"

namespace {

namespace fs = std::filesystem;

const std::string questions = ROCKING_SOURCE_DIR "/experiments/jeong_yang_2012";
const std::string published = ROCKING_SOURCE_DIR "/reports/jeong_yang_2012";

class JeongYang : public rocking::support::ProgramTest {
 protected:
  void SetUp() override {
    if (shell("python3 -c 'import lzma'").exit_code != 0) GTEST_SKIP() << "skipped: no python3 (Debian: python3)";
  }

  rocking::support::Outcome python(const std::string& script, const std::string& interpreter = "python3") const {
    return shell("PYTHONPATH='" + questions + "' " + interpreter + " -B - <<'END'\n" + script + "\nEND");
  }
};

const char* const no_module =
    "skipped: the Python module is not built (Debian: python3-dev pybind11-dev python3-numpy)";

TEST_F(JeongYang, PublishedWordsAreWhatTheScriptMakesOfThePublishedResults) {
  if (python_with_module().empty()) GTEST_SKIP() << no_module;
  const auto checked =
      shell("exec " + python_with_module() + " -B '" + questions + "/write.py' '" + published + "' --check");
  EXPECT_EQ(checked.exit_code, 0) << checked.errors;
}

// Without -S an interpreter may find numpy, which the module needs.
TEST_F(JeongYang, ScriptsSayHowToBuildTheModuleThatTheyLack) {
  const auto outcome =
      shell("exec env -u PYTHONPATH python3 -S -B '" + questions + "/write.py' '" + published + "' --check");
  EXPECT_EQ(outcome.exit_code, 1);
  for (const char* words : {"needs the Python module", "--target rocking_python", "build/release/python/python3"}) {
    EXPECT_NE(outcome.errors.find(words), std::string::npos) << outcome.errors;
  }
  EXPECT_EQ(outcome.errors.find("Traceback"), std::string::npos) << outcome.errors;
}

TEST_F(JeongYang, ExperimentFilesAreAllValid) {
  int files = 0;
  for (const auto& entry : fs::directory_iterator(questions)) {
    if (entry.path().extension() != ".json") continue;
    ++files;
    const auto outcome = rocking("validate -q '" + entry.path().string() + "'");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  }
  EXPECT_GE(files, 15);
}

TEST_F(JeongYang, IntervalsOfTheScriptAreThoseOfTheProgram) {
  if (python_with_module().empty()) GTEST_SKIP() << no_module;
  const auto outcome = python(R"(
from intervals import clopper_pearson
from published import read
report = read(")" + published +
                                  R"(/any_start_fixed_friction.json.xz")
seen = {}
for condition in report["result"]["conditions"]:
    for mode, found in condition["probabilities"].items():
        seen[condition["counts"][mode], condition["realisations"]] = found["clopper_pearson"]
assert len(seen) > 20
for (k, n), expected in seen.items():
    assert all(abs(a - b) < 1e-9 for a, b in zip(clopper_pearson(k, n), expected)), (k, n)
)",
                              python_with_module());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
}

TEST_F(JeongYang, PublishedReportIsWhatANewRunGives) {
  const auto unpacked = python(
      "import lzma, os\nos.mkdir('run')\n"
      "open('run/report.json', 'wb').write(lzma.open('" +
      published + "/rest_no_sliding.json.xz').read())");
  ASSERT_EQ(unpacked.exit_code, 0) << unpacked.errors;
  const auto verified = rocking("verify run -q");
  EXPECT_EQ(verified.exit_code, 0) << verified.output << verified.errors;
}

TEST_F(JeongYang, RunsOfThePublishedReportsAreThoseOfTheFiles) {
  const auto outcome = python(R"(
import json, subprocess
from published import RUNS, read
for name in RUNS:
    text = subprocess.run([")" ROCKING_PROGRAM R"(", "validate", ")" +
                              questions + R"(/" + name + ".json", "--json"],
                          capture_output=True, check=True).stdout
    asked = json.loads(text)
    asked = asked.get("experiment", asked)
    assert asked == read(")" + published +
                              R"(/" + name + ".json.xz")["input"]["experiment"], name
)");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
}

}  // namespace
