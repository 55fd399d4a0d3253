// The calls for what the program alone could do: branches as values, plans, tables, reports without a store, pages of
// trajectories.

#include <atomic>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/pages.hpp"
#include "rocking/rocking.hpp"
#include "rocking/studies/orbits/study.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/json.hpp"
#include "support/temporary_folder.hpp"

namespace rocking {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

Experiment study_experiment(const std::string& keys) {
  return parse_experiment(R"({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    "horizon": {"transient_periods": 5, "sampled_periods": 15}, "restitution": 0.9, )" +
                          keys + "}");
}

Experiment drawn_experiment() {
  return study_experiment(R"("excitation": {"kind": "harmonic", "amplitude": 2, "frequency_ratio": 10,
    "phase_rad": {"uniform": [0, 6.28]}}, "realisations": 12)");
}

/// A symmetric orbit that exists at both amplitudes.
Experiment swept_experiment() {
  return study_experiment(R"("excitation": {"kind": "harmonic", "amplitude": 4, "frequency_ratio": 10},
    "sweep": [{"parameter": "/excitation/amplitude", "values": [3.9, 4.0]}])");
}

/// What the text says of an orbit or of a point on a branch, beside the value.
void expect_same(const Json& written, const Orbit& orbit) {
  EXPECT_EQ(written["period"], orbit.period);
  EXPECT_EQ(written["cycles"], orbit.cycles);
  EXPECT_EQ(written["state"]["tilt"], orbit.points.front().point.tilt);
  EXPECT_EQ(written["state"]["tilt_rate"], orbit.points.front().point.tilt_rate);
  EXPECT_EQ(written["stable"], orbit.stability.is_stable());
}

// The text is read again, and the values of a branch are checked by following the motion.
TEST(OrbitStudies, HaveTheBranchesOfTheirTextAsValues) {
  const Experiment experiment = swept_experiment();
  const OrbitStudy study = orbits(experiment, {.longest = 1});
  ASSERT_TRUE(study.branches);
  EXPECT_EQ(study.branches->pointer, "/excitation/amplitude");
  const std::string document = orbits_document().text(orbits_report(experiment, study));
  const Json text = Json::parse(document);
  ASSERT_EQ(text["conditions"].size(), study.conditions.size());
  for (std::size_t i = 0; i < study.conditions.size(); ++i) {
    const auto& orbits = study.conditions[i].orbits;
    ASSERT_EQ(text["conditions"][i]["orbits"].size(), orbits.size());
    for (std::size_t k = 0; k < orbits.size(); ++k) expect_same(text["conditions"][i]["orbits"][k], orbits[k]);
  }
  const auto& branches = study.branches->study.branches;
  ASSERT_FALSE(branches.empty());
  ASSERT_EQ(text["branches"].size(), branches.size());
  for (std::size_t b = 0; b < branches.size(); ++b) {
    const auto& points = branches[b].points;
    ASSERT_GE(points.size(), 2U);
    ASSERT_EQ(text["branches"][b]["points"].size(), points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      expect_same(text["branches"][b]["points"][k], points[k].orbit);
      EXPECT_EQ(text["branches"][b]["points"][k]["value"], points[k].value);
    }
  }
  // Read again, the text gives the same bytes.
  EXPECT_EQ(orbits_document().text(orbits_document().read(text)), document);
}

TEST(OrbitStudies, TellOfThePointsOfBranchesWhoseNumberIsNotKnown) {
  const Experiment experiment = swept_experiment();
  std::vector<std::pair<std::uint64_t, std::uint64_t>> told;
  const Execution execution{.on_progress = [&told](std::uint64_t done, std::uint64_t all) {
    told.emplace_back(done, all);
    return Decision::proceed;
  }};
  const OrbitStudy study = orbits(experiment, {.longest = 1, .most_branches = 2}, execution);
  std::size_t points = 0;
  for (const OrbitBranch& branch : study.branches->study.branches) points += branch.points.size();
  ASSERT_GE(told.size(), 3U);
  EXPECT_EQ(told[1], std::pair(experiment.conditions.size(), experiment.conditions.size()));
  for (std::size_t i = 2; i < told.size(); ++i) EXPECT_EQ(told[i], std::pair(i - 1, std::size_t{0}));
  EXPECT_GT(told.size() - 2, points / 2);
  // A caller may stop there.
  std::size_t calls = 0;
  EXPECT_THROW(static_cast<void>(orbits(experiment, {.longest = 1},
                                        {.on_progress =
                                             [&calls](std::uint64_t, std::uint64_t all) {
                                               ++calls;
                                               return all == 0 ? Decision::stop : Decision::proceed;
                                             }})),
               base::Stopped);
  EXPECT_EQ(calls, 3U);
}

// The state of an orbit returns after its period: the motion is that of trajectory(), which knows nothing of orbits.
TEST(OrbitStudies, HaveOrbitsWhoseMotionReturns) {
  const Experiment experiment = swept_experiment();
  const auto found = orbits(experiment, {.longest = 1, .branches = false}).conditions;
  ASSERT_EQ(found.size(), 2U);
  for (std::size_t i = 0; i < found.size(); ++i) {
    ASSERT_FALSE(found[i].orbits.empty());
    for (const Orbit& orbit : found[i].orbits) {
      Condition condition = experiment.conditions[i];
      const section::StrobePoint& start = orbit.points.front().point;
      condition.scene.initial.tilt = start.tilt;
      condition.scene.initial.tilt_rate = start.tilt_rate;
      const Trajectory motion = trajectory(experiment_of({condition}), {.periods = orbit.period});
      ASSERT_EQ(motion.strobe.size(), static_cast<std::size_t>(orbit.period));
      EXPECT_NEAR(motion.strobe.back().tilt, start.tilt, 1e-9);
      EXPECT_NEAR(motion.strobe.back().tilt_rate, start.tilt_rate, 1e-9);
    }
  }
}

TEST(Plans, HaveTheSizeOfARunAndItsTimeByTheClockOfTheCaller) {
  const Experiment experiment = drawn_experiment();
  const Plan alone = plan(experiment);
  EXPECT_EQ(alone.realisations, 12U);
  EXPECT_EQ(alone.periods, 12U * 20U);
  EXPECT_FALSE(alone.time);
  std::atomic<int> looks{0};
  const auto clock = [&looks] { return 1e-4 * ++looks; };
  const Plan timed = plan(experiment, {.elapsed_seconds = clock});
  ASSERT_TRUE(timed.time);
  EXPECT_GT(timed.time->seconds, 0.0);
  EXPECT_THAT(describe(timed), HasSubstr("from a sample of"));
  EXPECT_THAT(describe_as_json(timed), HasSubstr("\"sampled_realisations\""));
  std::atomic<bool> stop{true};
  EXPECT_THROW(static_cast<void>(plan(experiment, {.stop = &stop, .elapsed_seconds = clock})), base::Stopped);
  EXPECT_THROW(static_cast<void>(plan(experiment, {.shard = Shard{.part = 3, .parts = 2}})), base::InputError);
}

TEST(Tables, OfARunAreThoseOfACompleteOne) {
  const Experiment experiment = drawn_experiment();
  EXPECT_THAT(table(experiment, run(experiment)), HasSubstr("1 condition, 12 realisations, of which"));
  std::atomic<bool> stop{true};
  EXPECT_THROW(static_cast<void>(table(experiment, run(experiment, {.stop = &stop}))), std::invalid_argument);
}

TEST(Reports, AreVerifiedWithoutTheirStore) {
  const Experiment experiment = drawn_experiment();
  std::string text = report(experiment, run(experiment));
  const RunCheck good = verify_report(text);
  EXPECT_EQ(good.checked, 12U);
  EXPECT_THAT(good.findings, IsEmpty());
  std::atomic<bool> stop{true};
  EXPECT_THROW(static_cast<void>(verify_report(text, ".", {.stop = &stop})), base::Stopped);
  EXPECT_THROW(static_cast<void>(verify_report("{}")), base::InputError);
  const std::size_t digest = text.find(digest_of(run(experiment)));
  ASSERT_NE(digest, std::string::npos);
  text[digest] = text[digest] == '0' ? '1' : '0';
  EXPECT_THAT(verify_report(text).findings, ::testing::ElementsAre(HasSubstr("digest")));
}

// The page holds the motion as JSON, rounded to 1e-5 in the tilt.
TEST(Trajectories, HaveAPageWithTheirMotion) {
  const support::TemporaryFolder folder;
  const auto file = folder / "motion.html";
  const TrajectoryRequest request{.realisation = 3, .periods = 5, .samples_per_period = 7};
  write_trajectory_page(drawn_experiment(), request, file);
  const std::string page = read_file(file, std::size_t{1} << 24U);
  const std::string opening = R"(id="data-motions">)";
  const std::size_t begin = page.find(opening);
  ASSERT_NE(begin, std::string::npos);
  const std::size_t data = begin + opening.size();
  const Json shown = Json::parse(page.substr(data, page.find("</script>", data) - data)).at(0);
  const Trajectory motion = trajectory(drawn_experiment(), request);
  ASSERT_EQ(shown["tilts"].size(), motion.history.size());
  ASSERT_GT(motion.history.size(), 30U);
  for (std::size_t i = 0; i < motion.history.size(); ++i) {
    EXPECT_NEAR(shown["tilts"][i].get<double>(), motion.history[i].tilt, 0.5001e-5) << i;
  }
  EXPECT_THAT(page, HasSubstr("<polyline class=\"tilt\""));
  EXPECT_THROW(write_trajectory_page(drawn_experiment(), {.condition = 1}, file), base::InputError);
}

}  // namespace
}  // namespace rocking
