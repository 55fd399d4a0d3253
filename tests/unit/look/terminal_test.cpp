// Tables on a terminal: long cells, and what fits one screen.

#include <string>

#include <gtest/gtest.h>

#include "rocking/look/table.hpp"
#include "rocking/look/text_table.hpp"

namespace {

using namespace rocking;

std::string only_line(const std::string& title) {
  look::Table table;
  add_columns(table, {title});
  return to_terminal(table);
}

TEST(Terminal, ShortensLongCellsInTheMiddle) {
  const std::string forty(40, 'a');
  EXPECT_EQ(only_line(forty), forty + '\n');
  EXPECT_EQ(only_line("/home/user/records/of/one/large/suite/TCU122-N.AT2"),
            "/home/user/r.../large/suite/TCU122-N.AT2\n");
  // Letters, not bytes: no letter of UTF-8 is cut.
  std::string umlauts;
  for (int i = 0; i < 50; ++i) umlauts += "ü";
  const std::string shortened = only_line(umlauts);
  EXPECT_EQ(letters_in(shortened), 41U);
  EXPECT_EQ(shortened.size(), 2U * 37U + 3U + 1U);
}

TEST(Terminal, BreaksLinesBetweenWordsAndLeavesTablesAlone) {
  EXPECT_EQ(wrapped("one two three\n  four five six\n", 9), "one two\nthree\n  four\n  five\n  six\n");
  EXPECT_EQ(wrapped("one two three", 13), "one two three");
  EXPECT_EQ(wrapped("longer_than_this is", 9), "longer_than_this\nis");
  EXPECT_EQ(wrapped("    n  (1,1)  overturned\n", 9), "    n  (1,1)  overturned\n");
  EXPECT_EQ(wrapped("ä ö ü ä ö ü\n\n", 11), "ä ö ü ä ö ü\n\n") << "letters, not bytes";
}

TEST(Terminal, PrintsWholeWhatFitsOrIsWanted) {
  const std::string fits(55, '\n');
  EXPECT_TRUE(is_printed_whole(fits, Extent::one_screen));
  EXPECT_FALSE(is_printed_whole(fits + '\n', Extent::one_screen));
  EXPECT_TRUE(is_printed_whole(fits + '\n', Extent::all));
}

}  // namespace
