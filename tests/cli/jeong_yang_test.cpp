// experiments/jeong_yang_2012 and reports/jeong_yang_2012: the published text follows from the published results, and
// these from the files.

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
  for (const auto& entry : fs::recursive_directory_iterator(questions)) {
    if (entry.path().extension() != ".json") continue;
    ++files;
    const auto outcome = rocking("validate -q '" + entry.path().string() + "'");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  }
  EXPECT_GE(files, 15);
}

TEST_F(JeongYang, EachClaimIsDecidedInEachCellOrTheReasonIsGiven) {
  if (python_with_module().empty()) GTEST_SKIP() << no_module;
  const auto outcome = python(R"(
from claims import CLAIMS, UNDECIDABLE
from published import Published
data = Published(")" + published +
                                  R"(")
assert len(CLAIMS) == 18
for claim in CLAIMS:
    found = claim.findings(data)
    assert len(found) == 24, claim.words
    assert all(each.verdict in ("holds", "fails", "no such regime", UNDECIDABLE) for each in found.values())
    assert all(each.reason for each in found.values() if each.verdict == UNDECIDABLE), claim.words
    assert all(each.over_all in (each.verdict, UNDECIDABLE) for each in found.values()), claim.words  # wider intervals
)",
                              python_with_module());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
}

TEST_F(JeongYang, PairedDifferencesCoverTheTruthAtTheirLevel) {
  if (python_with_module().empty()) GTEST_SKIP() << no_module;
  const auto outcome = python(R"(
from math import comb
from intervals import paired_difference
n, p_up, p_down = 12, 0.3, 0.1  # exact, over every outcome
missed = 0.0
for up in range(n + 1):
    for down in range(n + 1 - up):
        low, high = paired_difference(up, down, n, 0.9)
        chance = comb(n, up) * comb(n - up, down) * p_up**up * p_down**down * (1 - p_up - p_down)**(n - up - down)
        missed += chance * (not low <= p_up - p_down <= high)
assert missed <= 0.1, missed
)",
                              python_with_module());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
}

// Times of overturning at the quantiles of an exponential distribution, and the same with one time that many motions share.
TEST_F(JeongYang, RatesOfOverturningAreThoseOfTheMotionsAndDeparturesFromThemAreSeen) {
  if (python_with_module().empty()) GTEST_SKIP() << no_module;
  const auto outcome = python(R"(
from math import log
from survival import INITIAL, LIMIT, Escape
def escape(periods, lasting):
    rows = {"modes": {"chaotic": lasting, "overturned": len(periods), "rest": 7}, "overturned": periods + [None] * (lasting + 7)}
    return Escape([rows])
n, rate = 400, 1e-3
quantiles = [INITIAL + round(-log(1 - (i + 0.5) / n) / rate) for i in range(n)]
even = escape(quantiles + [INITIAL], 0)
assert even.early == 1 and even.at_risk == n
value, low, high = even.rate(0.95)
assert abs(value / rate - 1) < 0.01 and 0.89 * rate < low < value < high < 1.11 * rate, (low, value, high)
assert even.departure() > 0.9, even.departure()
shared = escape([1000 if 900 < period < 1300 else period for period in quantiles], 0)
assert shared.departure() < 1e-3, shared.departure()
censored = escape([period for period in quantiles if period < INITIAL + 500], 5)
assert censored.exposure == sum(p - INITIAL for p in quantiles if p < INITIAL + 500) + 5 * (LIMIT - INITIAL)
assert escape([], 300).rate(0.95)[0:2] == (0.0, 0.0)
)",
                              python_with_module());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
}

TEST_F(JeongYang, IntervalsOfTheScriptAreThoseOfTheProgram) {
  if (python_with_module().empty()) GTEST_SKIP() << no_module;
  const auto outcome =
      python(R"(
import subprocess, sys
from published import read
subprocess.run([")" ROCKING_PROGRAM R"(", "run", ")" +
                 questions + R"(/regions.json", "-o", "run", "--realisations", "30", "--no-page", "-q"],
               check=True, stdout=subprocess.DEVNULL)
from intervals import clopper_pearson
seen = 0
for condition in read("run/report.json")["result"]["conditions"]:
    for mode, found in condition["probabilities"].items():
        seen += 1
        asked = clopper_pearson(condition["counts"][mode], condition["realisations"], 0.95)
        assert all(abs(a - b) < 1e-9 for a, b in zip(asked, found["clopper_pearson"])), (mode, asked)
assert seen > 5
)",
             python_with_module());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
}

// Of two runs, one of them random: its first realisations have the digest and the responses that are published.
TEST_F(JeongYang, PublishedRunsAreWhatNewRunsGive) {
  const auto outcome = python(R"(
import json, sys
from pathlib import Path
from cells import experiment
from published import read
from runs import Folder, differs
published = read(")" + published +
                              R"(/runs.json.xz")
folder = Folder(")" ROCKING_PROGRAM R"(", Path("again"))
for name in ("rest_no_sliding", "regions_as-plotted_any"):
    assert not differs(folder, name, published[name], json.dumps(experiment(name))), name
changed = dict(published["rest_no_sliding"], first={"realisations": 1, "digest": "0"})
assert differs(folder, "rest_no_sliding", changed, json.dumps(experiment("rest_no_sliding")))
)");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
}

TEST_F(JeongYang, PublishedRunsAreThoseOfTheFiles) {
  const auto outcome = python(R"(
import json, subprocess
from cells import RUNS, experiment
from published import read
published = read(")" + published +
                              R"(/runs.json.xz")
assert sorted(published) == sorted(RUNS)
for name in RUNS:
    text = subprocess.run([")" ROCKING_PROGRAM R"(", "validate", "-", "--json"], input=json.dumps(experiment(name)),
                          capture_output=True, check=True, text=True).stdout
    asked = json.loads(text)
    asked = asked.get("experiment", asked)
    found = dict(published[name]["experiment"])
    assert found.pop("realisations") >= asked.pop("realisations"), name
    assert found == asked, name
)");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
}

}  // namespace
