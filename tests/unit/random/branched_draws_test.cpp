// Branches change the draws along the way, from their first index on, and no others.

#include "rocking/random/branched_draws.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace rocking::random {
namespace {

constexpr std::uint64_t first = 5;

/// All sources that have a name.
std::vector<Source> all_sources() {
  std::vector<Source> sources;
  for (int number = 1; number <= 255; ++number) {
    const auto source = static_cast<Source>(number);
    if (!to_string(source).empty()) sources.push_back(source);
  }
  return sources;
}

DrawHistory branched(double size) {
  DrawHistory history;
  Branch branch{.number = 77, .from = {}, .size = size};
  branch.from.fill(first);
  history.branches.push_back(branch);
  return history;
}

TEST(BranchedDraws, ChangeEverySourceThatIsDrawnAlongTheWayFromItsFirstUnusedIndexOn) {
  const Draws draws(1, 2);
  EXPECT_GE(all_sources().size(), 13U);
  for (const double size : {1.0, 0.6}) {
    const DrawHistory history = branched(size);
    const BranchedDraws changed(draws, &history);
    for (const Source source : all_sources()) {
      std::vector<double> together(10);
      changed.standard_normals(source, 0, together);
      for (std::uint64_t i = 0; i < 10; ++i) {
        const double before = draws.standard_normal(source, i);
        const double other = draws.of(77).standard_normal(source, i);
        const bool changes = is_drawn_along_the_way(source) && i >= first;
        const double now = changed.standard_normal(source, i);
        EXPECT_NEAR(now, changes ? std::sqrt(1.0 - size * size) * before + size * other : before, 1e-15)
            << to_string(source) << ' ' << i;
        EXPECT_EQ(together[i], now) << to_string(source) << ' ' << i;
      }
    }
  }
}

}  // namespace
}  // namespace rocking::random
