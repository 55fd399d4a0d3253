// The calls for what the program alone could do: branches as values, plans, tables, reports without a store, pages of
// trajectories.

#include <atomic>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/pages.hpp"
#include "rocking/rocking.hpp"
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

TEST(OrbitStudies, HaveTheBranchesOfTheirTextAsValues) {
  const Experiment experiment = swept_experiment();
  const OrbitsRequest request{.longest = 1, .branches = true};
  const OrbitStudy study = orbit_study(experiment, request);
  ASSERT_TRUE(study.branches);
  ASSERT_FALSE(study.branches->study.branches.empty());
  EXPECT_EQ(study.branches->pointer, "/excitation/amplitude");
  EXPECT_GE(study.branches->study.branches.front().points.size(), 2U);
  EXPECT_EQ(orbits_text(experiment, study), orbits(experiment, request));
  EXPECT_THAT(orbits_table(experiment, study), HasSubstr("branch"));
}

TEST(OrbitStudies, RefuseCurvesThatCannotBeFollowed) {
  const OrbitsRequest good{
      .longest = 1, .branches = true, .second = {"/excitation/frequency_ratio"}, .second_from = 9.0, .second_to = 11.0};
  for (const auto& spoil : {+[](OrbitsRequest& r) { r.branches = false; }, +[](OrbitsRequest& r) { r.second_to = {}; },
                            +[](OrbitsRequest& r) { r.second = {"/horizon/sampled_periods"}; },
                            +[](OrbitsRequest& r) { r.second_from = 10.5; }}) {
    OrbitsRequest bad = good;
    spoil(bad);
    EXPECT_THROW(static_cast<void>(orbit_study(swept_experiment(), bad)), base::InputError);
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
  const Plan timed = plan(experiment, clock);
  ASSERT_TRUE(timed.time);
  EXPECT_GT(timed.time->seconds, 0.0);
  EXPECT_THAT(describe(timed), HasSubstr("from a sample of"));
  EXPECT_THAT(describe_as_json(timed), HasSubstr("\"sampled_realisations\""));
  std::atomic<bool> stop{true};
  EXPECT_THROW(static_cast<void>(plan(experiment, clock, {.stop = &stop})), base::Stopped);
  EXPECT_THROW(static_cast<void>(plan(experiment, {}, {.shard = Shard{.part = 3, .parts = 2}})), base::InputError);
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

TEST(Trajectories, HaveAPage) {
  const support::TemporaryFolder folder;
  const auto file = folder / "motion.html";
  write_trajectory_page(drawn_experiment(), {.realisation = 3, .periods = 5}, file);
  EXPECT_GT(std::filesystem::file_size(file), 1000U);
  EXPECT_THROW(write_trajectory_page(drawn_experiment(), {.condition = 1}, file), base::InputError);
}

}  // namespace
}  // namespace rocking
