// Figures of a run: their numbers are those of the report, equal figures give equal files, and a text cannot inject
// commands into a script.

#include <algorithm>
#include <cstdlib>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "analysis/draw.hpp"
#include "analysis/figure_scripts.hpp"
#include "analysis/gnuplot_axes.hpp"
#include "analysis/gnuplot_text.hpp"
#include "analysis/run_figures.hpp"
#include "rocking/base/error.hpp"
#include "rocking/figures/palette.hpp"
#include "rocking/text/files.hpp"
#include "support/sample_report.hpp"
#include "support/temporary_folder.hpp"

namespace {

using rocking::Json;
using rocking::Report;
using rocking::report_in;
using rocking::analysis::Cell;
using rocking::analysis::Figure;
using rocking::analysis::run_figures;
using rocking::analysis::Table;
using rocking::support::sample_report;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// The figure with this name; one without tables if there is none.
Figure figure_named(const Report& report, const std::string& name) {
  for (Figure& figure : run_figures(report)) {
    if (figure.name == name) return std::move(figure);
  }
  ADD_FAILURE() << "no figure " << name;
  return {};
}

double value(const Table& table, std::size_t row, const std::string& column) {
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (table.columns[i].name == column) return std::get<double>(table.rows.at(row).at(i));
  }
  ADD_FAILURE() << "no column " << column;
  return 0.0;
}

TEST(ModeProbabilities, AreTheReportsToTheBit) {
  const Json text = sample_report();
  const Figure figure = figure_named(report_in(text), "mode_probabilities");
  const Json& conditions = text["result"]["conditions"];
  ASSERT_EQ(figure.panels.size(), 2U);  // two frictions, three amplitudes
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const Table& table = figure.tables[i / 3];
    EXPECT_EQ(value(table, i % 3, "amplitude"), conditions[i]["parameters"]["/excitation/amplitude"]);
    EXPECT_EQ(value(table, i % 3, "n"), conditions[i]["realisations"]);
    const Json& probability = conditions[i]["probabilities"]["(1,3)"];
    EXPECT_EQ(value(table, i % 3, "(1,3)"), probability["estimate"]);
    EXPECT_EQ(value(table, i % 3, "(1,3)_low"), probability["simultaneous"][0]);
    EXPECT_EQ(value(table, i % 3, "(1,3)_high"), probability["simultaneous"][1]);
    EXPECT_EQ(value(table, i % 3, "(1,3)_count"), conditions[i]["counts"]["(1,3)"]);
  }
}

TEST(ModeProbabilities, QuoteTheIntervalThatHoldsWheneverTheRunStopped) {
  Json text = sample_report();
  text["result"]["conditions"][0]["probabilities"]["(1,1)"]["anytime"] = {0.125, 0.875};
  const Figure figure = figure_named(report_in(text), "mode_probabilities");
  EXPECT_EQ(value(figure.tables[0], 0, "(1,1)_low"), 0.125);
}

TEST(ModeBands, FillEveryConditionFromZeroToOne) {
  const Figure figure = figure_named(report_in(sample_report()), "mode_bands");
  for (std::size_t panel = 0; panel < figure.panels.size(); ++panel) {
    for (const auto& row : figure.tables[panel].rows) {
      double edge = 0.0;
      for (const auto& layer : figure.panels[panel].layers) {
        EXPECT_EQ(std::get<double>(row[layer.columns[2]]), edge);
        edge = std::get<double>(row[layer.columns[3]]);
      }
      EXPECT_EQ(edge, 1.0);
    }
  }
}

TEST(ModeStyles, TellTheNamedModesApartInGreyToo) {
  std::vector<std::pair<std::string, int>> looks;
  for (const char* name :
       {"(1,1)", "(1,2)", "(1,3)", "(1,4)", "(1,5)", "chaotic", "overturned", "rest", "unresolved"}) {
    const auto style = rocking::analysis::style_of(*rocking::section::response_mode_named(name));
    looks.emplace_back(style.colour, style.marker);
  }
  for (std::size_t i = 0; i < looks.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_NE(looks[i].first, looks[j].first);
      EXPECT_NE(looks[i].second, looks[j].second);
    }
  }
}

TEST(DataFile, HasItsColumnsNamesAndEveryNumberInFull) {
  Figure figure;
  figure.title = "two\nlines";
  figure.tables = {{.name = "first", .columns = {{"x", "A_h"}, {"word", "a word"}}, .rows = {{0.1, "a \"b\"\tc"}}},
                   {.name = "second", .columns = {{"y", "P"}}, .rows = {{Cell()}, {1.0 / 3.0}}}};
  EXPECT_EQ(rocking::analysis::data_text(figure),
            "# two lines\n# first\n# 1 x: A_h\n# 2 word: a word\n# x\tword\n0.1\t\"a 'b' c\"\n\n\n"
            "# second\n# 1 y: P\n# y\nNaN\n0.3333333333333333\n");
}

TEST(Report, IsRefusedByName) {
  const auto refusal = [](const Json& json) -> std::string {
    try {
      static_cast<void>(rocking::parse_report(json.dump()));
    } catch (const rocking::base::InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  Json other = sample_report();
  other["format"] = "rocking.report/9";
  EXPECT_THAT(refusal(other), HasSubstr("/format"));
  Json torn = sample_report();
  torn["result"]["conditions"][1].erase("counts");
  EXPECT_THAT(refusal(torn), HasSubstr("counts"));
}

bool has_gnuplot() { return std::system("command -v gnuplot >/dev/null") == 0; }

class Drawn : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!has_gnuplot()) GTEST_SKIP() << "gnuplot was not found (Debian: gnuplot-nox)";
  }
};

TEST_F(Drawn, TwiceGivesTheSameBytes) {
  const rocking::support::TemporaryFolder first;
  const rocking::support::TemporaryFolder second;
  const auto figures = run_figures(report_in(sample_report()));
  for (const Figure& figure : figures) {
    for (const auto* folder : {&first, &second}) {
      const auto drawing = write_figure(figure, *folder / "", rocking::analysis::figure_formats());
      EXPECT_TRUE(drawing.is_drawn()) << drawing.reason;
      EXPECT_EQ(drawing.reason, "");
    }
    // cairo 1.18 compresses the date in a PDF (CHANGELOG, known issues); earlier versions write it as text.
    const bool has_plain_date =
        rocking::read_file(first / (figure.name + ".pdf")).find("/CreationDate (D:") != std::string::npos;
    for (const std::string ending : {".tsv", ".gp", ".svg", ".png", ".pdf"}) {
      const std::string content = rocking::read_file(first / (figure.name + ending));
      EXPECT_GT(content.size(), 200U) << figure.name << ending;
      if (ending == ".pdf" && !has_plain_date) continue;
      EXPECT_EQ(content, rocking::read_file(second / (figure.name + ending))) << figure.name << ending;
      if (ending == ".pdf") {
        EXPECT_THAT(content, HasSubstr("(D:20000101000000"));
      }
    }
  }
}

/// A figure of one point with these texts in every place that can show external text.
Figure figure_with(const std::string& text) {
  Figure figure;
  figure.name = "texts";
  figure.title = text;
  figure.subtitle = text;
  figure.tables = {{.name = text, .columns = {{text, text}, {"y", text}}, .rows = {{0.0, 0.5}}}};
  figure.panels.push_back(
      {.title = text,
       .x = {.quantity = text, .symbol = "", .unit = text, .low = -1.0, .high = 1.0, .ticks = {{0.0, text}}},
       .y = {.quantity = "y", .symbol = "", .unit = "", .low = 0.0, .high = 1.0},
       .layers = {{.kind = rocking::analysis::LayerKind::points, .table = 0, .columns = {0, 1}, .legend = text}}});
  return figure;
}

/// A figure of two points from `low` to `high` along x, with the quantity `q`.
Figure figure_from(double low, double high, bool logarithmic) {
  Figure figure;
  figure.name = "ticks";
  figure.tables = {{.name = "points", .columns = {{"x", "q"}, {"y", "y"}}, .rows = {{low, 0.2}, {high, 0.8}}}};
  figure.panels.push_back(
      {.title = "",
       .x = {.quantity = "q", .symbol = "", .unit = "", .logarithmic = logarithmic},
       .y = {.quantity = "y", .symbol = "", .unit = "", .low = 0.0, .high = 1.0, .ticks = {{0.5, "half"}}},
       .layers = {{.kind = rocking::analysis::LayerKind::points, .table = 0, .columns = {0, 1}}}});
  return figure;
}

/// The text of an SVG, without markup and entities.
std::string words_in(const std::string& svg) {
  std::string words = std::regex_replace(svg, std::regex("<[^>]*>"), "");
  for (const auto& [entity, letter] : {std::pair("&lt;", "<"), std::pair("&gt;", ">"), std::pair("&amp;", "&")}) {
    words = std::regex_replace(words, std::regex(entity), letter);
  }
  return std::regex_replace(words, std::regex("\xE2\x80\x8B"), "");  // the zero-width space in `]]>`
}

/// The texts that an SVG of gnuplot shows, in their order.
std::vector<std::string> texts_in(const std::string& svg) {
  std::vector<std::string> texts;
  const std::regex shown("<text>(.*?)</text>");
  for (std::sregex_iterator i(svg.begin(), svg.end(), shown), end; i != end; ++i) {
    const std::string words = words_in((*i)[1]);
    if (!words.empty()) texts.push_back(words);
  }
  return texts;
}

TEST_F(Drawn, HasTicksThatDifferAndFitHoweverNarrowTheRange) {
  for (const bool logarithmic : {false, true}) {
    for (const auto& [low, high] :
         {std::pair(60.001, 60.004), std::pair(60.0 + 1e-9, 60.0 + 4e-9), std::pair(1e6 + 1e-4, 1e6 + 4e-4),
          std::pair(1e12, 1e12 + 1.0), std::pair(1e-12, 4e-12), std::pair(59.0, 61.0), std::pair(3.1, 4.9),
          std::pair(0.02, 3e5), std::pair(1e-30, 1e30), std::pair(60.0, 60.0), std::pair(60.0, 60.0 + 1e-14),
          std::pair(-60.004, -60.001), std::pair(-1e6 - 4e-4, -1e6 - 1e-4)}) {
      if (logarithmic && low < 0.0) continue;
      rocking::analysis::Drawing drawing;
      const std::vector<std::string> texts = texts_in(picture_of(figure_from(low, high, logarithmic), "svg", drawing));
      ASSERT_EQ(drawing.reason, "");
      const std::string where = ::testing::PrintToString(texts) + (logarithmic ? " log " : " ") + std::to_string(low);
      EXPECT_EQ(std::set<std::string>(texts.begin(), texts.end()).size(), texts.size()) << where;
      EXPECT_GE(texts.size(), 4U) << where;  // half, two ticks, the quantities
      for (const std::string& text : texts) EXPECT_LE(text.size(), 24U) << where;
    }
  }
}

TEST(Ticks, AreFewerWhereTheyWouldOverlap) {
  const Figure figure = figure_from(-3400.0, 3400.0, false);
  EXPECT_TRUE(rocking::analysis::with_ticks(figure, figure.panels.front(), 600.0).x.ticks.empty());
  const auto ticks = rocking::analysis::with_ticks(figure, figure.panels.front(), 140.0).x.ticks;
  ASSERT_EQ(ticks.size(), 3U);
  EXPECT_EQ(ticks.front().text,
            "\xE2\x88\x92"
            "2000");
  EXPECT_EQ(ticks.back().place, 2000.0);
}

TEST(Ticks, CountFromANumberThatTheLabelNames) {
  const Figure figure = figure_from(-1e6 - 4e-4, -1e6 - 1e-4, false);
  const auto axis = rocking::analysis::with_ticks(figure, figure.panels.front(), 600.0).x;
  const std::string label = rocking::analysis::label_of(axis);
  ASSERT_TRUE(label.starts_with("q + ")) << label;
  const double from = -std::stod(label.substr(4));
  ASSERT_GE(axis.ticks.size(), 3U);
  for (const auto& tick : axis.ticks) EXPECT_NEAR(tick.place, from + std::stod(tick.text), 1e-9) << label;
}

std::size_t count_of(const std::string& part, const std::string& whole) {
  std::size_t count = 0;
  for (std::size_t place = whole.find(part); place != std::string::npos; place = whole.find(part, place + 1)) ++count;
  return count;
}

TEST_F(Drawn, ShowsEveryTextAsItIsWhereverItStands) {
  std::vector<std::string> texts{"'Tis rocking",
                                 "''",
                                 "it's '.system(\"touch x\").' `touch x`",
                                 "} {x; do for [",
                                 "\\n \\047 \\",
                                 "%g %s 5%",
                                 "a_b^c{d}@e~f&g",
                                 "&amp; &lt; &#60;",
                                 "x ]]> &#x1; y",
                                 "'0 \"1 #23 {7",
                                 "$1 @x !ls",
                                 "µ₀ \xF0\x9F\x98\x80"};
  for (char c = '!'; c < 127; ++c) texts.push_back(std::string("<") + c + "08>");
  for (const std::string& text : texts) {
    rocking::analysis::Drawing drawing;
    const std::string svg = picture_of(figure_with(text), "svg", drawing);
    ASSERT_TRUE(drawing.is_drawn()) << text << ": " << drawing.reason;
    // title, subtitle, title of the panel, tick, legend; quantity and unit of the axis
    EXPECT_EQ(count_of(text, words_in(svg)), 7U) << text << '\n' << words_in(svg);
    EXPECT_EQ(svg.find("]]>", svg.find("<text")), std::string::npos) << text;
    EXPECT_EQ(svg.find("&#x1;"), std::string::npos) << text;
  }
}

TEST_F(Drawn, ShowsWhatIsNoTextAtAll) {
  for (const std::string& text : {std::string("a\0b", 3), std::string("\x01\x1b[2J\x7f"), std::string("\xff\xfe \xc3"),
                                  std::string("\xED\xA0\x80"), std::string("\xEF\xBF\xBF"), std::string(100'000, '\''),
                                  std::string("two\nlines\r\n")}) {
    rocking::analysis::Drawing drawing;
    const std::string svg = picture_of(figure_with(text), "svg", drawing);
    ASSERT_TRUE(drawing.is_drawn()) << drawing.reason;
    EXPECT_EQ(rocking::analysis::printable(svg).size(), svg.size());  // valid UTF-8; new lines became spaces
    EXPECT_TRUE(
        std::none_of(svg.begin(), svg.end(), [](char c) { return 0 <= c && c < ' ' && c != '\n' && c != '\t'; }));
  }
}

TEST_F(Drawn, ShowsAxesAndAWordWhereThereIsNothing) {
  Figure figure = figure_with("nothing");
  figure.tables.front().rows.clear();
  for (rocking::analysis::Axis* axis : {&figure.panels[0].x, &figure.panels[0].y}) {
    axis->low.reset();
    axis->high.reset();
    axis->ticks.clear();
  }
  for (const bool logarithmic : {false, true}) {
    figure.panels[0].y.logarithmic = logarithmic;
    rocking::analysis::Drawing drawing;
    EXPECT_THAT(picture_of(figure, "svg", drawing), HasSubstr("nothing to show")) << drawing.reason;
  }
  figure.panels[0].layers.clear();
  rocking::analysis::Drawing drawing;
  EXPECT_THAT(picture_of(figure, "svg", drawing), HasSubstr("nothing to show")) << drawing.reason;
}

using rocking::analysis::FigureLook;
using rocking::analysis::journal_look;
using rocking::analysis::JournalWidth;

/// The figure's SVG for this column.
std::string journal_svg(const Figure& figure, JournalWidth width) {
  const rocking::support::TemporaryFolder folder;
  const auto drawing = write_figure(figure, folder / "", {"svg"}, {}, journal_look(width));
  EXPECT_TRUE(drawing.is_drawn()) << drawing.reason;
  return rocking::read_file(folder / (figure.name + ".svg"));
}

/// The numbers that follow each `key` in a text.
std::vector<double> numbers_after(const std::string& key, const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t place = text.find(key); place != std::string::npos; place = text.find(key, place + 1)) {
    numbers.push_back(std::stod(text.substr(place + key.size())));
  }
  return numbers;
}

TEST_F(Drawn, ForAJournalHasTheWidthOfItsColumnNoTitleAndNoSmallTextOrThinLine) {
  for (const auto& [width, millimetres] :
       {std::pair(JournalWidth::single_column, 84.0), std::pair(JournalWidth::double_column, 174.0)}) {
    for (Figure& figure : run_figures(report_in(sample_report()))) {
      figure.subtitle = "A SUBTITLE";
      const std::string svg = journal_svg(figure, width);
      // gnuplot writes whole pixels, and font sizes with one decimal.
      EXPECT_NEAR(numbers_after("width=\"", svg).front(), millimetres * 96.0 / 25.4, 1.0) << figure.name;
      EXPECT_THAT(words_in(svg), Not(HasSubstr(figure.title)));
      EXPECT_THAT(words_in(svg), Not(HasSubstr("A SUBTITLE")));
      const auto sizes = numbers_after("font-size=\"", svg);
      EXPECT_FALSE(sizes.empty());
      const double largest = *std::max_element(sizes.begin(), sizes.end());
      EXPECT_NEAR(largest, 8.0 * 96.0 / 72.0, 0.05) << figure.name;
      for (const double size : sizes) EXPECT_GE(size, 0.79 * largest) << figure.name << ": only subscripts are smaller";
      for (const double stroke : numbers_after("stroke-width=\"", svg)) EXPECT_GE(stroke, 0.66) << figure.name;
    }
  }
}

TEST_F(Drawn, ForAJournalLetsEveryLabelFitAndLettersItsPanels) {
  Figure figure = figure_with("a");
  figure.panels.push_back(figure.panels.front());
  for (const char* letter : {"(a) a", "(b) a"}) {
    EXPECT_THAT(words_in(journal_svg(figure, JournalWidth::single_column)), HasSubstr(letter));
  }
  figure.panels.front().x.quantity = std::string(200, 'q');
  EXPECT_THAT(words_in(journal_svg(figure, JournalWidth::single_column)), HasSubstr("qqq\xE2\x80\xA6"));
}

TEST_F(Drawn, GivesTheSameBytesInEveryTimeZone) {
  std::vector<std::string> pictures;
  for (const char* zone : {"UTC0", "Asia/Tokyo", "XYZ+7:30"}) {
    const rocking::support::TemporaryFolder folder;
    ::setenv("TZ", zone, 1);
    static_cast<void>(write_figure(figure_with("x"), folder / "", {"pdf"}));
    ::unsetenv("TZ");
    pictures.push_back(rocking::read_file(folder / "texts.pdf"));
  }
  EXPECT_EQ(pictures[0], pictures[1]);
  EXPECT_EQ(pictures[0], pictures[2]);
}

}  // namespace
