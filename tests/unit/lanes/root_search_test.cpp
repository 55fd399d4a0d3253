// The lanes find the same zero crossings as the search for one polynomial, to the bit, or report that the case is
// unclear.

#include "rocking/lanes/root_search.hpp"

#include <array>
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "rocking/integrate/polynomial.hpp"
#include "rocking/integrate/zero_crossing.hpp"
#include "support/random_polynomial.hpp"

namespace rocking::lanes {
namespace {

constexpr std::size_t count = 16;
constexpr std::size_t at_once = 8;
using Search = RootSearch<count, at_once, double>;

std::optional<double> found_alone(const support::Polynomial& p, double length) {
  std::array<double, integrate::max_coefficients> storage;
  return integrate::first_zero_crossing(integrate::scale_to_unit(p, length, storage));
}

TEST(RootSearch, FindsWhatIsFoundAlone) {
  constexpr int searches = 25'000;
  support::SplitMix draw(2014);
  int unclear = 0;
  int crossings = 0;
  for (int i = 0; i < searches; ++i) {
    Search search;
    std::array<support::Polynomial, at_once> asked;
    std::array<double, at_once> lengths;
    std::array<std::size_t, at_once> places;
    for (std::size_t j = 0; j < at_once; ++j) {
      asked[j] = support::random_polynomial(draw);
      asked[j].resize(count, 0.0);
      lengths[j] = draw.uniform(0.3, 1.2);
      places[j] = search.ask(1, lengths[j], [&](std::size_t k) { return asked[j][k]; });
    }
    ASSERT_EQ(search.size(), at_once);
    search.search();
    for (std::size_t j = 0; j < at_once; ++j) {
      const double answer = search.answer(1, places[j]);
      if (std::isnan(answer)) {
        ++unclear;
        continue;
      }
      const std::optional<double> alone = found_alone(asked[j], lengths[j]);
      ASSERT_EQ(answer, alone.value_or(Search::never)) << testing::PrintToString(asked[j]) << " over " << lengths[j];
      crossings += alone && *alone > 0.0 ? 1 : 0;
    }
  }
  EXPECT_LT(unclear, searches * static_cast<int>(at_once) / 3) << "the search has to be of some use";
  EXPECT_GT(crossings, 10'000);
}

// Signs that change twice over the whole interval, but at most once in each half.
TEST(RootSearch, HalvesWhatIsNotClearAsAWhole) {
  const auto answer = [](const support::Polynomial& p) {
    Search search;
    const std::size_t place = search.ask(1, 1.0, [&](std::size_t k) { return p[k]; });
    search.search();
    return search.answer(1, place);
  };
  for (const std::vector<double>& roots : {std::vector{0.3, 0.9}, {0.1, 0.55}, {-0.1, 0.3, 0.8}, {0.45, 0.51, 0.9}}) {
    support::Polynomial p = support::from_roots(roots.size() % 2 == 0 ? 1.0 : -1.0, roots);
    p.resize(count, 0.0);
    EXPECT_EQ(answer(p), found_alone(p, 1.0).value_or(Search::never)) << testing::PrintToString(roots);
  }
}

}  // namespace
}  // namespace rocking::lanes
