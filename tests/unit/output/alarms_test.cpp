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

/// Two conditions of a thousand realisations and a hundred thousand random numbers each.
ExperimentResult calm() {
  ExperimentResult result;
  for (int i = 0; i < 2; ++i) {
    ConditionResult& condition = result.conditions.emplace_back();
    condition.realisations = 1000;
    condition.operations.kinetic_friction_draws = 100'000;
  }
  return result;
}

TEST(Alarms, AreNoneForALossOfContactInAFinalFall) {
  ExperimentResult result = calm();
  result.conditions[1].validity.left_ground.add(7);
  EXPECT_THAT(alarms_of(result), IsEmpty());
  result.conditions[1].validity.left_ground_before_fall.add(7);
  EXPECT_THAT(alarms_of(result),
              ElementsAre(AllOf(HasSubstr("1 realisation lost contact"), HasSubstr("--condition 1 --realisation 7"))));
}

TEST(Alarms, AreRaisedWhereMoreThanOnePerCentIsClamped) {
  ExperimentResult result = calm();
  Validity& validity = result.conditions[1].validity;
  for (std::uint64_t i = 0; i < 10; ++i) validity.clamped.add(i);
  validity.clamps.kinetic_at_static = 1000;
  EXPECT_THAT(alarms_of(result), IsEmpty()) << "1 % of both";
  validity.clamps.kinetic_at_zero = 1;
  EXPECT_THAT(alarms_of(result),
              ElementsAre(AllOf(HasSubstr("1.0 % of the realisations and 1.0 % of the draws of condition 1"),
                                HasSubstr("difference between /friction/static and /friction/kinetic"))));
  validity.clamps = {.kinetic_at_zero = 11};
  validity.clamped.add(10);
  EXPECT_THAT(alarms_of(result), ElementsAre(HasSubstr("kinetic friction below 0"))) << "1.1 % of the realisations";
}

TEST(Alarms, HaveARemedyForEveryKindOfClamp) {
  for (const ClampKind& kind : clamp_kinds) {
    EXPECT_THAT(std::string(clamp_remedy(kind.key)), HasSubstr("reduce the sigma")) << kind.key;
  }
}

TEST(ToleranceRemedy, NamesTheKeyAndItsValueDownToDoublePrecision) {
  EXPECT_EQ(tolerance_remedy(1e-10), "set /accuracy/tolerance to 1e-12 and run again");
  EXPECT_EQ(tolerance_remedy(1e-13), "set /accuracy/tolerance to 1e-15 and run again");
  EXPECT_EQ(tolerance_remedy(3e-15), "set /accuracy/tolerance to 1e-15 and run again");
  EXPECT_THAT(tolerance_remedy(1e-15), HasSubstr("due to rounding"));
}

}  // namespace
