// The page report.html as text: what it may load and run, its content, and its omissions.

#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "analysis/draw.hpp"
#include "analysis/page/animation.hpp"
#include "analysis/page/html.hpp"
#include "analysis/page/page.hpp"
#include "analysis/page/sections.hpp"
#include "analysis/page/tables.hpp"
#include "analysis/run_figures.hpp"
#include "cli/program.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/output/report.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/number_text.hpp"

namespace {

using rocking::Finding;
using rocking::Json;
using rocking::Rating;
using rocking::Report;
using rocking::report_in;
using rocking::support::quick_experiment;
using ::testing::AllOf;
using ::testing::Each;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;
using ::testing::StartsWith;
using namespace rocking::analysis;

const char* hostile = "</title></script><script>alert(1)</script><img src=x onerror=alert(2)> \"&'";

Json report_of(const Json& question) {
  const auto experiment = rocking::experiment_in(question.dump(), {}, {});
  const auto result = rocking::run(experiment, {.threads = 1, .on_progress = {}, .stop_requested = nullptr});
  return Json::parse(
      rocking::report_text(experiment, result.value(), {.build = {}, .machine = "m", .start = "2012-02-01T12:00:00Z"}));
}

/// One report for all tests: three conditions, four realisations each.
const Json& quick_report() {
  static const Json report = report_of(quick_experiment());
  return report;
}

std::string page_of(const Json& json, const std::string& svg = "<svg xmlns=\"http://www.w3.org/2000/svg\"/>") {
  const Report report = report_in(json);
  std::vector<DrawnFigure> drawn;
  for (const Figure& figure : run_figures(report)) drawn.push_back({figure, svg});
  return page_text(report, drawn);
}

Json changed(const char* pointer, const Json& value) {
  Json report = quick_report();
  report[Json::json_pointer(pointer)] = value;
  return report;
}

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match) {
    found.push_back(match->str(1));
  }
  return found;
}

/// The texts between two marks, for each occurrence.
std::vector<std::string> between(const std::string& text, const std::string& open, const std::string& close) {
  std::vector<std::string> found;
  for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
    at += open.size();
    found.push_back(text.substr(at, text.find(close, at) - at));
  }
  return found;
}

/// Tests that the policy of a page has the hashes of its scripts and styles, and no others.
void expect_hashes_of_all(const std::string& page) {
  std::set<std::string> expected;
  for (const std::string& text : between(page, "<script>", "</script>")) expected.insert(policy_hash(text));
  for (const std::string& text : between(page, "<style>", "</style>")) expected.insert(policy_hash(text));
  const auto policies = between(page, "<meta http-equiv=\"Content-Security-Policy\" content=\"", "\"");
  ASSERT_THAT(policies, SizeIs(1));
  const auto hashes = matches(policies[0], "('sha256-[^']*')");
  EXPECT_EQ(std::set<std::string>(hashes.begin(), hashes.end()), expected);
  EXPECT_GE(hashes.size(), 2U);
}

/// A page without its scripts and styles.
std::string markup_of(std::string page) {
  for (const std::string tag : {"script", "style"}) {
    for (std::size_t at = page.find('<' + tag); at != std::string::npos; at = page.find('<' + tag, at)) {
      const std::string end = "</" + tag + '>';
      page.erase(at, page.find(end, at) + end.size() - at);
    }
  }
  return page;
}

Finding check_named(const Json& report, const std::string& name) {
  for (const Finding& each : findings_of(report_in(report))) {
    if (each.name == name) return each;
  }
  ADD_FAILURE() << name;
  return {};
}

TEST(Page, RunsNothingOfWhatAnExperimentIsCalled) {
  Json question = quick_experiment();
  question["title"] = hostile;
  const std::string page = page_of(report_of(question));
  EXPECT_THAT(
      page, AllOf(Not(HasSubstr("<script>alert")), Not(HasSubstr("<img src=x")), Not(HasSubstr("</title></script>"))));
  EXPECT_THAT(page, HasSubstr("&lt;/title&gt;&lt;/script&gt;&lt;script&gt;alert(1)&lt;/script&gt;"));
}

TEST(Page, HasAPolicyThatKnowsItsScriptsAndStyleByTheirHashesAndNothingElse) {
  const std::string page = page_of(quick_report());
  const auto policies = between(page, "<meta http-equiv=\"Content-Security-Policy\" content=\"", "\"");
  ASSERT_THAT(policies, SizeIs(1));
  EXPECT_THAT(policies[0],
              AllOf(StartsWith("default-src 'none'; "), Not(HasSubstr("unsafe")), HasSubstr("img-src data:;")));
  expect_hashes_of_all(page);
}

TEST(Page, HashesAsPublished) {
  EXPECT_EQ(policy_hash("alert('Hello, world.');"), "'sha256-qznLcsROx4GACP2dm0UCKCzCG+HiZ1guq6ZZDob/Tng='");
}

TEST(Page, LoadsNothingAndNeedsNothingThatItsPolicyForbids) {
  const std::string markup = markup_of(page_of(quick_report()));
  EXPECT_THAT(matches(markup, R"re((?:src|href|action|data|poster)="([^"]*)")re"),
              Each(::testing::ContainsRegex("^(#|data:)")));
  EXPECT_THAT(matches(markup, R"((<[^>]*\s(?:style|on[a-z]+)=[^>]*>))"), IsEmpty());
  EXPECT_THAT(matches(markup, "(<(?:iframe|object|embed|base|form|link rel=\"stylesheet\"))"), IsEmpty());
}

TEST(Page, HoldsNumbersForItsChartsThatEndNoScript) {
  Json report = quick_report();
  EXPECT_EQ(json_for_script({{"a", "</script><!--"}}), "{\"a\":\"\\u003c/script>\\u003c!--\"}");
  EXPECT_EQ(json_for_script({{"a", "b\u202ec"}}), R"({"a":"b\\u202ec"})");
  EXPECT_EQ(escaped("a<\u202eb\u061c"), "a&lt;\\u202eb\\u061c");
  EXPECT_THAT(between(page_of(report), "<script type=\"application/json\"", "</script>"), Not(IsEmpty()));
}

TEST(Page, LeadsNowhereThatItHasNot) {
  Json lone = quick_experiment();
  lone.erase("fluctuation");
  for (const Json& report : {quick_report(), report_of(lone)}) {
    const std::string markup = markup_of(page_of(report));
    const auto places = matches(markup, "id=\"([^\"]+)\"");
    for (const std::string& target : matches(markup, "href=\"#([^\"]+)\""))
      EXPECT_THAT(places, ::testing::Contains(target));
    EXPECT_EQ(std::set<std::string>(places.begin(), places.end()).size(), places.size()) << "a name stands twice";
  }
}

TEST(Page, SaysWhatTheReportSays) {
  const std::string page = page_of(quick_report());
  const Json& condition = quick_report()["result"]["conditions"][2];
  for (const auto& [mode, probability] : condition["probabilities"].items()) {
    if (condition["counts"][mode] == 0) continue;
    EXPECT_THAT(page, HasSubstr(rocking::per_cent(probability["estimate"]) + " <span class=\"interval\">[" +
                                rocking::per_cent(probability["simultaneous"][0]) + ", " +
                                rocking::per_cent(probability["simultaneous"][1])));
  }
  for (const char* pointer : {"/result/digest", "/input/sha256", "/input/experiment/seed"}) {
    EXPECT_THAT(page, HasSubstr(quick_report()[Json::json_pointer(pointer)].get<std::string>()));
  }
  EXPECT_THAT(page,
              AllOf(HasSubstr("A block 1 m wide and 4 m high"), HasSubstr("3 conditions, 12 realisations in all")));
}

TEST(Page, SaysWhatItLeavesOut) {
  Json report = quick_report();
  const Json condition = report["result"]["conditions"][0];
  for (std::size_t i = 0; i < most_rows; ++i) {
    report["result"]["conditions"].push_back(condition);
    report["result"]["conditions"].back()["parameters"]["/excitation/amplitude"] = 7.0 + static_cast<double>(i);
  }
  EXPECT_THAT(page_of(report), HasSubstr("The first 2000 of 2003 rows."));
  EXPECT_THAT(markup_of(page_of(quick_report())), Not(HasSubstr("class=\"limit\"")));
}

TEST(Page, SaysThatItHasNoPictures) {
  EXPECT_THAT(page_of(quick_report(), ""), HasSubstr("no picture for printing"));
  EXPECT_THAT(page_of(quick_report()),
              AllOf(Not(HasSubstr("no picture for printing")), HasSubstr("data:image/svg+xml;base64,")));
}

TEST(Page, HasPicturesThatCutNoWordOff) {
  for (const Figure& figure : run_figures(report_in(quick_report()))) {
    Drawing drawing;
    const std::string svg = picture_of(figure, "svg", drawing);
    if (!drawing.is_drawn()) GTEST_SKIP() << "skipped: " << drawing.reason;
    const double height = std::stod(matches(svg, "viewBox=\"0 0 [0-9.]+ ([0-9.]+)\"").at(0));
    const auto baselines = matches(svg, R"re(transform="translate\([0-9.]+,([0-9.]+)\)[^"]*"[^>]*font-family)re");
    EXPECT_GT(baselines.size(), 2U) << figure.name;
    for (const std::string& baseline : baselines) EXPECT_LT(std::stod(baseline) + 6.0, height) << figure.name;
  }
}

TEST(Page, IsMadeWhereNothingIsSweptOrRandom) {
  Json question = quick_experiment();
  question.erase("sweep");
  question.erase("fluctuation");
  question.erase("friction");
  EXPECT_THAT(page_of(report_of(question)),
              AllOf(HasSubstr("It cannot slide. Nothing is random."),
                    HasSubstr("the same shaking gives the same response"), HasSubstr("The block does not overturn.")));
}

TEST(Page, ChecksWhatCouldMakeAResultUntrue) {
  EXPECT_EQ(check_named(quick_report(), "contact with the base").rating, Rating::fine);
  Json left = changed("/result/conditions/1/validity/left_ground", 3);
  Json& validity = left["result"]["conditions"][1]["validity"];
  validity["first_realisations"]["left_ground"] = {1, 3, 4};
  EXPECT_EQ(check_named(left, "contact with the base").rating, Rating::fine) << "in the final fall only";
  EXPECT_THAT(check_named(left, "contact with the base").text, StartsWith("3 realisations lost contact only in the"));
  validity["left_ground_before_fall"] = 2;
  validity["first_realisations"]["left_ground_before_fall"] = {3, 4};
  const Finding check = check_named(left, "contact with the base");
  EXPECT_EQ(check.rating, Rating::look);
  EXPECT_THAT(check.text, StartsWith("2 realisations lost contact with the base (normal force"));
  EXPECT_THAT(check.place, HasSubstr("--condition 1 --realisation 3"));
}

TEST(Page, TellsTheSensitivityToToleranceAsTheReportDoes) {
  const Json floor = {
      {"flips", 3}, {"of", 40}, {"interval", {0.01, 0.2}}, {"half_width", 0.05}, {"arithmetic_noise", "small"}};
  Json report = changed("/result/tolerance_sensitivity", floor);
  EXPECT_EQ(check_named(report, "sensitivity to tolerance").rating, Rating::fine);
  report["result"]["tolerance_sensitivity"]["arithmetic_noise"] = "undecided";
  EXPECT_EQ(check_named(report, "sensitivity to tolerance").rating, Rating::note);
  report["result"]["tolerance_sensitivity"]["arithmetic_noise"] = "not_small";
  EXPECT_EQ(check_named(report, "sensitivity to tolerance").rating, Rating::look);
  EXPECT_THAT(in_words(check_named(report, "sensitivity to tolerance")),
              AllOf(HasSubstr("3 of 40 response modes"), HasSubstr("set /accuracy/tolerance to")));
  EXPECT_EQ(check_named(changed("/result/tolerance_sensitivity", nullptr), "sensitivity to tolerance").rating,
            Rating::note);
}

TEST(Page, AsksForALookWhereMoreThanOnePerCentOfADistributionIsClamped) {
  Json report = quick_report();
  for (Json& condition : report["result"]["conditions"]) {
    condition["validity"]["clamped"] = 0;
    for (auto& [kind, count] : condition["validity"]["clamped_draws"].items()) count = 0;
  }
  Json& condition = report["result"]["conditions"][1];
  Json& validity = condition["validity"];
  condition["realisations"] = 1000;
  validity["clamped"] = 10;
  validity["first_realisations"]["clamped"] = {3};
  for (auto& [source, count] : report["internal"]["conditions"][1]["draws"].items()) count = 0;
  report["internal"]["conditions"][1]["draws"]["kinetic_friction"] = 100'000;
  validity["clamped_draws"]["kinetic_friction_at_static"] = 1000;
  EXPECT_EQ(check_named(report, "clamped random numbers").rating, Rating::note) << "1 % of both";
  validity["clamped_draws"]["kinetic_friction_at_static"] = 1001;
  const Finding check = check_named(report, "clamped random numbers");
  EXPECT_EQ(check.rating, Rating::look);
  EXPECT_THAT(check.remedy, HasSubstr("reduce the sigma of the friction"));
  validity["clamped_draws"]["kinetic_friction_at_static"] = 10;
  validity["clamped"] = 11;
  EXPECT_EQ(check_named(report, "clamped random numbers").rating, Rating::look) << "1.1 % of the realisations";
}

TEST(Page, AsksForALookWhereRealisationsRanOut) {
  EXPECT_EQ(check_named(quick_report(), "enough realisations").rating, Rating::fine);
  EXPECT_EQ(
      check_named(changed("/result/conditions/0/stopped_because", "at_most_reached"), "enough realisations").rating,
      Rating::look);
}

/// The bound of the probability of overturning in a condition.
std::string bound_of(const Json& report, std::size_t condition) {
  const Json& high = report["result"]["conditions"][condition]["probabilities"]["overturned"]["simultaneous"][1];
  return rocking::per_cent(high.get<double>());
}

TEST(Page, TellsUpToWhereNothingOverturns) {
  EXPECT_EQ(overturning_in_brief(report_in(quick_report())),
            "<p>No overturning seen up to <i>A<sub>h</sub></i> = 6 (at most " + bound_of(quick_report(), 2) +
                " % there, 95 %).</p>\n");
}

TEST(Page, TellsWhereOverturningIsMostLikely) {
  Json report = changed("/result/conditions/1/counts/overturned", 3);
  report["result"]["conditions"][1]["probabilities"]["overturned"]["estimate"] = 0.75;
  EXPECT_THAT(overturning_in_brief(report_in(report)),
              AllOf(StartsWith("<p>No overturning seen up to <i>A<sub>h</sub></i> = 3 (at most " + bound_of(report, 0) +
                               " % there, 95 %); seen at <i>A<sub>h</sub></i> = 4.2;"),
                    HasSubstr("most likely at <i>A<sub>h</sub></i> = 4.2: <strong>75.0 % [")));
}

TEST(Page, BoundsInItsTableWhatDidNotOccur) {
  Json report = changed("/result/conditions/1/counts/overturned", 3);
  EXPECT_THAT(mode_table_html(report_in(report)),
              HasSubstr("<td data-value=\"0\"><span class=\"none\">&lt; " + bound_of(report, 0) + "</span></td>"));
}

TEST(Page, ShowsNoIntervalWhereNothingIsRandom) {
  Json question = quick_experiment();
  question.erase("fluctuation");
  const Json json = report_of(question);
  const Report report = report_in(json);
  EXPECT_FALSE(report.is_random());
  for (const std::string& text :
       {mode_table_html(report), answer_in_brief(report), trust_in_full(findings_of(report))}) {
    EXPECT_THAT(matches(text, R"((\[[0-9.]+, [0-9.]+))"), IsEmpty()) << text;
    EXPECT_THAT(text, Not(HasSubstr("&lt; "))) << text;
  }
  question["sweep"] = {{{"parameter", "/fluctuation/friction/sigma"}, {"values", {0.0, 0.02}}}};
  question["fluctuation"] = {{"friction", {{"sigma", 0.0}}}};
  const Report both = report_in(report_of(question));
  EXPECT_FALSE(both.conditions[0].result.is_random());
  EXPECT_TRUE(both.conditions[1].result.is_random());
  EXPECT_THAT(mode_table_html(both), AllOf(HasSubstr("<td>100.0</td>"), HasSubstr("class=\"interval\"")));
}

TEST(Page, TellsTheResponseAlongTheSweep) {
  Json report = quick_report();
  for (std::size_t i = 0; i < 3; ++i) {
    Json& condition = report["result"]["conditions"][i];
    for (auto& [mode, count] : condition["counts"].items()) count = 0;
    for (auto& [mode, probability] : condition["probabilities"].items()) probability["estimate"] = 0.0;
    const char* mode = i < 2 ? "(1,1)" : "(1,3)";
    condition["counts"][mode] = 4 - i;
    condition["probabilities"][mode]["estimate"] = 1.0 - 0.25 * static_cast<double>(i);
  }
  EXPECT_THAT(responses_in_brief(report_in(report)),
              AllOf(HasSubstr("<i>A<sub>h</sub></i> = 3 to 4.2: rocks once in every period (1,1), 75.0 to 100.0 %; "
                              "<i>A<sub>h</sub></i> = 6: rocks once in three periods (1,3), 50.0 % [")));
}

TEST(Page, TellsWhatIsNotModelled) {
  EXPECT_THAT(page_of(quick_report()),
              AllOf(HasSubstr("<h2 id=\"heading-limits\">What is not modelled</h2>"), HasSubstr("Two dimensions"),
                    HasSubstr("No flight"), HasSubstr("Housner, G. W. (1963)")));
}

/// The words of a text, without markup.
std::string words_of(std::string text) {
  text = std::regex_replace(text, std::regex("<[^>]*>|[`*]"), "");
  text = std::regex_replace(text, std::regex("&amp;"), "&");
  return std::regex_replace(text, std::regex("\\s+"), " ");
}

TEST(Page, TellsAboutItsLimitsWhatTheDocumentsTell) {
  const std::string document =
      words_of(rocking::read_file(std::filesystem::path(ROCKING_SOURCE_DIR) / "lib/docs/limits.md"));
  std::size_t compared = 0;
  for (const char* tag : {"dt", "dd", "li"}) {
    for (const std::string& text : between(limits_html(), "<" + std::string(tag) + ">", "</" + std::string(tag))) {
      EXPECT_THAT(document, HasSubstr(words_of(text)));
      ++compared;
    }
  }
  EXPECT_EQ(compared, 8U + 8U + 10U);
}

Animation made_up_motion() {
  Animation motion{.name = "(1,1): <script>",
                   .command = "rocking trajectory a.json",
                   .block = {.rectangles = {{0.0, 1.0, 0.0, 3.0}}, .base = 1.0, .centre_x = 0.25, .is_given = false},
                   .shape_angles = {0.2, 0.5}};
  for (int i = 0; i <= 4; ++i) {
    motion.samples.push_back({.time = 0.1 * i, .tilt = 0.01 * i, .slip = 1e-7, .contact = i < 2 ? "rock" : "slide"});
  }
  motion.length = 0.8;
  return motion;
}

TEST(Page, AnimatesMotionsUnderTheSamePolicy) {
  const ShownAnimations shown{.explanation = "Some <motion>.", .motions = {made_up_motion()}};
  const std::string page = page_text(report_in(quick_report()), {}, shown);
  EXPECT_THAT(page, AllOf(HasSubstr("<p>Some &lt;motion&gt;.</p>"), HasSubstr("data-motions=\"motions\""),
                          HasSubstr("(1,1): &lt;script&gt;: tilt against time, 0 to 0.4 of 0.8 seconds")));
  const auto data = between(page, "id=\"data-motions\">", "</script>");
  ASSERT_THAT(data, SizeIs(1));
  const Json motion = Json::parse(data[0])[0];
  EXPECT_EQ(motion["contacts"], Json({2, 2, 1, 1, 1}));
  EXPECT_EQ(motion["tilts"][3], 0.03);
  EXPECT_EQ(motion["slips"][0], 0.0);
  EXPECT_EQ(motion["rectangles"], Json({{0.0, 1.0, 0.0, 3.0}}));
  EXPECT_EQ(motion["centre"][0], 0.25);
  EXPECT_EQ(motion["shapes"], Json({0.2, 0.5}));
  EXPECT_THAT(page, AllOf(HasSubstr("tilt over &psi; of the side"), HasSubstr("outline of the block is not known")));
  for (const std::string& each : {page, animation_page_text("t", made_up_motion())}) expect_hashes_of_all(each);
}

TEST(Page, SaysWhyItShowsNoMotion) {
  EXPECT_THAT(page_text(report_in(quick_report()), {}, {.explanation = "No realisation is shown.", .motions = {}}),
              HasSubstr("<p>No realisation is shown.</p>"));
  EXPECT_THAT(page_of(quick_report()), Not(HasSubstr("See it move")));
}

}  // namespace
