// `rocking threshold`: bands of a number in which the block overturns.

#include <string>

#include <gmock/gmock.h>

#include "cli/program.hpp"
#include "support/json_schema.hpp"

namespace {

using rocking::Json;
using rocking::support::objections;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class Threshold : public rocking::support::ProgramTest {
 protected:
  Threshold() {
    Json pulse = Json::parse(R"({ "format": "rocking.experiment/1", "block": { "width_m": 1.0, "height_m": 4.0 },
      "excitation": { "kind": "pulse", "shape": "sine", "amplitude": 1.0, "frequency_ratio": 5.0 },
      "restitution": { "rate_ratio": 0.9 } })");
    write("pulse.json", pulse.dump());
    pulse["sweep"] = Json::parse(R"([{ "parameter": "/excitation/frequency_ratio", "values": [2.0, 4.0, 6.0, 9.0] }])");
    write("spectrum.json", pulse.dump());
  }

  static constexpr const char* asked = " --of /excitation/amplitude --from 1 --to 10 --steps 60 ";
};

TEST_F(Threshold, PrintsTheAnswerFirstAndWritesTheBands) {
  const auto outcome = rocking(std::string("threshold pulse.json -q -o out") + asked);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_THAT(outcome.output, AllOf(StartsWith("the block overturns from 3.0"), HasSubstr(" on, stands again from 6."),
                                    HasSubstr("scanned in 60 steps of 0.15")));
  const std::string text = read("out/threshold.json");
  EXPECT_EQ(objections("threshold", text), "");
  const Json condition = Json::parse(text)["conditions"][0];
  EXPECT_EQ(condition["bands"].size(), 2U);
  EXPECT_EQ(condition["edges"].size(), 3U);
  EXPECT_EQ(rocking(std::string("threshold pulse.json -q -o out") + asked).exit_code, 74) << "the file is there";
}

TEST_F(Threshold, GivesTheSameBytesOnAnyNumberOfThreads) {
  const auto one = rocking(std::string("threshold spectrum.json --json -q -j 1") + asked);
  const auto five = rocking(std::string("threshold spectrum.json --json -q -j 5") + asked);
  EXPECT_EQ(one.exit_code, 0) << one.errors;
  EXPECT_EQ(one.output, five.output);
  EXPECT_EQ(Json::parse(one.output)["conditions"][3]["bands"], Json::array()) << "never at this frequency";
  EXPECT_EQ(Json::parse(one.output)["conditions"][3]["threshold"], nullptr);
}

TEST_F(Threshold, DrawsTheSpectrumOverAnotherNumber) {
  ASSERT_EQ(rocking(std::string("threshold spectrum.json -q -o out --figure drawn") + asked).exit_code, 0);
  EXPECT_TRUE(exists("drawn/threshold.svg"));
  ASSERT_EQ(rocking("report out/threshold.json -o again").exit_code, 0);
  EXPECT_EQ(read("again/threshold.tsv"), read("drawn/threshold.tsv"));
  ASSERT_EQ(rocking(std::string("threshold pulse.json -q -o one") + asked).exit_code, 0);
  const auto refused = rocking("report one/threshold.json -o none");
  EXPECT_EQ(refused.exit_code, 65);
  EXPECT_THAT(refused.errors, HasSubstr("sweep another number"));
}

TEST_F(Threshold, FindsTheAmplitudeOfAProbability) {
  Json random = Json::parse(read("pulse.json"));
  random["restitution"] = Json::parse(R"({ "rate_ratio": { "normal": { "mean": 0.9, "sigma": 0.02 } } })");
  write("random.json", random.dump());
  const std::string flags =
      "threshold random.json --json -q --of /excitation/amplitude --from 2.5 --to 4 --steps 6 "
      "--probability 0.5 --accuracy 0.05 --realisations 500 ";
  const auto found = rocking(flags + "-j 1");
  EXPECT_EQ(found.exit_code, 0) << found.errors;
  EXPECT_EQ(found.output, rocking(flags + "-j 3").output);
  EXPECT_EQ(objections("threshold", found.output), "");
  const Json edge = Json::parse(found.output)["conditions"][0]["edges"][0];
  // Without scatter the block falls from 3.033 on, and the more the larger the ratio is.
  EXPECT_LT(edge["stands"]["value"], 3.033);
  EXPECT_GT(edge["happens"]["value"], 3.033);
  const auto share = [](const Json& side) {
    return side["happened"].get<double>() / side["realisations"].get<double>();
  };
  EXPECT_LT(share(edge["stands"]), 0.5);
  EXPECT_GT(share(edge["happens"]), 0.5);
}

TEST_F(Threshold, RefusesWhatCannotBeAsked) {
  for (const std::string flags :
       {"--from 1 --to 2", "--of /excitation/nothing --from 1 --to 2", "--of /excitation/shape --from 1 --to 2",
        "--of /excitation --from 1 --to 2", "--of /excitation/amplitude", "--of /excitation/amplitude --from 1",
        "--of /excitation/amplitude --from 2 --to 1", "--of /excitation/amplitude --from 2 --to 2",
        "--of /excitation/amplitude --from nan --to 2", "--of /excitation/amplitude --from 1 --to inf",
        "--of /excitation/amplitude --from 1 --to 2 --steps 0",
        "--of /excitation/amplitude --from 1 --to 2 --steps 1e9",
        "--of /excitation/amplitude --from 1 --to 2 --accuracy -1",
        "--of /excitation/amplitude --from 1 --to 2 --event falling",
        "--of /excitation/amplitude --from 1 --to 2 --event 'slip > 0.1 m'"}) {
    const auto outcome = rocking("threshold pulse.json -o new " + flags);
    EXPECT_EQ(outcome.exit_code, 64) << flags << outcome.errors;
    EXPECT_EQ(outcome.output, "") << flags;
  }
  const auto outside = rocking("threshold pulse.json -o new --of /excitation/amplitude --from -1 --to 2");
  EXPECT_EQ(outside.exit_code, 65);
  EXPECT_THAT(outside.errors, HasSubstr("/excitation/amplitude = -1"));
  const auto random = rocking("threshold quick.json -o new --of /excitation/amplitude");
  EXPECT_EQ(random.exit_code, 65);
  EXPECT_THAT(random.errors, AllOf(HasSubstr("/fluctuation: is random"), HasSubstr("--probability 0.5")));
  const auto certain = rocking(std::string("threshold pulse.json -o new --probability 0.5") + asked);
  EXPECT_EQ(certain.exit_code, 64);
  EXPECT_THAT(certain.errors, HasSubstr("nothing in this experiment is random"));
  EXPECT_EQ(rocking("threshold quick.json -o new --of /excitation/amplitude --probability 1").exit_code, 64);
  EXPECT_EQ(rocking("threshold absent.json --of /excitation/amplitude").exit_code, 66);
  EXPECT_FALSE(exists("new"));
}

}  // namespace
