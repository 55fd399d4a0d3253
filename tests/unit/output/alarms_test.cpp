// The alarms of a run: they are raised where something must be done, and say what.

#include "rocking/output/alarms.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace rocking;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// Two conditions of a thousand realisations and a hundred thousand random numbers each.
Report calm() {
  Report report;
  for (int i = 0; i < 2; ++i) {
    ConditionResult& result = report.conditions.emplace_back().result;
    result.realisations = 1000;
    result.operations.kinetic_friction_draws = 100'000;
  }
  return report;
}

TEST(Alarms, AreNoneForALossOfContactInAFinalFall) {
  Report report = calm();
  report.conditions[1].result.validity.left_ground.add(7);
  EXPECT_THAT(alarms_of(report), IsEmpty());
  report.conditions[1].result.validity.left_ground_before_fall.add(7);
  EXPECT_THAT(alarms_of(report),
              ElementsAre(AllOf(HasSubstr("1 realisation lost contact"), HasSubstr("--condition 1 --realisation 7"))));
}

TEST(Alarms, AreRaisedWhereMoreThanOnePerCentIsClamped) {
  Report report = calm();
  Validity& validity = report.conditions[1].result.validity;
  for (std::uint64_t i = 0; i < 10; ++i) validity.clamped.add(i);
  validity.clamps.kinetic_at_static = 1000;
  EXPECT_THAT(alarms_of(report), IsEmpty()) << "1 % of both";
  validity.clamps.kinetic_at_zero = 1;
  EXPECT_THAT(alarms_of(report),
              ElementsAre(AllOf(HasSubstr("1.0 % of the realisations and 1.0 % of the draws of condition 1"),
                                HasSubstr("difference between /friction/static and /friction/kinetic"))));
  validity.clamps = {.kinetic_at_zero = 11};
  validity.clamped.add(10);
  EXPECT_THAT(alarms_of(report), ElementsAre(HasSubstr("kinetic friction below 0"))) << "1.1 % of the realisations";
}

TEST(Alarms, HaveARemedyForEveryKindOfClamp) {
  for (const ClampKind& kind : clamp_kinds) {
    Report report = calm();
    report.conditions[0].result.validity.clamps.*kind.count = 50'000;
    EXPECT_THAT(worst_clamps(report).value().remedy, HasSubstr("reduce the sigma")) << kind.key;
  }
}

TEST(Alarms, GiveTheLawThatClampsLeave) {
  Report report = calm();
  report.conditions[0].result.validity.clamps.kinetic_at_static = 50'000;
  Scene& scene = report.conditions[0].asked.scene;
  scene.friction = {.static_coefficient = 0.35, .kinetic_coefficient = 0.30};
  scene.fluctuation = {.static_friction = 0.03, .kinetic_friction = 0.03};
  const std::string in_force = "the kinetic friction in force has mean 0.298 and sigma 0.0277, not 0.3 and 0.03";
  EXPECT_THAT(worst_clamps(report).value().remedy, HasSubstr(in_force));
  EXPECT_THAT(alarms_of(report), ElementsAre(HasSubstr(in_force)));
  scene.fluctuation.laws.kinetic_friction = FluctuationLaw::lognormal;
  EXPECT_THAT(worst_clamps(report).value().remedy, Not(HasSubstr("in force has")));
  scene.fluctuation.laws.kinetic_friction = FluctuationLaw::normal;
  scene.friction->kinetic_coefficient = Uniform{.low = 0.29, .high = 0.31};
  EXPECT_THAT(worst_clamps(report).value().remedy, Not(HasSubstr("in force has"))) << "drawn";
  scene.friction->kinetic_coefficient = 0.30;
  scene.friction->kinetic_ratio = 0.9;
  EXPECT_THAT(worst_clamps(report).value().remedy, Not(HasSubstr("in force has"))) << "a ratio";
}

TEST(Alarms, NameTheRecordsThatWereLeftOut) {
  Report report = calm();
  report.left_out = {"a.at2", "b.at2"};
  EXPECT_THAT(alarms_of(report), ElementsAre(HasSubstr("2 records of the suite could not be read and were left out: "
                                                       "a.at2, b.at2. The probabilities are those of the others")));
}

TEST(ToleranceRemedy, NamesTheKeyAndItsValueDownToDoublePrecision) {
  EXPECT_EQ(tolerance_remedy(1e-10), "set /accuracy/tolerance to 1e-12 and run again");
  EXPECT_EQ(tolerance_remedy(1e-13), "set /accuracy/tolerance to 1e-15 and run again");
  EXPECT_EQ(tolerance_remedy(3e-15), "set /accuracy/tolerance to 1e-15 and run again");
  EXPECT_THAT(tolerance_remedy(1e-15), HasSubstr("due to rounding"));
}

TEST(Alarms, TellOfRealisationsWithoutAnAnswer) {
  Report report = calm();
  ConditionResult& result = report.conditions[1].result;
  for (std::uint64_t i = 0; i < 3; ++i) result.validity.stopped.add(i);
  EXPECT_THAT(alarms_of(report), IsEmpty()) << "they have a response mode, and ended while it was watched";
  result.modes.emplace_back().probability.counts = {.successes = 5, .trials = 1000};
  EXPECT_THAT(alarms_of(report),
              ElementsAre(HasSubstr("3 of 2000 realisations ended before their horizon without an answer")));
}

}  // namespace
