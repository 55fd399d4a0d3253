// Recorded ground motions as the excitation of an experiment.

#include "rocking/input/record_formats.hpp"

#include <numbers>
#include <string>
#include <system_error>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/base/digest.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/scene/defaults.hpp"
#include "support/excitation.hpp"
#include "support/experiment_text.hpp"
#include "support/json_schema.hpp"

namespace {

using namespace rocking;
using support::with;
using ::testing::HasSubstr;

constexpr const char* record_text = "0 0\n0.5 3\n1 -3\n1.5 0\n";

std::string a_file(const std::string& name, std::size_t) {
  if (name == "bad.txt") return "0 zero\n";
  if (name == "long.txt") return std::string(most_ground_motion_bytes + 1, '\n');
  if (name != "r.txt" && name != "vertical.txt") {
    throw std::system_error(std::make_error_code(std::errc::no_such_file_or_directory), name);
  }
  return name == "r.txt" ? record_text : "0 0 0\n0.5 3 1\n1 0 0\n";
}

Experiment experiment_of(const Json& document) { return experiment_in(document.dump(), {}, {.files = a_file}); }

Json recorded(const std::string& excitation = R"({"kind": "recorded", "file": "r.txt"})") {
  return with(support::least_experiment(), "/excitation", excitation);
}

Problems refusals_of(const Json& document) {
  try {
    static_cast<void>(experiment_of(document));
  } catch (const base::InputError& error) {
    return error.problems();
  }
  return {};
}

TEST(RecordedExcitation, HasDefaults) {
  const auto condition = experiment_of(recorded()).conditions.at(0);
  const auto block = dynamics::geometry_of(mean_block(condition.scene));
  ASSERT_NE(support::recorded(condition.scene).ground_motion, nullptr);
  EXPECT_EQ(support::recorded(condition.scene).ground_motion->samples.size(), 4U);
  EXPECT_EQ(support::recorded(condition.scene).ground_motion->samples[1].horizontal, 3.0 / 9.81);
  EXPECT_EQ(support::recorded(condition.scene).scale, 1.0);
  EXPECT_DOUBLE_EQ(support::recorded(condition.scene).frequency_ratio * block.frequency_parameter,
                   2.0 * std::numbers::pi)
      << "one strobe period is a second";
  EXPECT_EQ(condition.horizon.transient_periods, 0);
  // 1.5 s of ground motion and 8 + 4/(1 - delta) = 8 + 4/(1.5/17) = 53.33 units of 1/p = 28.2 s.
  EXPECT_EQ(condition.horizon.sampled_periods, 30);
}

TEST(RecordedExcitation, IsWrittenOutWithItsDigest) {
  const auto experiment = experiment_of(recorded());
  const Json canonical = Json::parse(experiment.canonical_text);
  EXPECT_EQ(canonical["excitation"]["sha256"], base::to_hex(base::sha256(record_text)));
  EXPECT_EQ(canonical["excitation"]["scale"], 1.0);
  EXPECT_EQ(canonical["horizon"]["sampled_periods"], 30);
  EXPECT_EQ(support::objections("experiment", experiment.canonical_text), "");
  EXPECT_EQ(support::objections("experiment", recorded().dump()), "");
}

TEST(RecordedExcitation, HasACanonicalTextThatIsItsOwn) {
  for (const char* sweep : {R"([{"parameter": "/excitation/scale", "from": 1, "to": 2, "step": 0.1}])",
                            R"([{"parameter": "/block/height_m", "values": [2, 4]}])",
                            R"([{"parameter": "/restitution", "values": [0, 0.5]}])",
                            R"([{"parameter": "/formulation", "values": ["consistent", "as-printed"]}])",
                            R"([{"parameter": "/excitation", "values": [{"kind": "recorded", "file": "r.txt"},
            {"kind": "recorded", "file": "vertical.txt", "columns": ["time", "horizontal", "vertical"]}, {"amplitude": 3, "frequency_ratio": 10}]},
            {"parameter": "/block/gravity_m_s2", "values": [9.81, 1.62]}])"}) {
    const auto once = experiment_of(with(recorded(), "/sweep", sweep));
    const auto again = experiment_of(Json::parse(once.canonical_text));
    EXPECT_EQ(again.canonical_text, once.canonical_text) << sweep;
    ASSERT_EQ(again.conditions.size(), once.conditions.size());
    for (std::size_t i = 0; i < once.conditions.size(); ++i) {
      EXPECT_EQ(again.conditions[i].horizon.sampled_periods, once.conditions[i].horizon.sampled_periods) << sweep;
      EXPECT_EQ(support::mean_frequency_ratio(again.conditions[i].scene),
                support::mean_frequency_ratio(once.conditions[i].scene))
          << sweep;
    }
  }
}

TEST(RecordedExcitation, FollowsTheBlockThatASweepChanges) {
  const auto experiment =
      experiment_of(with(recorded(), "/sweep", R"([{"parameter": "/block/height_m", "values": [4, 16]}])"));
  const auto& [low, high] = std::tie(experiment.conditions[0], experiment.conditions[1]);
  EXPECT_LT(support::recorded(low.scene).frequency_ratio, support::recorded(high.scene).frequency_ratio);
  EXPECT_LT(low.horizon.sampled_periods, high.horizon.sampled_periods);
}

TEST(RecordedExcitation, IsReadOnceForAllConditions) {
  int opened = 0;
  const auto document =
      with(recorded(), "/sweep", R"([{"parameter": "/excitation/scale", "from": 0, "to": 10, "step": 0.1}])");
  const auto experiment = experiment_in(document.dump(), {}, {.files = [&](const std::string&, std::size_t) {
                                          ++opened;
                                          return std::string(record_text);
                                        }});
  EXPECT_EQ(opened, 1);
  EXPECT_EQ(support::recorded(experiment.conditions.front().scene).ground_motion,
            support::recorded(experiment.conditions.back().scene).ground_motion);
  EXPECT_EQ(support::recorded(experiment.conditions.back().scene).scale, 10.0);
}

TEST(RecordedExcitation, OpensNoFileWhereNoneIsAskedFor) {
  EXPECT_NO_THROW(static_cast<void>(experiment_in(
      support::example_experiment().dump(), {},
      {.files = [](const std::string&, std::size_t) -> std::string { throw std::logic_error("opened"); }})));
}

TEST(RecordedExcitation, HasVerticalMotionWhereItsFileHas) {
  const auto scene =
      experiment_of(
          recorded(R"({"kind": "recorded", "file": "vertical.txt", "columns": ["time", "horizontal", "vertical"]})"))
          .conditions[0]
          .scene;
  EXPECT_TRUE(support::recorded(scene).ground_motion->has_vertical);
}

TEST(RecordedExcitation, IsSeenFromTheFolderOfTheExperiment) {
  const auto experiment = read_experiment_file(ROCKING_SOURCE_DIR "/experiments/recorded/horizontal.json");
  EXPECT_EQ(support::recorded(experiment.conditions[0].scene).ground_motion->samples.size(), 801U);
}

TEST(RecordedExcitation, ThatIsNotThereIsMissingInput) {
  EXPECT_THROW(static_cast<void>(experiment_of(recorded(R"({"kind": "recorded", "file": "absent.txt"})"))),
               std::system_error);
}

struct BadExcitation {
  const char* excitation;
  const char* place;
  const char* reason;
  const char* remedy;
};

void PrintTo(const BadExcitation& bad, std::ostream* out) { *out << bad.excitation; }

class RecordedFault : public ::testing::TestWithParam<BadExcitation> {};

TEST_P(RecordedFault, IsToldWithPlaceReasonAndRemedy) {
  const auto problems = refusals_of(recorded(GetParam().excitation));
  ASSERT_EQ(problems.size(), 1U) << base::InputError(problems).what();
  EXPECT_EQ(problems[0].place, GetParam().place);
  EXPECT_THAT(problems[0].reason, HasSubstr(GetParam().reason));
  EXPECT_THAT(problems[0].remedy, HasSubstr(GetParam().remedy));
}

INSTANTIATE_TEST_SUITE_P(
    All, RecordedFault,
    ::testing::Values(
        BadExcitation{R"({"kind": "recorded"})", "/excitation/file", "is missing", "record.txt"},
        BadExcitation{R"({"kind": "recorded", "file": ""})", "/excitation/file", "not the name", "folder"},
        BadExcitation{R"({"kind": "recorded", "file": "r.txt\u0000"})", "/excitation/file", "not the name", "folder"},
        BadExcitation{R"({"kind": "recorded", "file": 3})", "/excitation/file", "must be text", "quotes"},
        BadExcitation{R"({"kind": "recorded", "file": "bad.txt"})", "bad.txt, line 1", "not a number", "#"},
        BadExcitation{R"({"kind": "recorded", "file": "long.txt"})", "long.txt", "64 MB", "shorter"},
        BadExcitation{R"({"kind": "recorded", "file": "r.txt", "scale": -1})", "/excitation/scale", "factor", "1.0"},
        BadExcitation{R"({"kind": "recorded", "file": "r.txt", "time_step_s": 0})", "/excitation/time_step_s",
                      "positive", "0.005"},
        BadExcitation{R"({"kind": "recorded", "file": "r.txt", "columns": "time"})", "/excitation/columns",
                      "must be a list", "[\"time\", \"horizontal\"]"},
        BadExcitation{R"({"kind": "recorded", "file": "r.txt", "columns": ["time", "up"]})", "/excitation/columns",
                      "must be a list", "horizontal"},
        BadExcitation{R"({"kind": "recorded", "file": "r.txt", "columns": ["time", "vertical"]})",
                      "/excitation/columns", "must name the horizontal component once", "give"},
        BadExcitation{R"({"kind": "recorded", "file": "r.txt", "columns": ["horizontal", "vertical"]})",
                      "/excitation/columns", "has no column of times", "time"},
        BadExcitation{R"({"kind": "recorded", "file": "r.txt", "columns": ["time", "horizontal"], "time_step_s": 1})",
                      "/excitation/columns", "beside a time step", "omit"},
        BadExcitation{R"({"kind": "recorded", "file": "r.txt", "phase_rad": 0})", "/excitation/phase_rad",
                      "a ground motion has no phase", "shift"},
        BadExcitation{R"({"kind": "recorded", "file": "r.txt", "amplitude": 2})", "/excitation/amplitude", "scale",
                      "\"scale\""},
        BadExcitation{R"({"kind": "recorded", "file": "r.txt", "sha256": "00"})", "/excitation/sha256", "digest",
                      "omit"},
        BadExcitation{R"({"kind": "recorded", "file": "r.txt", "frequency_ratio": 1e6})", "/horizon/sampled_periods",
                      "until the block rests", "lower"},
        BadExcitation{R"({"kind": "recoded", "file": "r.txt"})", "/excitation/kind", "one of", "recorded"}));

TEST(RecordedFault, IsToldBesideThoseOfABlockThatIsNone) {
  const auto problems = refusals_of(support::without(recorded(R"({"kind": "recorded", "file": "bad.txt"})"), "block"));
  ASSERT_EQ(problems.size(), 3U) << base::InputError(problems).what();
  EXPECT_EQ(problems[2].place, "bad.txt, line 1");
}

TEST(RecordedFault, IsAFluctuationOfAmplitude) {
  const auto problems = refusals_of(with(recorded(), "/fluctuation", R"({"amplitude": {"sigma": 0.1}})"));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_THAT(problems[0].remedy, HasSubstr("/excitation/scale"));
}

TEST(RecordedFault, IsASweepOfFilesWithoutTheirDigests) {
  const auto problems = refusals_of(
      with(recorded(), "/sweep", R"([{"parameter": "/excitation/file", "values": ["r.txt", "vertical.txt"]}])"));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_THAT(problems[0].remedy, HasSubstr("sweep \"/excitation\""));
}

TEST(RecordedExcitation, ComesToRestWithinItsHorizon) {
  // A block released just below its balance, under a ground motion of zeros: the sum of its hops, 2 artanh(delta^n).
  for (const double height : {1.5, 4.0, 20.0}) {
    auto document = with(with(recorded(), "/block/height_m", Json(height).dump()), "/excitation/scale", "0");
    const auto condition = experiment_of(document).conditions[0];
    const auto block = dynamics::geometry_of(mean_block(condition.scene));
    const double delta = 1.0 - 1.5 * block.sine * block.sine;
    double rocking = 0.0;
    for (double rate = 0.999; rate > 1e-12; rate *= delta) rocking += 2.0 * std::atanh(rate);
    EXPECT_GT(condition.horizon.sampled_periods, 1.5 + rocking / block.frequency_parameter) << height;
    EXPECT_LT(condition.horizon.sampled_periods, 2.5 + 2.0 * rocking / block.frequency_parameter) << height;
  }
}

}  // namespace
