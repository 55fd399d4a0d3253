// What `rocking infer` found, as figures and on the page of the run of its experiment.

#include <gmock/gmock.h>

#include "cli/campaign_block.hpp"
#include "cli/program.hpp"

namespace {

using rocking::Json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class InferFigures : public rocking::support::ProgramTest {
 protected:
  InferFigures() {
    Json block = rocking::support::campaign_block();
    block["unknown"].push_back({{"parameter", "/friction/static/normal/sigma"}, {"from", 0.001}, {"to", 0.08}});
    write("block.json", block.dump());
    write("tests.csv", "amplitude,\"(1,1)\",\"(1,3)\",other\n4.5,5,2,3\n6.0,5,1,4\n");
    write("next.csv", "amplitude\n3.0\n5.0\n");
  }
};

TEST_F(InferFigures, AreDrawnAlsoOnThePageOfTheRun) {
  ASSERT_EQ(rocking("run block.json -o out -q --no-page").exit_code, 0);
  ASSERT_EQ(rocking("infer block.json --tests tests.csv --candidates next.csv -q -o out").exit_code, 0);
  EXPECT_EQ(rocking("report out/infer.json -o drawn").exit_code, 0);
  EXPECT_THAT(read("drawn/infer_profile.tsv"), AllOf(HasSubstr("likelihood_ratio"), HasSubstr("mean of static")));
  EXPECT_THAT(read("drawn/infer_region.tsv"), HasSubstr("x_from"));
  EXPECT_THAT(read("drawn/infer_fit.tsv"), HasSubstr("predicted"));
  EXPECT_THAT(read("drawn/infer_candidates.tsv"), HasSubstr("region"));
  EXPECT_EQ(rocking("report out --format html -q").exit_code, 0);
  EXPECT_THAT(read("out/report.html"),
              AllOf(HasSubstr("What do the counted tests tell?"), HasSubstr("id=\"infer_profile\""),
                    HasSubstr("id=\"infer_region\""), HasSubstr("id=\"infer_fit\""),
                    HasSubstr("id=\"infer_candidates\""), HasSubstr("Identified: "), HasSubstr("p = ")));
  for (const char* place : {"/region_limit", "/candidates/0/region", "/unknowns/0/profile/1/at"}) {
    Json damaged = Json::parse(read("out/infer.json"));
    damaged[Json::json_pointer(place)] = std::string(place).ends_with("at") ? Json(0.0) : Json();
    write("damaged.json", damaged.dump());
    EXPECT_EQ(rocking("report damaged.json -o none").exit_code, 65) << place;
  }
  ASSERT_EQ(rocking("infer block.json --tests tests.csv -q -o out --overwrite --seed 5").exit_code, 0);
  EXPECT_THAT(rocking("report out --format html").errors, HasSubstr("another experiment"));
  EXPECT_THAT(read("out/report.html"), Not(HasSubstr("infer_profile")));
}

TEST_F(InferFigures, AreRefusedWithoutAnAnswer) {
  ASSERT_EQ(rocking("infer block.json --tests tests.csv -q -o out --max-time 0.001s").exit_code, 0);
  const auto outcome = rocking("report out/infer.json -o drawn");
  EXPECT_EQ(outcome.exit_code, 65);
  EXPECT_THAT(outcome.errors, AllOf(HasSubstr("there is no answer yet"), HasSubstr("--resume")));
  EXPECT_FALSE(exists("drawn"));
}

}  // namespace
