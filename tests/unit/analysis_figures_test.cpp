// Figures of a run: their numbers are the report's, equal figures give equal files, and a file cannot break out of a script.

#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "analysis/data_file.hpp"
#include "analysis/draw.hpp"
#include "analysis/gnuplot_script.hpp"
#include "analysis/palette.hpp"
#include "analysis/run_figures.hpp"
#include "rocking/base/error.hpp"
#include "rocking/report/files.hpp"
#include "support/sample_report.hpp"
#include "support/temporary_folder.hpp"

namespace {

using rocking::analysis::Cell;
using rocking::analysis::Figure;
using rocking::analysis::run_report_of;
using rocking::analysis::run_figures;
using rocking::analysis::RunReport;
using rocking::analysis::Table;
using rocking::report::Json;
using rocking::support::sample_report;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// The figure of this name; one without tables where there is none.
Figure figure_named(const RunReport& report, const std::string& name) {
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
  const Figure figure = figure_named(run_report_of(text), "mode_probabilities");
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
  const Figure figure = figure_named(run_report_of(text), "mode_probabilities");
  EXPECT_EQ(value(figure.tables[0], 0, "(1,1)_low"), 0.125);
}

TEST(ModeBands, FillEveryConditionFromZeroToOne) {
  const Figure figure = figure_named(run_report_of(sample_report()), "mode_bands");
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

TEST(Script, QuotesWhatAnExperimentIsCalled) {
  Json text = sample_report();
  text["input"]["experiment"]["title"] = "it's '.system(\"touch x\").' `ls`\nplot x";
  const std::string script = script_text(figure_named(run_report_of(text), "mode_bands"));
  EXPECT_THAT(script, HasSubstr("'it''s ''.system(\"touch x\").'' `ls` plot x'"));
}

TEST(RunReport, IsRefusedByName) {
  const auto refusal = [](const Json& json) -> std::string {
    try {
      static_cast<void>(rocking::analysis::read_run_report(json.dump()));
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
  const auto figures = run_figures(run_report_of(sample_report()));
  for (const Figure& figure : figures) {
    for (const auto* folder : {&first, &second}) {
      const auto drawing = write_figure(figure, *folder / "");
      EXPECT_TRUE(drawing.drawn) << drawing.reason;
      EXPECT_EQ(drawing.reason, "");
    }
    for (const char* ending : {".tsv", ".gp", ".svg", ".png", ".pdf"}) {
      const std::string content = rocking::report::read_file(first / (figure.name + ending));
      EXPECT_GT(content.size(), 200U) << figure.name << ending;
      EXPECT_EQ(content, rocking::report::read_file(second / (figure.name + ending))) << figure.name << ending;
    }
    EXPECT_THAT(rocking::report::read_file(first / (figure.name + ".pdf")), HasSubstr("(D:20000101000000"));
  }
}

TEST(Drawing, SaysWhatIsMissingAndLeavesTheData) {
  const rocking::support::TemporaryFolder folder;
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  const auto drawing = write_figure(figure_named(run_report_of(sample_report()), "mode_bands"), folder / "");
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_FALSE(drawing.drawn);
  EXPECT_THAT(drawing.reason, HasSubstr("gnuplot-nox"));
  EXPECT_THAT(rocking::report::read_file(folder / "mode_bands.tsv"), HasSubstr("amplitude"));
}

}  // namespace
