// Sentences of the page on grids of two and three entries: numbers, objects, files and words, in every order.

#include <algorithm>
#include <numeric>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "analysis/page/html.hpp"
#include "analysis/page/page.hpp"
#include "analysis/page/sections.hpp"
#include "analysis/page/words.hpp"
#include "rocking/figures/sweep_view.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/output/mode_look.hpp"
#include "rocking/output/report.hpp"
#include "support/sample_report.hpp"

namespace {

using rocking::Json;
using rocking::meaning_of;
using rocking::Report;
using rocking::report_in;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;
using namespace rocking::analysis;

/// An entry of a sweep.
struct Entry {
  const char* pointer;
  std::vector<Json> values;
};

/// The line along which the sentences go: nothing overturns below the last value, and (1,1) is replaced by (1,3) there.
struct Line {
  Entry entry;
  const char *before, *first, *middle, *last;  ///< HTML: the symbol or the name, then the values
};

const std::vector<Line> lines{
    {{"/excitation/amplitude", {3.0, 4.5, 6.25}}, "<i>A<sub>h</sub></i> = ", "3", "4.5", "6.25"},
    {{"/excitation/amplitude_g", {0.5, 0.75, 1.0}}, "base amplitude ", "0.5 g", "0.75 g", "1 g"},
    {{"/excitation/frequency_ratio", {8.0, 9.0, 11.0}}, "<i>Ω<sub>h</sub></i> = ", "8", "9", "11"},
    {{"/excitation/pga_g", {0.2, 0.3, 0.4}}, "<i>PGA</i> = ", "0.2 g", "0.3 g", "0.4 g"},
    {{"/excitation/scale", {1.0, 2.0, 4.0}}, "scale of the ground motion ", "1", "2", "4"}};

/// The other entries.
const std::vector<Entry> others{
    {"/friction", {{{"static", 0.35}, {"kinetic", 0.3}}, {{"static", 0.4}, {"kinetic", 0.35}}}},
    {"/excitation/file", {"near/one_A_h.at2", "far/one_A_h.at2"}},
    {"/formulation", {"consistent", "as-printed"}},
    {"/restitution", {0.9, "jy25"}},
    {"/restitution", {{{"rate_ratio", 0.8}}, {{"rate_ratio", 0.9}}}},
    {"/fluctuation/friction", {{{"sigma", 0.03}, {"refreshes_per_period", 200}}, {{"sigma", 0.0}}}},
    {"/initial/tilt", {0.1, 0.10000001}},
    {"/block", {{{"width_m", 1.0}, {"height_m", 4.0}}, {{"width_m", 2.0}, {"height_m", 8.0}}}}};

/// A report of the grid; an amplitude has its other form, which depends on the block alone.
Report report_of(const std::vector<Entry>& grid, const std::string& line) {
  Json report = rocking::support::sample_report();
  Json& experiment = report["input"]["experiment"];
  experiment["sweep"] = Json::array();
  for (const Entry& entry : grid) {
    experiment["sweep"].push_back({{"parameter", entry.pointer}, {"values", entry.values}});
  }
  const Json model = report["result"]["conditions"][0];
  Json& conditions = report["result"]["conditions"] = Json::array();
  std::vector<std::vector<rocking::Parameter>> parameters;  // of which no experiment may be
  std::vector<std::size_t> place(grid.size(), 0);
  for (bool more = true; more;) {
    Json condition = model;
    condition["parameters"] = Json::object();
    parameters.emplace_back();
    bool is_last = false;
    for (std::size_t i = 0; i < grid.size(); ++i) {
      const Json& value = grid[i].values[place[i]];
      parameters.back().push_back({.pointer = grid[i].pointer, .value = rocking::swept_value(value)});
      if (grid[i].pointer != line) continue;
      is_last = place[i] + 1 == grid[i].values.size();
      if (line.starts_with("/excitation/amplitude")) {
        const double number = value;
        const bool in_g = line.ends_with("_g");
        condition["shaking"]["given"] = {in_g ? "amplitude_g" : "amplitude", "frequency_ratio"};
        condition["shaking"]["amplitude"] = in_g ? 4.0 * number : number;
        condition["shaking"]["amplitude_g"] = in_g ? number : 0.25 * number;
      }
    }
    condition["counts"]["(1,1)"] = is_last ? 9 : 30;
    condition["counts"]["(1,3)"] = is_last ? 20 : 0;
    condition["counts"]["overturned"] = is_last ? 1 : 0;
    for (const char* mode : {"(1,1)", "(1,3)", "overturned"}) {
      condition["probabilities"][mode]["estimate"] = condition["counts"][mode].get<double>() / 30.0;
    }
    conditions.push_back(std::move(condition));
    more = false;
    for (std::size_t i = grid.size(); i-- > 0 && !more;) {
      more = ++place[i] < grid[i].values.size();
      if (!more) place[i] = 0;
    }
  }
  Report read = report_in(std::move(report));
  for (const Entry& entry : grid) read.swept.emplace_back(entry.pointer);
  for (std::size_t i = 0; i < parameters.size(); ++i) read.conditions[i].asked.parameters = std::move(parameters[i]);
  return read;
}

std::size_t occurrences_of(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

void expect_sentences_along(const Line& line, const Report& report, std::size_t slices) {
  const auto name = [&](const char* value) { return line.before + std::string(value); };
  const std::string overturning = overturning_in_brief(report);
  EXPECT_EQ(occurrences_of("No overturning seen up to " + name(line.middle) + " (at most ", overturning), slices);
  EXPECT_EQ(occurrences_of("; seen at " + name(line.last) + "; most likely at " + name(line.last) + ": ", overturning),
            slices);
  const std::string responses = responses_in_brief(report);
  EXPECT_EQ(occurrences_of(name(line.first) + " to " + line.middle + ": rocks once in every period (1,1)", responses),
            slices);
  EXPECT_EQ(occurrences_of("; " + name(line.last) + ": rocks once in three periods (1,3)", responses), slices);
  EXPECT_EQ(occurrences_of("<li><b>", overturning), slices > 1 ? slices : 0);
}

/// Every order of these entries.
template <class Function>
void in_every_order(std::vector<Entry> grid, const Function& function) {
  std::vector<std::size_t> order(grid.size());
  std::iota(order.begin(), order.end(), 0U);
  do {
    std::vector<Entry> ordered;
    std::string trace;
    for (const std::size_t i : order) {
      ordered.push_back(grid[i]);
      trace += std::string(grid[i].pointer) + ' ';
    }
    SCOPED_TRACE(trace);
    function(ordered);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Sentences, NameTheParameterAlongWhichTheyGoWhateverTheOtherEntriesAre) {
  for (const Line& line : lines) {
    expect_sentences_along(line, report_of({line.entry}, line.entry.pointer), 1);
    for (std::size_t i = 0; i < others.size(); ++i) {
      const Entry& other = others[i];
      in_every_order({line.entry, other}, [&](const std::vector<Entry>& grid) {
        expect_sentences_along(line, report_of(grid, line.entry.pointer), 2);
      });
      for (const std::size_t place : {i + 1, i + 3}) {
        const Entry& third = others[place % others.size()];
        if (third.pointer == std::string(other.pointer)) continue;
        in_every_order({line.entry, other, third}, [&](const std::vector<Entry>& grid) {
          expect_sentences_along(line, report_of(grid, line.entry.pointer), 4);
        });
      }
    }
  }
}

TEST(Sentences, TellSlicesApartWhoseShortNamesAreEqual) {
  const Line& line = lines.front();
  const std::string text = overturning_in_brief(report_of({others[1], line.entry}, line.entry.pointer));
  EXPECT_THAT(
      text, AllOf(HasSubstr("<b>ground motion one_A_h.at2:</b>"), HasSubstr("<b>ground motion one_A_h.at2 (2):</b>")));
}

TEST(Sentences, SetSymbolsAndLeaveNamesOfFilesAlone) {
  EXPECT_EQ(with_symbols("base amplitude 1.1 g = A_h 4.5, <b> = Ω_h"),
            "base amplitude 1.1 g = <i>A<sub>h</sub></i> 4.5, &lt;b&gt; = <i>Ω<sub>h</sub></i>");
  EXPECT_EQ(with_symbols("ground motion A_h.at2  in my_A_h"), "ground motion A_h.at2  in my_A_h");
  EXPECT_EQ(with_symbols(""), "");
  // The amplitude is the only number with one value less than the frequency: it names the slices, in both forms.
  const Report report =
      report_of({{"/excitation/amplitude_g", {0.5, 0.75}}, {"/excitation/frequency_hz", {1.0, 2.0, 3.0}}},
                "/excitation/amplitude_g");
  for (const std::string& text : {overturning_in_brief(report), responses_in_brief(report), answer_in_brief(report)}) {
    EXPECT_THAT(text, AllOf(HasSubstr("base amplitude 0.5 g = <i>A<sub>h</sub></i> 2"), Not(HasSubstr("A_h"))));
  }
}

TEST(Sentences, CallTheSourceOfAFluctuationByItsName) {
  EXPECT_EQ(axis_of_parameter("/fluctuation/friction").quantity, "fluctuation of friction");
  EXPECT_EQ(axis_of_parameter("/friction").quantity, "friction");
  EXPECT_EQ(axis_of_parameter("/fluctuation/friction/sigma").quantity, "standard deviation of friction");
}

TEST(Sentences, CallAMomentByTheNumberThatIsDrawn) {
  EXPECT_EQ(axis_of_parameter("/friction/static/normal/mean").quantity, "mean of static friction");
  EXPECT_EQ(axis_of_parameter("/friction/static/lognormal/sigma").quantity, "standard deviation of static friction");
  EXPECT_EQ(axis_of_parameter("mean").quantity, "mean");
}

TEST(Sentences, CountTheConditionsThatShareTheLargestProbability) {
  Json report = rocking::support::sample_report();
  const Json probability = report["result"]["conditions"][1]["probabilities"]["overturned"];
  for (Json& condition : report["result"]["conditions"]) {
    condition["counts"]["overturned"] = 1;
    condition["probabilities"]["overturned"] = probability;
  }
  EXPECT_THAT(overturning_in_brief(report_in(report)),
              HasSubstr("; most likely in 3 conditions, first at <i>A<sub>h</sub></i> = 3"));
  Json& conditions = report["result"]["conditions"];
  for (int i = 0; i < 8; ++i) {
    conditions.push_back(conditions[1]);
    conditions.back()["parameters"]["/friction"] = {{"static", 0.5 + 0.01 * i}, {"kinetic", 0.4}};
  }
  EXPECT_THAT(overturning_in_brief(report_in(report)), HasSubstr("; most likely in 14 conditions, first at friction"));
}

TEST(Sentences, SummariseOverturningWhereTheSweepHasManyCombinations) {
  Json report = rocking::support::sample_report();
  Json& conditions = report["result"]["conditions"];
  const Json first = conditions[1];  // 1 of 30 realisations overturns
  for (int i = 0; i < 8; ++i) {
    conditions.push_back(first);
    conditions.back()["parameters"]["/friction"] = {{"static", 0.5 + 0.01 * i}, {"kinetic", 0.4}};
    conditions.back()["parameters"]["/excitation/amplitude"] = 3.5 + 0.1 * i;
  }
  EXPECT_THAT(overturning_in_brief(report_in(report)),
              AllOf(StartsWith("<p>Seen in 13 of 14 conditions; the least base amplitude is at friction 0.4/0.35, base "
                               "amplitude 3 = 0.735 g; most likely at friction 0.4/0.35, base amplitude 5.5 = 1.35 g: "
                               "<strong>16.7 % [")));
}

TEST(Sentences, SpeakOfResponsesInWords) {
  using rocking::section::periodic;
  EXPECT_EQ(rocking::meaning_of(periodic(1, 1)), "rocks once in every period");
  EXPECT_EQ(rocking::meaning_of(periodic(2, 3)), "rocks twice in three periods");
  EXPECT_EQ(rocking::meaning_of(periodic(3, 14)), "rocks three times in 14 periods");
}

TEST(Sentences, SetSymbolsLow) {
  EXPECT_EQ(symbol_html("A_h"), "<i>A<sub>h</sub></i>");
  EXPECT_EQ(symbol_html("a_s/b_k<"), "<i>a<sub>s</sub>/b<sub>k</sub>&lt;</i>");
}

}  // namespace
