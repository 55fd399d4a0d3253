// `rocking verify` of an infer.json.

#include <gmock/gmock.h>

#include "cli/program.hpp"

namespace {

using rocking::Json;
using rocking::support::quick_experiment;
using ::testing::HasSubstr;

class VerifiedInference : public rocking::support::ProgramTest {
 protected:
  VerifiedInference() {
    Json experiment = quick_experiment();
    experiment.erase("sweep");
    experiment["horizon"] = {{"transient_periods", 5}, {"sampled_periods", 10}};
    experiment["realisations"] = 20;
    experiment["fluctuation"] = {{"amplitude", {{"sigma", 0.5}}}};
    experiment["unknown"] = Json::parse(R"([{"parameter": "/restitution", "from": 0.8, "to": 0.95}])");
    experiment["restitution"] = 0.9;
    write("quick.json", experiment.dump());
    write("tests.csv", "/excitation/amplitude,\"(1,1)\",other\n4.2,3,2\n5.0,1,4\n");
    EXPECT_EQ(rocking("infer quick.json --tests tests.csv -o out -q").exit_code, 0);
    original = read("out/infer.json");
  }

  /// What verify says of the file with another value.
  [[nodiscard]] auto changed(const char* pointer, const Json& value, const char* options = "") const {
    Json json = Json::parse(original);
    json.at(Json::json_pointer(pointer)) = value;
    write("out/infer.json", json.dump());
    return rocking(std::string("verify out ") + options);
  }

  std::string original;
};

TEST_F(VerifiedInference, FollowsFromItsDesign) {
  const auto outcome = rocking("verify out -j 2");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, HasSubstr("out/infer.json: 8 points run again"));
  EXPECT_EQ(Json::parse(rocking("verify out --json --sample 3").output)["points_run_again"], 3);
}

TEST_F(VerifiedInference, SeesAChangedAnswer) {
  EXPECT_THAT(changed("/unknowns/0/estimate", 0.9).output, HasSubstr("/unknowns/0/estimate is 0.9, not"));
  EXPECT_EQ(changed("/fit/p_value", 0.125).exit_code, 1);
  EXPECT_EQ(changed("/realisations", 12).exit_code, 1);
  EXPECT_EQ(changed("/tests/0/counts/0", 4).exit_code, 1);
  EXPECT_EQ(changed("/region/0/likelihood_ratio", 0.5).exit_code, 1);
}

// The answer follows from changed counts, too: only a new simulation tells.
TEST_F(VerifiedInference, SeesAChangedCountOfRealisations) {
  Json counts = Json::parse(original)["design"][2]["counts"][1];
  std::swap(counts[0], counts[1]);
  const auto outcome = changed("/design/2/counts/1", counts, "--sample 1000");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.output, HasSubstr("/design/2/counts/1/"));
}

TEST_F(VerifiedInference, RefusesWhatHasNoSense) {
  EXPECT_THAT(changed("/input/experiment/restitution", 0.85).output, HasSubstr("digest of input.sha256"));
  for (const char* list : {"/design/0/counts/0", "/design/0/counts", "/design/1/at", "/tests/1/counts",
                           "/tests/0/predicted", "/region/0/at", "/unknowns/0/profile"}) {
    const auto outcome = changed(list, Json::array());
    EXPECT_EQ(outcome.exit_code, 65) << list;
    EXPECT_THAT(outcome.errors, HasSubstr("infer.json, line ")) << list;
    EXPECT_EQ(rocking("report out/infer.json -o drawn").exit_code, 65) << list;
  }
  EXPECT_EQ(changed("/unknowns", Json::array()).exit_code, 65);
  EXPECT_EQ(changed("/unknowns/0/estimate", nullptr).exit_code, 65);
  EXPECT_EQ(changed("/unknowns/0/profile/1/at", 0.8).exit_code, 65);
  EXPECT_EQ(changed("/region_limit", nullptr).exit_code, 65);
  EXPECT_EQ(changed("/groups/0", "(1;1)").exit_code, 65);
  EXPECT_EQ(changed("/ended", "soon").exit_code, 65);
}

}  // namespace
