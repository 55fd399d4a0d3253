// The results of a small experiment, to the bit. A change of this digest is a change of results: it belongs in
// CHANGELOG.md and increases results_version. tests/golden/everywhere compares the bits of compilers, optimisation
// levels and processors.

#include <gtest/gtest.h>

#include "golden/experiment.hpp"
#include "rocking/base/digest.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/stats/stopping_rule.hpp"

namespace rocking {
namespace {

TEST(Digest, IsTheSameEverywhere) {
  const auto result = run(golden::golden_experiment(), {.threads = 2, .on_progress = {}, .stop_requested = nullptr});
  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(base::to_hex(result->digest), "c974b42f9082218f54bf9256148a37f77d547e8298f03e8dae9891c0d86947d8");
}

// The bits that determine where a run stops that looks at its own intervals.
TEST(ConfidenceSequence, IsTheSameEverywhere) {
  const stats::ConfidenceSequence sequence(687.0);
  const stats::Interval prespecified = sequence.interval({731, 2000}, {.fixed = 0.05, .proportional = 0.0});
  EXPECT_EQ(prespecified.low, 0x1.53aed4948c9fep-2);
  EXPECT_EQ(prespecified.high, 0x1.99b6530bf6437p-2);
  const stats::Interval others = sequence.interval({17, 200}, {.fixed = 0.0, .proportional = 0.05});
  EXPECT_EQ(others.low, 0x1.70d35467995c3p-6);
  EXPECT_EQ(others.high, 0x1.7427382267c68p-3);
}

}  // namespace
}  // namespace rocking
