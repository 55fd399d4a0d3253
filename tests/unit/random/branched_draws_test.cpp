// Branches change the draws along the way, from their first index on, and no others.

#include "rocking/random/branched_draws.hpp"

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

Branch branch(std::uint64_t number, std::uint64_t from) {
  Branch branch{.number = number, .from = {}};
  branch.from.fill(from);
  return branch;
}

TEST(BranchedDraws, ChangeEverySourceThatIsDrawnAlongTheWayFromItsFirstUnusedIndexOn) {
  const Draws draws(1, 2);
  EXPECT_GE(all_sources().size(), 13U);
  const DrawHistory history{.given = {}, .branches = {branch(77, first), branch(78, first + 2)}};
  const BranchedDraws changed(draws, &history);
  for (const Source source : all_sources()) {
    for (const std::uint64_t from : {std::uint64_t{0}, first, first + 4}) {
      std::vector<double> together(10);
      changed.standard_normals(source, from, together);
      for (std::uint64_t i = from; i < from + 10; ++i) {
        const bool changes = is_drawn_along_the_way(source) && i >= first;
        const std::uint64_t number = !changes ? 2 : i < first + 2 ? 77 : 78;
        EXPECT_EQ(changed.standard_normal(source, i), draws.of(number).standard_normal(source, i))
            << to_string(source) << ' ' << i;
        EXPECT_EQ(together[i - from], changed.standard_normal(source, i)) << to_string(source) << ' ' << i;
      }
    }
  }
}

TEST(BranchedDraws, HaveGivenNumbersInPlaceOfTheFirst) {
  const Draws draws(1, 2);
  const DrawHistory history{.given = {{Source::amplitude, 0.25}, {Source::phase, 0.75}}, .branches = {branch(77, 0)}};
  const BranchedDraws changed(draws, &history);
  EXPECT_EQ(changed.standard_normal(Source::amplitude, 0), 0.25);
  EXPECT_EQ(changed.uniform(Source::phase, 0), 0.75);
  EXPECT_EQ(changed.standard_normal(Source::amplitude, 1), draws.of(77).standard_normal(Source::amplitude, 1));
}

}  // namespace
}  // namespace rocking::random
