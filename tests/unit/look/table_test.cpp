// One table in four forms.

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/look/table.hpp"

namespace rocking::look {
namespace {

using ::testing::HasSubstr;

Table table_with_everything() {
  Table table{.title = "shares",
              .columns = {{.title = "A_h", .latex = "$A_h$"}, {.title = "(1,1)", .has_interval = true}}};
  add_columns(table, {"settled by", "rest"});
  table.rows = {{number(4.5, 3),
                 Number{.value = 0.00016, .form = percentage(), .interval = Ends(0.0001, 0.0002), .after = " (48)"},
                 Number{.value = 1000, .form = decimals(0), .interval = Ends(740.0, {}), .bound = '>'}, "a & \"b\", c"},
                {whole(100000), Number{.value = 0.028, .form = percentage(), .bound = '<'}, Cell(), Cell()}};
  table.notes = "that is all\n";
  return table;
}

TEST(Table, IsPrintedOnATerminal) {
  EXPECT_EQ(to_terminal(table_with_everything()),
            "shares\n"
            "   A_h                      (1,1)       settled by        rest\n"
            "   4.5  0.016 [0.010, 0.020] (48)  > 1000 [740, -]  a & \"b\", c\n"
            "100000                      < 2.8                .           .\n"
            "that is all\n");
  EXPECT_EQ(width_of(table_with_everything()), 62U);
}

TEST(Table, IsCsvWithAllDigits) {
  EXPECT_EQ(to_csv(table_with_everything()),
            "A_h,\"(1,1)\",low,high,settled by,rest\n"
            "4.5,0.00016,1e-04,2e-04,1000,\"a & \"\"b\"\", c\"\n100000,0.028,,,,\n");
  Table several{.columns = {{.title = "a", .has_interval = true}, {.title = "b", .has_interval = true}}};
  several.rows = {{Number{.value = {}, .interval = Ends({}, 2.0)}, Cell()}};
  EXPECT_EQ(to_csv(several), "a,a_low,a_high,b,b_low,b_high\n,,2,,,\n");
}

TEST(Table, IsLatex) {
  const std::string text = to_latex(table_with_everything(), "A $caption$");
  EXPECT_THAT(text, HasSubstr("\\caption{A $caption$}\n  \\begin{tabular}{rrrr}\n    \\toprule\n"
                              "    $A_h$ & (1,1) & settled by & rest \\\\\n    \\midrule\n"
                              "    4.5 & 0.016 [0.010, 0.020] (48) & $>$ 1000 [740, --] & a \\& ''b'', c \\\\\n"
                              "    100000 & $<$ 2.8 & -- & -- \\\\\n"));
}

TEST(Table, HasMinusSignsAndPowersOfTenInLatex) {
  Table table;
  add_columns(table, {"a", "b", "c", "d", "e"});
  table.rows = {
      {Number{.value = -0.45, .interval = Ends(-0.5, 0.25)}, number(0.00000186, 3), "-1.5e-07", "t-7", "1 - 2"}};
  EXPECT_THAT(to_latex(table, ""), HasSubstr("    $-0.45$ [$-0.5$, 0.25] & $1.86 \\times 10^{-6}$ & "
                                             "$-1.5 \\times 10^{-7}$ & t-7 & 1 - 2 \\\\\n"));
}

TEST(LatexCaption, EndsTheTitleWithAFullStopUnlessItHasAnEnd) {
  EXPECT_EQ(latex_caption("Two blocks", "Shares."), "Two blocks. Shares.");
  EXPECT_EQ(latex_caption("Which of them?", "Shares."), "Which of them? Shares.");
  EXPECT_EQ(latex_caption("", "Shares."), "Shares.");
}

TEST(Table, IsHtmlThatSaysWhenRowsAreLeftOut) {
  const std::string text = to_html(table_with_everything(), {.label = "l", .html = "<b>c</b>"}, 1);
  EXPECT_THAT(text, HasSubstr("aria-label=\"l\""));
  EXPECT_THAT(text, HasSubstr("<caption><span><b>c</b></span></caption>"));
  EXPECT_THAT(text, HasSubstr("<th scope=\"col\">A<sub>h</sub></th>"));
  EXPECT_THAT(text,
              HasSubstr("<th scope=\"row\">4.5</th><td>0.016 <span class=\"interval\">[0.010, 0.020]</span> (48)"));
  EXPECT_THAT(text, HasSubstr("a &amp; &quot;b&quot;, c"));
  EXPECT_THAT(text, HasSubstr("The first 1 of 2 rows."));
  EXPECT_THAT(to_html(table_with_everything(), {}, 2),
              HasSubstr("<td data-value=\"0\"><span class=\"none\">&lt; 2.8</span></td><td><span class=\"none\">none"));
}

TEST(Table, MergesNeighboursThatDifferOnlyInTheRange) {
  Table table;
  add_columns(table, {"static", "amplitude", "response"});
  table.rows = {
      {"0.4", "1", "rest"}, {"0.4", "2", "rest"}, {"0.4", "3", "(1,1)"}, {"0.5", "1", "(1,1)"}, {"0.5", "2", "(1,1)"}};
  merge_rows(table, 1, 1);
  EXPECT_EQ(to_csv(table), "static,amplitude,response\n0.4,1 to 2,rest\n0.4,3,\"(1,1)\"\n0.5,1 to 2,\"(1,1)\"\n");
  Table empty;
  merge_rows(empty, 0, 0);
  EXPECT_TRUE(empty.rows.empty());
}

TEST(Cell, IsPlainText) {
  constexpr double unbounded = std::numeric_limits<double>::infinity();
  EXPECT_EQ(plain_text(number(2.3149, stats::Interval{2.2, unbounded}, 3)), "2.31 [2.2, unbounded]");
  EXPECT_EQ(plain_text(number(std::nullopt, 3), "-"), "-");
  EXPECT_EQ(plain_text(interval(stats::Interval{0.1, 0.2}, percentage())), "[10.0, 20.0]");
  EXPECT_EQ(plain_text(interval(std::nullopt, 3)), ".");
}

}  // namespace
}  // namespace rocking::look
