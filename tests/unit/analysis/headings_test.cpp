// Titles of panels and entries of legends are broken into lines where they are too long.

#include <string>

#include <gmock/gmock.h>

#include "analysis/figure_scripts.hpp"
#include "analysis/gnuplot_text.hpp"
#include "analysis/look.hpp"

namespace {

using namespace rocking::analysis;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(Wrapped, KeepsEveryWordAndTheWidth) {
  const std::string text = "upwards: each step from the end of the previous one";
  EXPECT_THAT(wrapped(text, 48), ElementsAre("upwards: each step from the end of the previous", "one"));
  EXPECT_THAT(wrapped(text, 20), ElementsAre("upwards: each step", "from the end of the", "previous one"));
  EXPECT_THAT(wrapped("", 5), ElementsAre(""));
  EXPECT_THAT(wrapped("a bcdefghij k", 4), ElementsAre("a", "bcd…", "k"));
  EXPECT_THAT(wrapped("Ω_h = 1 Θ′", 7), ElementsAre("Ω_h = 1", "Θ′"));
}

TEST(Headings, OfPanelsAndLegendsAreWholeInTheColumnOfAJournal) {
  const std::string title = "downwards: each step from the end of the previous one, and so on to the last word";
  const std::string legend = "friction 0.35/0.3, base amplitude 4.5 = 1.1 g, median of all realisations";
  Figure figure;
  figure.name = "f";
  figure.tables.push_back({.name = "t", .columns = {{"x", "x"}, {"y", "y"}}, .rows = {{0.0, 0.0}, {1.0, 1.0}}});
  const Layer line{.kind = LayerKind::line, .table = 0, .columns = {0, 1}, .style = {}, .legend = legend};
  for (int i = 0; i < 3; ++i) {
    figure.panels.push_back({.title = title, .x = {"x", "", ""}, .y = {"y", "", ""}, .layers = {line}});
  }
  for (const FigureLook& look :
       {journal_look(JournalWidth::single_column), journal_look(JournalWidth::double_column), screen_look()}) {
    const std::string script = script_text(figure, look);
    EXPECT_THAT(script, Not(HasSubstr("…")));
    for (const char* word : {"downwards:", "previous", "word", "realisations"}) EXPECT_THAT(script, HasSubstr(word));
  }
}

}  // namespace
