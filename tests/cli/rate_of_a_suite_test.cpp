// `rocking fragility --hazard` of a suite: rates in several ways, levels to add, options, the sheet, hazard curves.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include <gmock/gmock.h>

#include "cli/five_sines.hpp"
#include "rocking/text/number_text.hpp"

namespace {

using rocking::Json;
using rocking::support::FiveSines;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class RateOfASuite : public FiveSines {};

double sum_of(const Json& list, const char* key, const auto& belongs) {
  double sum = 0.0;
  for (const Json& each : list) {
    if (belongs(each)) sum += each.at(key).get<double>();
  }
  return sum;
}

/// Phi((ln x - ln median)/dispersion) times |dH|, between two intensities, by the midpoint rule in ln x; not over a kink.
double rate_between(double median, double dispersion, double from, double to) {
  constexpr double kink = 0.5;
  if (from < kink && kink < to) {
    return rate_between(median, dispersion, from, kink) + rate_between(median, dispersion, kink, to);
  }
  // The hazard file of SuiteFragility: from, rate there, exponent.
  const std::array<std::array<double, 3>, 2> pieces{
      {{0.1, 1e-2, std::log(1e-1) / std::log(5.0)}, {0.5, 1e-3, std::log(1e-2) / std::log(4.0)}}};
  constexpr int steps = 40000;
  const double step = std::log(to / from) / steps;
  double rate = 0.0;
  for (int k = 0; k < steps; ++k) {
    const double x = from * std::exp((k + 0.5) * step);
    const auto& [begin, rate_there, exponent] = pieces[x < kink ? 0 : 1];
    const double p = 0.5 * std::erfc(-std::log(x / median) / dispersion / std::numbers::sqrt2);
    rate += p * rate_there * std::pow(x / begin, exponent) * -exponent * step;
  }
  return rate;
}

// The block lifts at tan(psi) = 0.35/1.6 = 0.21875 g under every record.
TEST_F(RateOfASuite, GivesTheAnnualRateOfAHazardCurveAboveTheLeastUplift) {
  run();
  const Json curve = fragility("--hazard hazard.csv")["curves"][0];
  constexpr double uplift = 0.21875;
  EXPECT_NEAR(curve["least_uplift"].get<double>(), uplift, 1e-12);
  const double median = curve["pooled"]["median"]["value"];
  const double dispersion = curve["pooled"]["dispersion"]["value"];
  const Json& found = curve["annual_rate"];
  const double by_law = rate_between(median, dispersion, uplift, 200.0);
  EXPECT_EQ(found["estimates"][0]["from"], "law");
  EXPECT_NEAR(found["estimates"][0]["value"].get<double>(), by_law, 1e-6 * by_law);
  // The law is rejected, so that the value is that of the isotonic shares.
  EXPECT_EQ(found["from"], "isotonic");
  const double rate = found["estimates"][1]["value"];
  EXPECT_NEAR(found["value"].get<double>(), rate, 1e-12 * rate);
  EXPECT_NEAR(found["impossible"].get<double>(), rate_between(median, dispersion, 0.1, uplift), 1e-6 * rate);
  EXPECT_LT(found["interval"][0], found["value"]);
  EXPECT_GT(found["interval"][1], found["value"]);
  const auto all = [](const Json&) { return true; };
  EXPECT_NEAR(sum_of(found["by_level"], "rate", all), rate, 1e-6 * rate);
  EXPECT_NEAR(sum_of(found["by_level"], "share", all), 1.0, 1e-9);
  EXPECT_NEAR(sum_of(found["by_level"], "share", [](const Json& range) { return !range["tested"]; }),
              found["untested_share"].get<double>(), 1e-12);
  // From the least uplift to 0.3 g, five ranges between the levels that lift the block, and one above.
  EXPECT_EQ(found["by_level"].size(), 7U);
  EXPECT_FALSE(found["by_level"][0]["tested"]);
  EXPECT_EQ(found["by_level"][0]["to"], 0.3);
  EXPECT_TRUE(found["by_level"][1]["tested"]);
  // The hazard ends at 2 g, with 1e-5 a year; every realisation overturns beyond 1 g.
  EXPECT_NEAR(found["extrapolated_hazard"].get<double>(), 1e-5 / rate, 1e-12);
  EXPECT_NEAR(found["within_hazard"].get<double>(), rate - 1e-5, 1e-12 * rate);
  const auto told = rocking("fragility out --hazard hazard.csv");
  EXPECT_THAT(
      told.output,
      AllOf(HasSubstr("The block overturns about once in "), HasSubstr(" years: mean annual rate "),
            HasSubstr("% of the rate comes from intensities outside the levels"),
            HasSubstr("counted from PGA = 0.219 g on, the least that lifts the block\n"),
            HasSubstr(" per year that the rejected law gives below, where"),
            HasSubstr("1.0 % of the rate comes from beyond the last point of the hazard curve; "
                      "without it: " +
                      rocking::rate_text(rate - 1e-5)),
            HasSubstr("rejected law  "), HasSubstr("hazard: annual rates of pga_g at 3 points from 0.1 to 2\n")));
  EXPECT_THAT(told.output, Not(HasSubstr("warning: 1.0 %")));
}

TEST_F(RateOfASuite, ReadsProbabilitiesInATimeAndRefusesThemWithout) {
  run();
  const auto poe = [](double rate) { return Json(-std::expm1(-50.0 * rate)).dump(); };
  const std::string lines = "0.1, " + poe(1e-2) + "\n0.5, " + poe(1e-3) + "\n2, " + poe(1e-5) + "\n";
  write("poe.csv", "PGA, poe\n" + lines);
  write("bare.csv", lines);
  const double rate = fragility("--hazard hazard.csv")["curves"][0]["annual_rate"]["value"];
  for (const char* flags : {"--hazard poe.csv --years 50", "--years 50 --hazard bare.csv --imt pga_g"}) {
    EXPECT_NEAR(fragility(flags)["curves"][0]["annual_rate"]["value"].get<double>(), rate, 1e-10 * rate) << flags;
  }
  EXPECT_THAT(rocking("fragility out --hazard poe.csv --years 50").output,
              HasSubstr("hazard: probabilities of exceedance in 50 years of pga_g at 3 points"));
  for (const auto& [flags, what] :
       {std::pair{"--hazard poe.csv", "--years 50"}, std::pair{"--hazard poe.csv --years 1,50", "poe[50]"},
        std::pair{"--hazard bare.csv --years 50", "--imt pga_g"}, std::pair{"--hazard bare.csv", "--imt pga_g"},
        std::pair{"--hazard hazard.csv --imt PGV", "omit --imt"}}) {
    const auto refused = rocking(std::string("fragility out ") + flags);
    EXPECT_EQ(refused.exit_code, 65) << flags;
    EXPECT_THAT(refused.errors, HasSubstr(what)) << flags;
  }
  EXPECT_EQ(rocking("fragility out --years 50").exit_code, 64);
  // A file that does without them leaves the years to what is asked.
  write("stated.csv", "PGA, poe[50]\n" + lines);
  for (const char* file : {"hazard.csv", "stated.csv"}) {
    const Json found = fragility(std::string("--hazard ") + file + " --years 1,475")["curves"][0]["annual_rate"];
    EXPECT_NEAR(found["value"].get<double>(), rate, 1e-10 * rate) << file;
    EXPECT_NEAR(found["in_years"][1]["probability"].get<double>(), -std::expm1(-475.0 * rate), 1e-9 * rate) << file;
  }
  EXPECT_EQ(rocking("fragility out --hazard poe.csv --years soon").exit_code, 64);
  // As of another command, and on the sheet, which says how to make it again.
  ASSERT_EQ(rocking("report out --format html --hazard poe.csv --years 50").exit_code, 0);
  EXPECT_THAT(read("out/report.html"), HasSubstr("of the rate comes from beyond the last point of the hazard curve"));
  ASSERT_EQ(rocking("fragility out --years 50 --hazard bare.csv --imt PGA --sheet sheet.html").exit_code, 0);
  EXPECT_THAT(read("sheet.html"),
              AllOf(HasSubstr("bare.csv: probabilities of exceedance in 50 years of pga_g at 3 points from 0.1 to 2."),
                    HasSubstr("--years 50 --hazard bare.csv --imt ")));
}

// With one option and with two, whose table is one row each.
TEST_F(RateOfASuite, WarnsOfHazardThatIsContinued) {
  Json wider = experiment();
  wider["sweep"].push_back({{"parameter", "/block/width_m"}, {"values", {0.35, 0.5}}});
  write("e.json", wider.dump());
  run();
  write("short.csv", "pga_g, annual_rate\n0.1, 1e-2\n0.21, 2e-3\n");
  const Json curves = fragility("--hazard short.csv")["curves"];
  const auto told = rocking("fragility out --hazard short.csv --sheet sheet.html");
  const std::string words = "100.0 % of the rate comes from beyond the last point of the hazard curve";
  for (const Json& curve : curves) {
    EXPECT_DOUBLE_EQ(curve["annual_rate"]["extrapolated_hazard"].get<double>(), 1.0);
    EXPECT_EQ(curve["annual_rate"]["within_hazard"], 0.0);
  }
  for (const char* option : {"width_m 0.35: ", "width_m 0.5: "}) {
    EXPECT_THAT(told.output, HasSubstr(option + std::string("warning: ") + words + "; without it: 0 per year"));
  }
  EXPECT_THAT(read("sheet.html"), HasSubstr("class=\"warning\">From beyond the last point of the hazard curve: 100.0 % "
                                            "of the rate.</p>"));
  EXPECT_THAT(rocking("fragility out --all --hazard short.csv").output, HasSubstr("warning: " + words));
}

// Below the least uplift nothing is known of stronger shaking: the rate is that of all of it at most.
TEST_F(RateOfASuite, BoundsTheAnnualRateOfASuiteWithoutALaw) {
  Json calm = experiment();
  calm["sweep"][0]["values"] = {0.01, 0.02};
  write("e.json", calm.dump());
  run();
  const Json rate = fragility("--hazard hazard.csv")["curves"][0]["annual_rate"];
  EXPECT_EQ(rate["value"], 0.0);
  EXPECT_EQ(rate["from"], "isotonic");
  const double above = 1e-2 * std::pow(0.21875 / 0.1, std::log(0.1) / std::log(5.0));
  EXPECT_NEAR(rate["at_most"].get<double>(), above, 1e-9 * above);
  EXPECT_FALSE(fragility()["curves"][0].contains("annual_rate"));
}

TEST_F(RateOfASuite, SaysWhatTheLevelsLeaveOpenAndAddsLevels) {
  Json few = experiment();
  few["sweep"][0]["values"] = {0.3, 0.65};
  write("e.json", few.dump());
  run();
  const Json rate = fragility("--hazard hazard.csv")["curves"][0]["annual_rate"];
  ASSERT_GT(rate["undecided_share"], 0.05);
  std::string levels;
  for (const Json& level : rate["add_levels"]) levels += (levels.empty() ? "" : ",") + level.dump();
  EXPECT_THAT(rocking("fragility out --hazard hazard.csv").output,
              AllOf(HasSubstr("% of the rate undecided; add " + levels), HasSubstr("records contribute")));
  const auto suggested = rocking("fragility out --hazard hazard.csv --suggest");
  EXPECT_EQ(suggested.output, "rocking resume out --levels " + levels + "\n");
  EXPECT_EQ(rocking("fragility out --suggest").exit_code, 64);
  ASSERT_EQ(shell("cp -r out \"it's out\"").exit_code, 0);
  EXPECT_EQ(rocking("fragility \"it's out\" --hazard hazard.csv --suggest").output,
            "rocking resume 'it'\\''s out' --levels " + levels + "\n")
      << "as a shell takes it";
  const auto more = rocking("resume out -q --no-page --levels " + levels);
  ASSERT_EQ(more.exit_code, 0) << more.errors;
  // The bytes are those of one run with these levels, in which nothing was run twice.
  few["sweep"][0]["values"] = {0.3, 0.65};
  for (const Json& level : rate["add_levels"]) few["sweep"][0]["values"].push_back(level);
  std::sort(few["sweep"][0]["values"].begin(), few["sweep"][0]["values"].end());
  write("whole.json", few.dump());
  ASSERT_EQ(rocking("run whole.json -q --no-page -o whole").exit_code, 0);
  EXPECT_EQ(Json::parse(read("out/report.json"))["result"], Json::parse(read("whole/report.json"))["result"]);
  const auto twice = rocking("resume out --levels 0.65");
  EXPECT_EQ(twice.exit_code, 64);
  EXPECT_THAT(twice.errors, AllOf(HasSubstr("--levels"), HasSubstr("0.65"), HasSubstr("is a level of the run")));
  EXPECT_EQ(rocking("resume out --levels -1").exit_code, 64);
  EXPECT_EQ(rocking("verify out").exit_code, 0) << "a refused extension changes nothing";
}

TEST_F(RateOfASuite, SweepsASpectralAccelerationAndTakesItsHazard) {
  Json spectral = experiment();
  spectral["excitation"]["period_s"] = 0.5;
  spectral["sweep"][0] = {{"parameter", "/excitation/sa_g"}, {"values", {0.4, 0.7, 1.0, 1.5}}};
  write("e.json", spectral.dump());
  run();
  for (const char* name : {"SA(0.50)", "sa_g[0.5]"}) {
    write("hazard.csv", std::string(name) + ", annual_rate\n0.1, 1e-2\n0.5, 1e-3\n5, 1e-5\n");
    EXPECT_GT(fragility("--hazard hazard.csv")["curves"][0]["annual_rate"]["value"], 0.0) << name;
  }
  for (const char* name : {"sa_g[1]", "avgsa_g", "pga_g"}) {
    write("other.csv", std::string(name) + ", annual_rate\n0.1, 1e-2\n0.5, 1e-3\n");
    const auto other = rocking("fragility out --hazard other.csv");
    EXPECT_EQ(other.exit_code, 65) << name;
    EXPECT_THAT(other.errors, HasSubstr("which is sa_g[0.5]")) << name;
  }
  const auto made = rocking("fragility out --hazard hazard.csv --sheet sheet.html");
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  EXPECT_THAT(read("sheet.html"), AllOf(HasSubstr("annual rates of sa_g[0.5] at 3 points"),
                                        HasSubstr("The spectral acceleration is that at T = 0.5 s.")));
  write("other.csv", "sa_g, annual_rate\n0.1, 1e-2\n0.5, 1e-3\n");
  const auto nowhere = rocking("fragility out --hazard other.csv");
  EXPECT_EQ(nowhere.exit_code, 65);
  EXPECT_THAT(nowhere.errors, AllOf(HasSubstr("does not state its period"), HasSubstr("sa_g[0.5], annual_rate")));
  // A curve of one spectral acceleration does not fit a sweep of its period.
  spectral["sweep"].push_back({{"parameter", "/excitation/period_s"}, {"values", {0.5, 1.0}}});
  write("periods.json", spectral.dump());
  ASSERT_EQ(rocking("run periods.json -q --no-page -o periods").exit_code, 0);
  const auto periods = rocking("fragility periods --hazard hazard.csv");
  EXPECT_EQ(periods.exit_code, 65);
  EXPECT_THAT(periods.errors, HasSubstr("the sweep changes its period"));
  // The measure of the sweep has the law of the suite.
  const Json curve = fragility()["curves"][0];
  for (const Json& measure : curve["measures"]) {
    if (measure["measure"] != "sa_g") continue;
    EXPECT_NEAR(measure["median"].get<double>(), curve["pooled"]["median"]["value"].get<double>(), 1e-6);
  }
}

TEST_F(RateOfASuite, RanksTheAbsoluteAccelerationOnlyWhereItIsSwept) {
  Json absolute = experiment();
  absolute["excitation"]["period_s"] = 0.5;
  absolute["sweep"][0] = {{"parameter", "/excitation/sa_absolute_g"}, {"values", {0.4, 0.7, 1.0, 1.5}}};
  write("e.json", absolute.dump());
  run();
  const Json curve = fragility()["curves"][0];
  std::map<std::string, double> medians;
  for (const Json& measure : curve["measures"])
    medians[measure["measure"].get<std::string>()] = measure["median"].get<double>();
  ASSERT_TRUE(medians.contains("sa_g") && medians.contains("sa_absolute_g"));
  EXPECT_NEAR(medians["sa_absolute_g"], curve["pooled"]["median"]["value"].get<double>(), 1e-6);
  EXPECT_GT(medians["sa_absolute_g"], medians["sa_g"]);
  write("hazard.csv", "sa_g, annual_rate\n0.1, 1e-2\n0.5, 1e-3\n5, 1e-5\n");
  const auto other = rocking("fragility out --hazard hazard.csv");
  EXPECT_EQ(other.exit_code, 65) << "a hazard in pseudo-accelerations does not fit";
  EXPECT_THAT(other.errors, HasSubstr("which is sa_absolute_g[0.5]"));
}

TEST_F(RateOfASuite, WritesItsAnswerOnASheet) {
  Json wider = experiment();
  wider["sweep"].push_back({{"parameter", "/block/width_m"}, {"values", {0.35, 0.5}}});
  wider["excitation"]["left_out"] = {"gone.at2"};
  write("e.json", wider.dump());
  run();
  const auto made = rocking("fragility out --hazard hazard.csv --sheet sheet.html");
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const std::string missing = "1 record of the suite could not be read and was left out: gone.at2";
  EXPECT_THAT(made.output, HasSubstr("warning: " + missing));
  EXPECT_THAT(read("sheet.html"), HasSubstr(missing));
  EXPECT_EQ(fragility()["curves"][0]["left_out"], Json({"gone.at2"}));
  EXPECT_THAT(made.output, AllOf(HasSubstr("sheet: sheet.html"), HasSubstr("rates compared")));
  const std::string sheet = read("sheet.html");
  const Json report = Json::parse(read("out/report.json"));
  for (const std::string& text :
       {std::string("five sines"), std::string("scale 1 : "), std::string("hazard.csv"), std::string("r3.at2"),
        std::string("data:image/png;base64,"), std::string("in 475 years"), std::string("Poisson"),
        report["input"]["sha256"].get<std::string>(), report["result"]["digest"].get<std::string>(),
        std::string("rocking fragility out --hazard hazard.csv --sheet sheet.html")}) {
    EXPECT_THAT(sheet, HasSubstr(text));
  }
  const Json found = fragility("--hazard hazard.csv");
  // The wider block against the narrower one, with an interval.
  const Json& comparison = found["comparisons"].at(0);
  EXPECT_EQ(comparison["option"], Json({{"/block/width_m", 0.5}}));
  // Factor and rates have one basis.
  const Json& of_narrow = found["curves"][0]["annual_rate"];
  const Json& of_wide = found["curves"][1]["annual_rate"];
  EXPECT_EQ(comparison["from"], of_narrow["from"]);
  EXPECT_EQ(comparison["from"], of_wide["from"]);
  const double wide = of_wide["value"], narrow = of_narrow["value"];
  EXPECT_NEAR(comparison["difference"].get<double>(), wide - narrow, 1e-12 * narrow);
  EXPECT_NEAR(comparison["ratio"].get<double>(), wide / narrow, 1e-12);
  EXPECT_LE(comparison["ratio_interval"][0], comparison["ratio"]);
  EXPECT_GE(comparison["ratio_interval"][1], comparison["ratio"]);
  // Each option is warned of.
  ASSERT_GT(of_wide["undecided_share"], 0.05);
  EXPECT_THAT(sheet, ::testing::ContainsRegex("class=\"warning\">Undecided by the levels: .* .width 0.5 m.\\.</p>"));
  // A base that never overturns has no factor; the second option still has a rate.
  wider["sweep"][1]["values"] = {3.0, 0.35};
  write("e.json", wider.dump());
  ASSERT_EQ(rocking("run e.json -q --no-page -o calm").exit_code, 0);
  ASSERT_EQ(rocking("fragility calm --hazard hazard.csv --sheet calm.html").exit_code, 0);
  EXPECT_THAT(
      read("calm.html"),
      AllOf(HasSubstr("With width 3 m the block did not overturn at these levels: mean annual rate at most "),
            HasSubstr("; with width 0.35 m mean annual rate "), HasSubstr("<td data-label=\"factor\">unknown</td>")));
  const auto again = rocking("fragility out --hazard hazard.csv --sheet sheet.html");
  EXPECT_EQ(again.exit_code, 74) << again.errors;
}

// One sentence with rate, interval and factor, and all numbers of it, in terminal, page and sheet.
TEST_F(RateOfASuite, TellsTheSameOnTerminalPageAndSheet) {
  Json wider = experiment();
  wider["sweep"].push_back({{"parameter", "/block/width_m"}, {"values", {0.35, 0.5}}});
  write("e.json", wider.dump());
  run();
  const auto terminal = rocking("fragility out --all --hazard hazard.csv --years 50 --sheet sheet.html");
  ASSERT_EQ(terminal.exit_code, 0) << terminal.errors;
  ASSERT_EQ(rocking("report out --format html --hazard hazard.csv").exit_code, 0);
  const Json found = fragility("--hazard hazard.csv --years 50");
  const auto with_interval = [](const Json& value, const Json& interval) {
    return rocking::rate_text(value) + " [" + rocking::rate_text(interval[0]) + ", " + rocking::rate_text(interval[1]) +
           ']';
  };
  const Json &narrow = found["curves"][0]["annual_rate"], &factor = found["comparisons"][0];
  const std::string rate = with_interval(narrow["value"], narrow["interval"]);
  const std::string times = with_interval(factor["ratio"], factor["ratio_interval"]);
  const std::string sentence = terminal.output.substr(0, terminal.output.find('\n'));
  EXPECT_THAT(sentence,
              ::testing::MatchesRegex("With width 0.35 m the block overturns about once in [0-9]+ years: "
                                      "mean annual rate .* .95 %.; what the levels leave open, .* of the rate, "
                                      "raises it to at most .*: add .*; with width 0.5 m .* times as often\\."));
  EXPECT_THAT(sentence, AllOf(HasSubstr("rate " + rate + " (95 %)"), HasSubstr("m " + times + " times")));
  const std::string page = read("out/report.html"), sheet = read("sheet.html");
  const auto cells = [](std::string number) {
    return number.replace(number.find(' '), 1, "<br><span class=\"small\">") + "</span></td>";
  };
  EXPECT_THAT(page, HasSubstr("<p class=\"headline\">" + sentence + "</p>"));
  EXPECT_THAT(sheet, AllOf(HasSubstr("<p class=\"answer\">" + sentence + "</p>"), HasSubstr(cells(rate)),
                           HasSubstr(cells(times))));
  const Json& in_50 = narrow["in_years"][0];
  const auto per_cent = [](const Json& probability) { return rocking::rate_text(100.0 * probability.get<double>()); };
  const std::string low = per_cent(in_50["interval"][0]), high = per_cent(in_50["interval"][1]);
  const std::string within = per_cent(in_50["probability"]);
  EXPECT_THAT(terminal.output, HasSubstr("in 50 years: " + within + " % [" + low + ", " + high + ']'));
  EXPECT_THAT(sheet, HasSubstr(within + "<br><span class=\"small\">[" + low + ", " + high + ']'));
  for (const std::string& text : {terminal.output, page, sheet}) {
    for (const char* least : {"0.219", "0.312"}) {
      EXPECT_THAT(text, HasSubstr(std::string("from PGA = ") + least + " g on"));
    }
    EXPECT_THAT(text, HasSubstr(rocking::per_cent(narrow["extrapolated_hazard"]) + " % of the rate"));
  }
  // Both options are drawn, with the lines of what is written by hand.
  for (const std::string& text : {page, sheet}) {
    EXPECT_THAT(text, AllOf(HasSubstr("<svg class=\"objects\""), HasSubstr(">width 0.35 m</text>"),
                            HasSubstr(">width 0.5 m</text>")));
  }
  EXPECT_THAT(sheet, HasSubstr("<p>Project: </p><p>Date: </p><p>Signature:</p>"));
  ASSERT_EQ(
      rocking("fragility out --hazard hazard.csv --sheet signed.html --project 'A & B' --date 'May 2012'").exit_code,
      0);
  EXPECT_THAT(read("signed.html"), AllOf(HasSubstr("<p>Project: A &amp; B</p><p>Date: May 2012</p>"),
                                         HasSubstr("--project &#39;A &amp; B&#39; --date &#39;May 2012&#39;")));
  EXPECT_THAT(page, AllOf(Not(HasSubstr("<dt>Repeatability</dt>")), Not(HasSubstr("excitation periods"))));
}

// Its sketch is that of the mean block.
TEST_F(RateOfASuite, HasASheetOfABlockOfRandomWidth) {
  Json random = experiment();
  random["block"]["width_m"] = {{"lognormal", {{"mean", 0.35}, {"sigma", 0.02}}}};
  write("e.json", random.dump());
  run();
  const auto made = rocking("fragility out --hazard hazard.csv --sheet sheet.html");
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  EXPECT_THAT(read("sheet.html"), HasSubstr("0.35"));
}

TEST_F(RateOfASuite, MakesAPdfOfItsSheetWhereWeasyPrintIs) {
  run();
  const auto without =
      shell("PATH=/nonexistent '" ROCKING_PROGRAM "' fragility out --hazard hazard.csv --sheet sheet.pdf");
  EXPECT_EQ(without.exit_code, 74);
  EXPECT_THAT(without.errors, HasSubstr("WeasyPrint is not installed"));
  EXPECT_FALSE(exists("sheet.pdf"));
  if (shell("command -v weasyprint").exit_code != 0) GTEST_SKIP() << "WeasyPrint is not installed";
  const auto made = rocking("fragility out --hazard hazard.csv --sheet sheet.pdf");
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const std::string pdf = read("sheet.pdf");
  EXPECT_TRUE(pdf.starts_with("%PDF-"));
  ASSERT_EQ(rocking("fragility out --hazard hazard.csv --overwrite --sheet sheet.pdf").exit_code, 0);
  EXPECT_EQ(read("sheet.pdf"), pdf) << "equal input gives equal bytes";
  EXPECT_EQ(rocking("fragility out --sheet other.pdf").exit_code, 64);
  EXPECT_EQ(rocking("fragility out --hazard hazard.csv --sheet sheet.doc").exit_code, 64);
}

TEST_F(RateOfASuite, RefusesAHazardCurveInAnotherMeasure) {
  run();
  const std::string points = "0.1, 1e-2\n0.5, 1e-3\n";
  for (const auto& [name, reason] :
       {std::pair{"sa_g", "which is pga_g"}, std::pair{"pgv_m_s", "which is pga_g"},
        std::pair{"arias_m_s", "no known intensity measure"}, std::pair{"annual_rate", "no known intensity measure"},
        std::pair{"/excitation/scale", "which is pga_g"}}) {
    write("other.csv", "# a comment\n" + std::string(name) + ", annual_rate\n" + points);
    const auto other = rocking("fragility out --hazard other.csv");
    EXPECT_EQ(other.exit_code, 65) << name;
    EXPECT_EQ(other.output, "") << name;
    const std::string last = std::string(name).substr(std::string(name).rfind('/') + 1);
    EXPECT_THAT(other.errors, AllOf(HasSubstr("other.csv, line 2"), HasSubstr(last), HasSubstr(reason))) << name;
  }
  for (const char* name : {"pga_g", "/excitation/pga_g", "\"pga_g\""}) {
    write("own.csv", std::string(name) + ", annual_rate\n" + points);
    const auto own = rocking("fragility out --hazard own.csv");
    EXPECT_EQ(own.exit_code, 0) << name << own.errors;
  }
}

// Neighbouring doubles, the least and the largest numbers, and as many points as are allowed.
TEST_F(RateOfASuite, TakesExtremeHazardCurves) {
  run();
  const auto rate = [this](const std::string& text) {
    write("extreme.csv", "pga_g, annual_rate\n" + text);
    return fragility("--hazard extreme.csv")["curves"][0]["annual_rate"];
  };
  const Json plain = rate("0.3, 1e-3\n2, 1e-5\n");
  const auto by_law = [](const Json& found) { return found["estimates"][0]["value"].get<double>(); };
  // The rate falls by half at 0.3 g, the second level.
  const Json stepped = rate("0.3, 2e-3\n0.30000000000000004, 1e-3\n2, 1e-5\n");
  const double there = fragility()["curves"][0]["levels"][1]["fitted"];
  EXPECT_NEAR(by_law(stepped), by_law(plain) + 1e-3 * there, 1e-9);
  EXPECT_GT(rate("1e-308, 1e-2\n1e308, 1e-3\n")["value"], 1e-3);
  std::string many;
  for (int i = 0; i < 10000; ++i) {
    const double x = 0.3 * std::pow(2.0 / 0.3, i / 9999.0);
    many +=
        std::to_string(x) + ", " + Json(1e-3 * std::pow(x / 0.3, std::log(1e-2) / std::log(2.0 / 0.3))).dump() + '\n';
  }
  EXPECT_NEAR(rate(many)["value"].get<double>(), plain["value"].get<double>(), 1e-5 * plain["value"].get<double>());
  write("extreme.csv", many + "3, 1e-9\n");
  const auto refused = rocking("fragility out --hazard extreme.csv");
  EXPECT_EQ(refused.exit_code, 65);
  EXPECT_THAT(refused.errors, HasSubstr("more than 10000 points"));
}

}  // namespace
