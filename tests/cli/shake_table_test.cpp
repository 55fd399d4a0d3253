// experiments/shake_table: the report follows from its numbers, and the script goes through a
// made-up data set of the same layout.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cli/program.hpp"

namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

const fs::path shake_table_folder = ROCKING_SOURCE_DIR "/experiments/shake_table";

class ShakeTable : public rocking::support::ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (python_with_module().empty()) {
      GTEST_SKIP() << "skipped: the Python module is not built (Debian: python3-dev pybind11-dev python3-numpy)";
    }
  }

  auto python(const std::string& arguments) {
    return shell("ROCKING='" ROCKING_PROGRAM "' exec " + python_with_module() + " -B " + arguments);
  }
};

TEST_F(ShakeTable, IsWrittenUpByTheScriptFromThePublishedNumbers) {
  const auto checked = python("'" + (shake_table_folder / "shake_table.py").string() + "' --check");
  EXPECT_EQ(checked.exit_code, 0) << checked.errors;
}

TEST_F(ShakeTable, GoesThroughDataOfTheSameLayout) {
  const std::string script = "'" + (shake_table_folder / "shake_table.py").string() + "' ";
  ASSERT_EQ(python("'" + (shake_table_folder / "make_small_data.py").string() + "' data").exit_code, 0);
  const auto run = python(script + "data results");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(read("results/shake_table.md"),
              AllOf(HasSubstr("# 8 shake-table tests"), HasSubstr("Rock 1 overturned in 4"),
                    HasSubstr("## What was inferred")));
  EXPECT_THAT(read("results/shake_table_rock_2.csv"), HasSubstr("test,probability\n1,0"));
  const auto again = python(script + "data results");
  EXPECT_EQ(again.exit_code, 0) << again.errors;
}

TEST_F(ShakeTable, ScoresRockTwoAndTriesWhatMayExplainShortPulses) {
  const std::string folder = "'" + shake_table_folder.string() + "/";
  ASSERT_EQ(python(folder + "make_small_data.py' data").exit_code, 0);
  ASSERT_EQ(python(folder + "shake_table.py' data results").exit_code, 0);
  const auto tried = python(folder + "short_pulses.py' data results data/outcomes_2.csv");
  ASSERT_EQ(tried.exit_code, 0) << tried.errors;
  const auto scored = python(folder + "shake_table.py' data results data/outcomes_2.csv");
  ASSERT_EQ(scored.exit_code, 0) << scored.errors;
  const std::string page = read("results/shake_table.md");
  EXPECT_THAT(page, AllOf(HasSubstr("rock 2 overturned in **3**"), HasSubstr("| always | 0.375 | 0.545 | 0.625 |"),
                          HasSubstr("| (e) sliding |"), HasSubstr("was scored once on rock 2: Brier")));
  EXPECT_LT(page.find("## Rock 2"), page.find("## Scores of rock 1"));
}

TEST_F(ShakeTable, ScoresTestsOfALaboratorysOwn) {
  const std::string folder = "'" + shake_table_folder.string() + "/";
  ASSERT_EQ(python(folder + "make_small_data.py' data").exit_code, 0);
  ASSERT_EQ(python(folder + "shake_table.py' data results").exit_code, 0);
  write("own.json", R"({"format": "rocking.experiment/1", "block": {"width_m": 0.06, "height_m": 0.6},
    "excitation": {"kind": "recorded", "suite": "results/motions/*.txt", "time_step_s": 0.005, "units": "g"}})");
  write("own.csv", "file,overturned,day\nTest001.txt,0,a\nTest002.txt,1,a\nTest010.txt,1,b\n");
  const auto run = python(folder + "own_tests.py' own.json own.csv own");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  EXPECT_THAT(read("own/prediction.csv"), HasSubstr("file,probability\nTest001.txt,0.0000\n"));
  EXPECT_THAT(read("own/scores.md"), AllOf(HasSubstr("# 3 tests: 2 overturned"), HasSubstr("| day | tests |")));
  write("own.csv", "file,overturned\nTest999.txt,0\n");
  const auto refused = python(folder + "own_tests.py' own.json own.csv own");
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.errors, HasSubstr("own.csv: Test999.txt is not in the suite"));
}

TEST_F(ShakeTable, NamesTheLineThatItCannotUse) {
  const std::string script = "'" + (shake_table_folder / "shake_table.py").string() + "' ";
  ASSERT_EQ(python("'" + (shake_table_folder / "make_small_data.py").string() + "' data").exit_code, 0);
  ASSERT_EQ(shell("sed -i '10s/.*/x/' data/data/Shake_Table_Response/Test003.txt").exit_code, 0);
  const auto run = python(script + "data results");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.errors, HasSubstr("Test003.txt, line 10: has no time and acceleration"));
}

}  // namespace
