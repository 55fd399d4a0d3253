// What a run, or an experiment before it runs, found that must be looked at, and what to do.

#include "rocking/output/findings.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/input/read_experiment.hpp"
#include "rocking/plan/plan.hpp"
#include "support/experiment_text.hpp"

namespace {

using namespace rocking;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// Two conditions of a thousand realisations and a hundred thousand random numbers each.
Report calm() {
  Report report;
  for (int i = 0; i < 2; ++i) {
    ConditionResult& result = report.conditions.emplace_back().result;
    result.realisations = 1000;
    result.operations.kinetic_friction_draws = 100'000;
  }
  return report;
}

std::vector<std::string> words_of(const std::vector<Finding>& findings) {
  std::vector<std::string> words;
  for (const Finding& each : findings) {
    if (each.rating == Rating::look) words.push_back(in_words(each));
  }
  return words;
}

std::vector<std::string> looks_at(const Report& report) { return words_of(findings_of(report)); }
std::vector<std::string> suspicions_of(const Experiment& experiment) {
  return words_of(suspicious_numbers(experiment));
}
std::vector<std::string> few_periods_of(const Experiment& experiment) { return words_of(too_few_periods(experiment)); }
std::vector<std::string> clamps_foreseen_of(const Experiment& asked) { return words_of(foreseen_clamps(asked)); }

TEST(Findings, AreNoneForALossOfContactInAFinalFall) {
  Report report = calm();
  report.conditions[1].result.validity.left_ground.add(7);
  EXPECT_THAT(looks_at(report), IsEmpty());
  report.conditions[1].result.validity.left_ground_before_fall.add(7);
  EXPECT_THAT(looks_at(report),
              ElementsAre(AllOf(HasSubstr("1 realisation lost contact"), HasSubstr("--condition 1 --realisation 7"))));
}

TEST(Findings, AreRaisedWhereMoreThanOnePerCentIsClamped) {
  Report report = calm();
  Validity& validity = report.conditions[1].result.validity;
  for (std::uint64_t i = 0; i < 10; ++i) validity.clamped.add(i);
  validity.clamps.kinetic_at_static = 1000;
  EXPECT_THAT(looks_at(report), IsEmpty()) << "1 % of both";
  validity.clamps.kinetic_at_zero = 1;
  EXPECT_THAT(
      looks_at(report),
      ElementsAre(AllOf(HasSubstr("1.0 % of the draws of condition 1 were clamped, in 1.0 % of its realisations"),
                        HasSubstr("add \"correlation\": 1 to /fluctuation/friction"))));
  validity.clamps = {.kinetic_at_zero = 11};
  validity.clamped.add(10);
  EXPECT_THAT(looks_at(report), ElementsAre(HasSubstr("kinetic friction below 0"))) << "1.1 % of the realisations";
}

TEST(Findings, HaveARemedyForEveryKindOfClamp) {
  for (const ClampKind& kind : clamp_kinds) {
    Report report = calm();
    report.conditions[0].result.validity.clamps.*kind.count = 50'000;
    EXPECT_THAT(in_words(clamped_numbers(report)), HasSubstr("reduce the sigma")) << kind.key;
  }
}

TEST(Findings, GiveTheLawThatClampsLeave) {
  Report report = calm();
  report.conditions[0].result.validity.clamps.kinetic_at_static = 50'000;
  Scene& scene = report.conditions[0].asked.scene;
  scene.friction = {.static_coefficient = 0.35, .kinetic_coefficient = 0.30};
  scene.fluctuation = {.static_friction = 0.03, .kinetic_friction = 0.03};
  const std::string in_force =
      "above the static friction in force, which leaves a mean of 0.298 and a sigma of 0.0277, not 0.3 and 0.03";
  EXPECT_THAT(in_words(clamped_numbers(report)), HasSubstr(in_force));
  EXPECT_THAT(looks_at(report), ElementsAre(HasSubstr(in_force)));
  scene.fluctuation.laws.kinetic_friction = FluctuationLaw::lognormal;
  EXPECT_THAT(in_words(clamped_numbers(report)), Not(HasSubstr("which leaves")));
  scene.fluctuation.laws.kinetic_friction = FluctuationLaw::normal;
  scene.friction->kinetic_coefficient = Uniform{.low = 0.29, .high = 0.31};
  EXPECT_THAT(in_words(clamped_numbers(report)), Not(HasSubstr("which leaves"))) << "drawn";
  scene.friction->kinetic_coefficient = 0.30;
  scene.friction->kinetic_ratio = 0.9;
  EXPECT_THAT(in_words(clamped_numbers(report)), Not(HasSubstr("which leaves"))) << "a ratio";
}

Experiment least_with(const std::vector<std::pair<std::string, std::string>>& changes) {
  Json document = support::least_experiment();
  for (const auto& [pointer, value] : changes) document = support::with(document, pointer, value);
  return experiment_in(document.dump());
}

TEST(SuspiciousNumbers, AreThoseOfAnotherUnitThanThatOfTheirKey) {
  struct Slip {
    std::string key, value, usual, told;
  };
  for (const Slip& slip : std::vector<Slip>{
           {"/block/height_m", "45", "4.5", "lengths are in metres: 45 cm are 0.45, 45 mm 0.045"},
           {"/block/height_m", "1900", "1.9",
            "/block/height_m: 1900 is above 30 m, which is unusual; lengths are in m"},
           {"/block/height_m", R"({"uniform": [1800, 2000]})", "29", "uniform from 1800 to 2000 is above 30 m"},
           {"/excitation/phase_rad", "90", "1.5708", "90 degrees are 1.571"},
           {"/friction", R"({"static": 40, "kinetic": 0.3})", R"({"static": 0.4, "kinetic": 0.3})", "/static: 40"},
           {"/excitation", R"({"kind": "pulse", "shape": "sine", "amplitude_g": 9.81, "period_s": 1})",
            R"({"kind": "pulse", "shape": "sine", "amplitude_m_s2": 9.81, "period_s": 1})", "amplitude_g: 9.81"},
           {"/excitation", R"({"kind": "harmonic", "amplitude_g": 0.3, "frequency_hz": 200})",
            R"({"kind": "harmonic", "amplitude_g": 0.3, "frequency_hz": 2})",
            "/excitation/frequency_hz: 200 is above 50 Hz"},
           {"/excitation", R"({"kind": "harmonic", "amplitude_g": 0.3, "period_s": 500})",
            R"({"kind": "harmonic", "amplitude_g": 0.3, "period_s": 0.5})",
            "/excitation/period_s: 500 is above 20 s"}}) {
    EXPECT_THAT(suspicions_of(least_with({{slip.key, slip.value}})), ElementsAre(HasSubstr(slip.told))) << slip.key;
    EXPECT_THAT(suspicions_of(least_with({{slip.key, slip.usual}})), IsEmpty()) << slip.key;
  }
  EXPECT_THAT(suspicions_of(least_with({{"/block/width_m", "0.001"}, {"/block/height_m", "0.005"}})),
              ElementsAre(HasSubstr("/block/width_m: 0.001 is below 0.01 m"), HasSubstr("/block/height_m: 0.005")));
}

TEST(SuspiciousNumbers, AreThoseOfPartsInOnePlaceOrInTheAir) {
  const auto with_parts = [](const std::string& upper, const std::string& more = "") {
    return suspicions_of(least_with(
        {{"/block", R"({"parts": [{"width_m": 0.4, "height_m": 0.3, "mass_kg": 5, "x_m": 0, "bottom_m": 0}, )" + upper +
                        more + "]}"}}));
  };
  const auto part = [](const std::string& x, const std::string& bottom) {
    return R"({"width_m": 0.2, "height_m": 0.6, "mass_kg": 5, "x_m": )" + x + R"(, "bottom_m": )" + bottom + "}";
  };
  EXPECT_THAT(with_parts(part("0", "0.3")), IsEmpty());
  EXPECT_THAT(with_parts(part("0.1", "0.2")),
              ElementsAre(HasSubstr("/block/parts/1: overlaps /block/parts/0 by 0.1 m")));
  EXPECT_THAT(with_parts(part("0", "0.4")), ElementsAre(HasSubstr("/block/parts/1: touches no part")));
  EXPECT_THAT(with_parts(part("0", "0.9"), ", " + part("0", "0.3")), IsEmpty()) << "one on the other, in any order";
  EXPECT_THAT(with_parts(part("0.3", "0.1")), Not(::testing::Contains(HasSubstr("/block/parts"))))
      << "fixed to its side";
}

TEST(TooFewPeriods, AreFewerThanTheClassifierNeeds) {
  const auto with_periods = [](const std::string& periods, const std::string& phase, const std::string& fluctuation) {
    return few_periods_of(least_with({{"/horizon", "{\"transient_periods\": 5, \"sampled_periods\": " + periods + "}"},
                                      {"/excitation/phase_rad", phase},
                                      {"/fluctuation", fluctuation}}));
  };
  const std::string redrawn = R"({"amplitude": {"sigma": 0.01}})";
  EXPECT_THAT(with_periods("47", "0", redrawn), ElementsAre(AllOf(HasSubstr("/horizon/sampled_periods: 47 are too few"),
                                                                  HasSubstr("at least 48 where"))));
  EXPECT_THAT(with_periods("48", "0", redrawn), IsEmpty());
  const std::string drawn_once = R"({"uniform": [0, 6]})";
  EXPECT_THAT(with_periods("23", drawn_once, "{}"), ElementsAre(HasSubstr("at least 24; the default is 120")));
  EXPECT_THAT(with_periods("24", drawn_once, "{}"), IsEmpty());
}

TEST(SuspiciousNumbers, TellInHowManyConditionsTheyAre) {
  const std::string sweep = R"([ { "parameter": "/block/height_m", "values": [4, 40, 50] } ])";
  EXPECT_THAT(suspicions_of(least_with({{"/sweep", sweep}})),
              ElementsAre(AllOf(HasSubstr("/block/height_m: 40"), HasSubstr("(in 2 of 3 conditions)"))));
}

TEST(SuspiciousNumbers, AreThoseOfASquatBlockAndWhatItDoesThen) {
  // tan(psi) = 1.9/0.35: Housner's ratio is 1 - 1.5 sin^2(psi) = -0.451
  const auto squat = suspicions_of(least_with({{"/block/width_m", "1.9"}, {"/block/height_m", "0.35"}}));
  EXPECT_THAT(
      squat, ElementsAre(AllOf(HasSubstr("/block: the block is squat"), HasSubstr("above 5.43 g"), HasSubstr("swapped"),
                               HasSubstr("-0.451 of the tilt rate. Below 0 the block does not go on"))));
  // 1 - 1.5 (1.1/1.5)^2/(1 + (1.1/1.5)^2 ...) > 0: it goes on
  EXPECT_THAT(suspicions_of(least_with({{"/block/width_m", "1.1"}, {"/block/height_m", "1.0"}})),
              ElementsAre(AllOf(HasSubstr("above 1.1 g"), Not(HasSubstr("Below 0")))));
  EXPECT_THAT(
      suspicions_of(least_with({{"/block/width_m", "0.9"}, {"/block/height_m", "1.0"}, {"/restitution", "0.9"}})),
      ElementsAre(AllOf(HasSubstr("/restitution: An impact leaves -"), Not(HasSubstr("squat")))));
}

TEST(ForeseenClamps, OccurAsOftenAsTheirLawsSay) {
  const auto clamps_of = [](const std::string& fluctuation) {
    return least_with({{"/friction", R"({"static": 0.35, "kinetic": 0.30})"}, {"/fluctuation", fluctuation}});
  };
  const Experiment independent = clamps_of(R"({"friction": {"sigma": 0.03}})");
  const auto sampled = sample_clamps(independent);
  ASSERT_EQ(sampled.size(), 1U);
  const auto n = static_cast<double>(sampled[0].realisations);
  const double truth = 0.5 * std::erfc(0.05 / (0.03 * std::sqrt(2.0)) / std::sqrt(2.0));
  EXPECT_NEAR(static_cast<double>(sampled[0].clamps.kinetic_at_static) / n, truth,
              4.0 * std::sqrt(truth * (1.0 - truth) / n))
      << "four standard errors, with a fixed seed";
  EXPECT_THAT(clamps_foreseen_of(independent),
              ElementsAre(AllOf(HasSubstr("clamped in 12 % of their draws: kinetic friction above the static friction"),
                                HasSubstr("which leaves a mean of 0.298 and a sigma of 0.0277, not 0.3 and 0.03"))));
  EXPECT_THAT(clamps_foreseen_of(clamps_of(R"({"friction": {"sigma": 0.03, "correlation": 1}})")), IsEmpty());
  EXPECT_THAT(clamps_foreseen_of(clamps_of(R"({"amplitude": {"sigma": 3}, "restitution": {"sigma": 1}})")),
              ElementsAre(HasSubstr("restitution outside"), HasSubstr("amplitude below 0")));
  EXPECT_THAT(sample_clamps(clamps_of("{}")), IsEmpty()) << "nothing is drawn";
}

TEST(ForeseenClamps, AreThoseOfNumbersThatAreDrawnOnceToo) {
  const std::string law = R"({"normal": {"mean": 0.1, "sigma": 0.1}})";
  EXPECT_THAT(
      clamps_foreseen_of(least_with({{"/friction", R"({"static": )" + law + R"(, "kinetic": {"ratio": 0.9}})"}})),
      ElementsAre(HasSubstr("static friction below 0")));
}

TEST(Findings, NameTheRecordsThatWereLeftOut) {
  Report report = calm();
  report.left_out = {"a.at2", "b.at2"};
  EXPECT_THAT(looks_at(report), ElementsAre(HasSubstr("2 records of the suite could not be read and were left out: "
                                                      "a.at2, b.at2. The probabilities are those of the others")));
}

TEST(SensitivityToTolerance, IsRemediedDownToDoublePrecision) {
  Report report = calm();
  report.tolerance_sensitivity = {
      .flips = {.successes = 9, .trials = 10}, .interval = {}, .noise = NumericalError::not_small};
  const auto remedy_at = [&report](double tolerance) {
    report.conditions[1].asked.tolerance = tolerance;
    return precision_findings(report).front().remedy;
  };
  report.conditions[0].asked.tolerance = 1e-6;
  EXPECT_EQ(remedy_at(1e-10), "set /accuracy/tolerance to 1e-12 and run again");
  EXPECT_EQ(remedy_at(1e-13), "set /accuracy/tolerance to 1e-15 and run again");
  EXPECT_EQ(remedy_at(3e-15), "set /accuracy/tolerance to 1e-15 and run again");
  EXPECT_THAT(remedy_at(1e-15), HasSubstr("due to rounding"));
}

TEST(Findings, TellOfRealisationsWithoutAnAnswer) {
  Report report = calm();
  ConditionResult& result = report.conditions[1].result;
  for (std::uint64_t i = 0; i < 3; ++i) result.validity.stopped.add(i);
  EXPECT_THAT(looks_at(report), IsEmpty()) << "they have a response mode, and ended while it was watched";
  result.modes.emplace_back().probability.counts = {.successes = 5, .trials = 1000};
  EXPECT_THAT(looks_at(report),
              ElementsAre(HasSubstr("3 of 2000 realisations ended before their horizon without an answer")));
}

}  // namespace
