// `rocking motion`: what is read, the measures, and faults.

#include <filesystem>
#include <numbers>
#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "support/json_schema.hpp"
#include "support/record_text.hpp"

namespace {

using rocking::Json;
using rocking::support::esm_asc;
using rocking::support::objections;
using rocking::support::peer_at2;
using ::testing::AllOf;
using ::testing::HasSubstr;

class MotionCommand : public rocking::support::ProgramTest {
 protected:
  MotionCommand() {
    write("a.AT2", peer_at2({0.1, -0.25, 0.03, 0.0}, ".02"));
    write("b.asc", esm_asc("0.01", "cm/s^2", "3", "98.1\n-196.2\n0.0\n"));
    write("c.txt", "0 1\n1 -2\n2 0\n");
  }

  Json measured(const std::string& arguments) {
    const auto found = rocking("motion " + arguments + " --json");
    EXPECT_EQ(found.exit_code, 0) << found.errors;
    EXPECT_EQ(objections("motion", found.output), "");
    return Json::parse(found.output);
  }
};

TEST_F(MotionCommand, SaysWhatWasReadInEachFormat) {
  const Json found = measured("a.AT2 b.asc c.txt --periods 0.5 1 --block 0.35 1.6")["motions"];
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0]["format"], "peer_at2");
  EXPECT_EQ(found[0]["unit"], "g");
  EXPECT_EQ(found[0]["samples"], 4);
  EXPECT_EQ(found[0]["time_step_s"], 0.02);
  EXPECT_EQ(found[0]["duration_s"], 0.06);
  EXPECT_EQ(found[0]["pga_g"], 0.25);
  EXPECT_DOUBLE_EQ(found[0]["uplift_scale"], 0.35 / 1.6 / 0.25);
  ASSERT_EQ(found[0]["spectrum"].size(), 2U);
  EXPECT_EQ(found[0]["spectrum"][1]["period_s"], 1.0);
  const Json& spectrum = found[0]["spectrum"][1];
  const double omega = 2.0 * std::numbers::pi;
  EXPECT_DOUBLE_EQ(spectrum["sa_g"], omega * omega * spectrum["sd_m"].get<double>() / 9.81) << "not the absolute one";
  EXPECT_GT(spectrum["sa_absolute_g"], 1.001 * spectrum["sa_g"].get<double>());
  EXPECT_EQ(found[1]["format"], "esm_asc");
  EXPECT_EQ(found[1]["unit"], "cm/s2");
  EXPECT_DOUBLE_EQ(found[1]["pga_g"], 0.2);
  EXPECT_EQ(found[2]["format"], "columns");
  EXPECT_EQ(found[2]["time_step_s"], 1.0);
  EXPECT_EQ(found[2]["columns"], Json::parse(R"(["time", "horizontal"])"));
  EXPECT_EQ(found[2]["unit_is_assumed"], true);
  EXPECT_EQ(found[1]["unit_is_assumed"], false);
  EXPECT_DOUBLE_EQ(found[2]["pgv_m_s"], 1.5);
}

TEST_F(MotionCommand, TellsOfAFloorBesideTheGround) {
  const auto outcome = rocking("motion a.AT2 --building 5 0.05 1 --block 0.2 1.6");
  EXPECT_THAT(outcome.output, AllOf(HasSubstr("the ground motion a.AT2 has a PGA of 0.25 g"),
                                    HasSubstr(" times its strength; on the floor it has a PGA of ")));
}

TEST_F(MotionCommand, ChangesWithTheGravityOnlyWhatIsInMetres) {
  const Json here = measured("a.AT2 --gravity 9.81")["motions"][0];
  const Json moon = measured("a.AT2 --gravity 1.62")["motions"][0];
  EXPECT_EQ(here["pga_g"], moon["pga_g"]);
  EXPECT_DOUBLE_EQ(here["pgv_m_s"].get<double>() / 9.81, moon["pgv_m_s"].get<double>() / 1.62);
}

TEST_F(MotionCommand, WarnsOfOneSampleMoreOrFewerThanDeclared) {
  write("d.AT2", peer_at2("NPTS= 5, DT= .01 SEC", {0.1, 0.2, 0.3, 0.4}));
  const auto found = rocking("motion d.AT2 --json");
  EXPECT_EQ(found.exit_code, 0);
  EXPECT_THAT(found.errors, AllOf(HasSubstr("contains 4 samples"), HasSubstr("declares 5")));
  const Json motion = Json::parse(found.output)["motions"][0];
  EXPECT_EQ(motion["samples"], 4);
  EXPECT_EQ(motion["declared_samples"], 5);
  EXPECT_EQ(motion["warnings"].size(), 1U);
}

TEST_F(MotionCommand, MayHaveAFileWhoseNameIsNoUtf8) {
  write("\xff.AT2", read("a.AT2"));
  EXPECT_EQ(measured("'\xff.AT2'")["motions"][0]["file"], "\uFFFD.AT2");
}

// With sanitizers no limit of memory can hold.
TEST_F(MotionCommand, RefusesALineOf200MegabytesInBoundedMemory) {
  write("line.txt", "0 1\n0.01 ");
  std::filesystem::resize_file(folder_ / "line.txt", 200'000'000);  // the rest is zeros, which take no space on disk
  const std::string long_line = "0 1\n0.01 " + std::string(60'000'000, '1') + "\n0.02 1\n";
  write("digits.txt", long_line);
#ifdef ROCKING_SANITIZED
  const std::string limit;
#else
  const std::string limit = "ulimit -v 1000000; ";
#endif
  const auto whole = shell(limit + "'" ROCKING_PROGRAM "' motion line.txt --units g");
  EXPECT_EQ(whole.exit_code, 65) << whole.errors;
  EXPECT_THAT(whole.errors, HasSubstr("line.txt: is longer than 64 MB"));
  const auto part = shell(limit + "'" ROCKING_PROGRAM "' motion digits.txt --units g");
  EXPECT_EQ(part.exit_code, 65) << part.errors;
  EXPECT_THAT(part.errors, HasSubstr("digits.txt, line 2"));
  EXPECT_LT(part.errors.size(), 1000U) << "the line is cut";
}

TEST_F(MotionCommand, TakesAVerticalComponent) {
  write("v.AT2", peer_at2({0.01, 0.02, -0.03, 0.0}, ".02"));
  const Json found = measured("a.AT2 --vertical v.AT2 --block 0.35 1.6")["motions"][0];
  EXPECT_EQ(found["vertical_pga_g"], 0.03);
  const double slope = 0.35 / 1.6;
  EXPECT_DOUBLE_EQ(found["uplift_scale"], slope / (0.25 - slope * 0.02));
}

TEST_F(MotionCommand, SaysWhatTheColumnsAreAndTheUnitThatIsAssumed) {
  write("d.txt", "0 1 7 0.5\n0.5 -2 7 0.4\n1 0 7 -0.2\n");
  EXPECT_EQ(rocking("motion d.txt").exit_code, 65);
  EXPECT_THAT(rocking("motion d.txt").errors, HasSubstr("d.txt, line 1 = \"0 1 7 0.5\": has 4 columns"));
  for (const char* arguments :
       {"d.txt --columns time,horizontal,other,vertical", "d.txt --columns time horizontal other vertical",
        "--columns time horizontal other vertical d.txt"}) {
    const auto found = rocking("motion -q " + std::string(arguments));
    EXPECT_EQ(found.errors, "");
    EXPECT_THAT(found.output, AllOf(HasSubstr("time,horizontal,other,vertical"), HasSubstr("m/s2 (assumed)"),
                                    HasSubstr("in the file"), HasSubstr("vertical PGA [g]"), HasSubstr("0.05097")));
  }
  EXPECT_THAT(rocking("motion d.txt --columns time,horizontal,vertical").errors, HasSubstr("\"columns\" names 3"));
  EXPECT_EQ(rocking("motion d.txt --columns up").exit_code, 64);
  EXPECT_EQ(rocking("motion d.txt --columns time,vertical").exit_code, 65);
  EXPECT_THAT(rocking("motion a.AT2 --columns time,horizontal").errors, HasSubstr("has the format peer_at2"));
  EXPECT_EQ(rocking("motion c.txt --time-step 1").exit_code, 65);
}

}  // namespace
