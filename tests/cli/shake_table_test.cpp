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

TEST_F(ShakeTable, NamesTheLineThatItCannotUse) {
  const std::string script = "'" + (shake_table_folder / "shake_table.py").string() + "' ";
  ASSERT_EQ(python("'" + (shake_table_folder / "make_small_data.py").string() + "' data").exit_code, 0);
  ASSERT_EQ(shell("sed -i '10s/.*/x/' data/data/Shake_Table_Response/Test003.txt").exit_code, 0);
  const auto run = python(script + "data results");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_THAT(run.errors, HasSubstr("Test003.txt, line 10: has no time and acceleration"));
}

}  // namespace
