#include "rocking/section/response_mode.hpp"

#include <gtest/gtest.h>

namespace rocking::section {
namespace {

TEST(ModeCounts, AreReadAsTheyAreWritten) {
  ModeCounts counts;
  EXPECT_EQ(mode_counts_named(to_string(counts)), counts);
  counts[{.kind = ResponseKind::unresolved}] = 3;
  counts[periodic(1, 3)] = 12;
  counts[{.kind = ResponseKind::overturned}] += 2;
  EXPECT_EQ(to_string(counts), "(1,3)=12 overturned=2 unresolved=3");
  EXPECT_EQ(mode_counts_named(to_string(counts)), counts);
  EXPECT_EQ(counts.total(), 17U);
}

TEST(ModeCounts, HaveOneSpelling) {
  for (const char* text : {" ", "(1,3)", "(1,3)=", "(1,3)=0", "(1,3)=-1", "(1,3)=1 ", "(1,3)=01", "(1,3)=1x",
                           "rest=1 (1,3)=2", "(1,3)=1 (1,3)=2", "nothing=1", "=1"}) {
    EXPECT_FALSE(mode_counts_named(text)) << text;
  }
}

}  // namespace
}  // namespace rocking::section
