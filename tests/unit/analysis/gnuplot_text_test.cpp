// Preparation of texts for gnuplot.

#include "analysis/gnuplot_text.hpp"

#include <gtest/gtest.h>

namespace {

using namespace rocking::analysis;

TEST(GnuplotText, IsPlainLettersAndOctalNumbersInDoubleQuotes) {
  EXPECT_EQ(gnuplot_quoted("A_h = 4.2 (ψ)"), "\"A_h = 4.2 (ψ)\"");
  EXPECT_EQ(gnuplot_quoted("'\"`\\{}@$#%&"), R"("\047\042\140\134\173\175\100\044\043\045\046")");
}

TEST(GnuplotText, LeavesNoDigitBehindAnOctalNumber) { EXPECT_EQ(gnuplot_quoted("'12a3"), R"("\047\061\062a3")"); }

TEST(GnuplotText, IsValidUtf8OnOneLine) {
  EXPECT_EQ(printable("a\nb\tc\x7f\xC2\x85"), "a b c  ");
  EXPECT_EQ(printable("ψ€\xF0\x9F\x98\x80"), "ψ€\xF0\x9F\x98\x80");
  for (const char* wrong :
       {"\xff", "\x80", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82"}) {
    EXPECT_EQ(printable(wrong).substr(0, 3), "\uFFFD") << wrong;
    EXPECT_EQ(printable(printable(wrong)), printable(wrong));
  }
  EXPECT_EQ(printable("\xEF\xBF\xBE"), "\uFFFD");
}

TEST(GnuplotText, ShowsControlsOfWritingDirection) {
  EXPECT_EQ(printable("a\u202e2ta.exe"), "a\\u202e2ta.exe");
  EXPECT_EQ(gnuplot_quoted("\u2066x"), R"("\134u2066x")");
}

TEST(GnuplotText, IsCutBetweenLetters) {
  EXPECT_EQ(cut("ψψψψ", 4), "ψψψψ");
  EXPECT_EQ(cut("ψψψψψ", 4), "ψψψ…");
}

}  // namespace
