#include "rocking/text/spelling.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace {

using namespace rocking;

TEST(EditDistance, CountsInsertionsDeletionsReplacementsAndSwaps) {
  EXPECT_EQ(edit_distance("", ""), 0U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3U);
  EXPECT_EQ(edit_distance("titel", "title"), 1U);
  EXPECT_EQ(edit_distance("ca", "abc"), 3U);  // restricted: no letter is edited twice
}

TEST(EditDistance, IsSymmetric) {
  for (const char* a : {"static", "kinetic", "sttic", "", "x"}) {
    for (const char* b : {"static", "kinetic", "sttic", "", "x"}) EXPECT_EQ(edit_distance(a, b), edit_distance(b, a));
  }
}

TEST(NearestWord, IsOfferedOnlyWhereItIsNear) {
  const std::vector<std::string> words{"run", "trajectory", "width_m"};
  EXPECT_EQ(nearest_word("rnu", words), "run");
  EXPECT_EQ(nearest_word("trajectroy", words), "trajectory");
  EXPECT_EQ(nearest_word("width", words), "width_m");
  EXPECT_EQ(nearest_word("colour", words), std::nullopt);
  EXPECT_EQ(nearest_word("run", {}), std::nullopt);
}

}  // namespace
