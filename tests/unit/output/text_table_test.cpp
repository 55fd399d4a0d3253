// Tables for a terminal: long cells, ranges of rows, and what fits one screen.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/output/text_table.hpp"

namespace {

using namespace rocking;
using ::testing::ElementsAre;

TEST(TextTable, ShortensLongCellsInTheMiddle) {
  const std::string forty(40, 'a');
  EXPECT_EQ(aligned({{forty}}), forty + '\n');
  EXPECT_EQ(aligned({{"/home/user/records/of/one/large/suite/TCU122-N.AT2"}}),
            "/home/user/r.../large/suite/TCU122-N.AT2\n");
  // Letters, not bytes: no letter of UTF-8 is cut.
  std::string umlauts;
  for (int i = 0; i < 50; ++i) umlauts += "ü";
  const std::string shortened = aligned({{umlauts}});
  EXPECT_EQ(letters_in(shortened), 41U);
  EXPECT_EQ(shortened.size(), 2U * 37U + 3U + 1U);
}

TEST(TextTable, MergesNeighboursThatDifferOnlyInTheRange) {
  const std::vector<TextRow> table{{"static", "amplitude", "response"},
                                   {"0.4", "1", "rest"},
                                   {"0.4", "2", "rest"},
                                   {"0.4", "3", "(1,1)"},
                                   {"0.5", "1", "(1,1)"},
                                   {"0.5", "2", "(1,1)"},
                                   {"0.5", "3", "(1,1)"}};
  EXPECT_THAT(merged_rows(table, 1, 1),
              ElementsAre(ElementsAre("static", "amplitude", "response"), ElementsAre("0.4", "1 to 2", "rest"),
                          ElementsAre("0.4", "3", "(1,1)"), ElementsAre("0.5", "1 to 3", "(1,1)")));
  EXPECT_THAT(merged_rows({{"amplitude"}, {"amplitude"}}, 0, 1),
              ElementsAre(TextRow{"amplitude"}, TextRow{"amplitude"}));
  EXPECT_TRUE(merged_rows({}, 0, 0).empty());
}

TEST(TextTable, IsPrintedWholeIfItFitsOrAllIsWanted) {
  const std::string fits(55, '\n');
  EXPECT_TRUE(is_printed_whole(fits, Extent::one_screen));
  EXPECT_FALSE(is_printed_whole(fits + '\n', Extent::one_screen));
  EXPECT_TRUE(is_printed_whole(fits + '\n', Extent::all));
}

}  // namespace
