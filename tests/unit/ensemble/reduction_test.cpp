#include "rocking/ensemble/reduction.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace rocking {
namespace {

Summary named(const section::ResponseMode& mode, double held) {
  Summary summary;
  summary.mode = mode;
  summary.held = held;
  return summary;
}

/// A random condition with this number of realisations.
Condition random_condition(std::uint64_t realisations) {
  Condition condition;
  condition.scene.fluctuation.restitution = 0.01;
  condition.realisations = realisations;
  return condition;
}

TEST(Reduction, ListsWhatSettledLateAndTheLeastShareThatANameRestsOn) {
  const Condition condition = random_condition(4);
  Reduction reduction(condition);
  Summary jumped = named({}, 0.0);
  jumped.reason = section::Reason::phase_jump;
  for (const Summary& summary : {named(section::periodic(1, 1), 1.0), named(section::periodic(1, 3), 0.625), jumped,
                                 named(section::periodic(1, 3), 0.875)}) {
    reduction.add(summary);
  }
  const Validity validity = reduction.result().validity;
  EXPECT_EQ(validity.settled_late.count, 2U);
  EXPECT_EQ(validity.settled_late.first, (std::vector<std::uint64_t>{1, 3}));
  EXPECT_EQ(validity.least_held, 0.625);
  EXPECT_EQ(validity.unresolved.at(section::Reason::phase_jump).count, 1U);
}

TEST(Reduction, LetsNoUnresolvedResponseLowerTheLeastShare) {
  const Condition condition = random_condition(1);
  Reduction reduction(condition);
  reduction.add(named({}, 0.0));
  EXPECT_EQ(reduction.result().validity.least_held, 1.0);
  EXPECT_EQ(reduction.result().validity.settled_late.count, 0U);
}

}  // namespace
}  // namespace rocking
