// Bad experiment files: each fault is reported with its place, value and remedy, and all faults of a file at once.

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/input/read_experiment.hpp"
#include "rocking/scene/check_condition.hpp"
#include "support/experiment_text.hpp"

namespace {

using namespace rocking;
using support::example_experiment;
using support::least_experiment;
using support::with;
using support::without;
using ::testing::HasSubstr;

std::vector<base::Problem> problems_of(const Json& document, const Overrides& overrides = {}) {
  try {
    static_cast<void>(experiment_in(document.dump(), overrides));
  } catch (const base::InputError& error) {
    return error.problems();
  }
  return {};
}

/// One change of the example, and the required report.
struct Fault {
  const char* pointer;
  const char* value;
  const char* place;   ///< place of the report; same as pointer if empty
  const char* reason;  ///< part of it
  const char* remedy;  ///< part of it
};

void PrintTo(const Fault& fault, std::ostream* out) { *out << fault.pointer << " = " << fault.value; }

class OneFault : public ::testing::TestWithParam<Fault> {};

TEST_P(OneFault, IsToldWithPlaceValueReasonAndRemedy) {
  const Fault& fault = GetParam();
  const auto document = with(without(example_experiment(), "sweep"), fault.pointer, fault.value);
  const auto problems = problems_of(document);
  ASSERT_EQ(problems.size(), 1U) << base::InputError(problems).what();
  const std::string place = *fault.place == '\0' ? fault.pointer : fault.place;
  EXPECT_EQ(problems[0].place, place);
  EXPECT_EQ(problems[0].value, brief(document.at(Json::json_pointer(place))));
  EXPECT_THAT(problems[0].reason, HasSubstr(fault.reason));
  EXPECT_THAT(problems[0].remedy, HasSubstr(fault.remedy));
}

INSTANTIATE_TEST_SUITE_P(Keys, OneFault,
                         ::testing::Values(Fault{"/titel", "\"x\"", "", "is not a key", "\"title\""},
                                           Fault{"/block/width", "1", "", "is not a key", "\"width_m\""},
                                           Fault{"/friction/sttic", "1", "", "is not a key", "\"static\""},
                                           Fault{"/excitation/zzzzzzzzzz", "1", "", "is not a key", "\"amplitude\""}));

INSTANTIATE_TEST_SUITE_P(
    Types, OneFault,
    ::testing::Values(Fault{"/block/width_m", "\"1.0\"", "", "must be a number, not text", "without quotes"},
                      Fault{"/block", "[1, 4]", "", "must be an object, not a list", "{"},
                      Fault{"/friction", "0.3", "", "must be an object, not a number", "{"},
                      Fault{"/title", "3", "", "must be text", "quotes"},
                      Fault{"/horizon/transient_periods", "500.5", "", "must be a whole number", "500"},
                      Fault{"/confidence", "true", "", "not true or false", "0.95"},
                      Fault{"/excitation/amplitude", "null", "", "not null", "4.2"},
                      Fault{"/initial/tilt", "[0, 1]", "", "must be a number, not a list", "0.0"}));

INSTANTIATE_TEST_SUITE_P(
    Ranges, OneFault,
    ::testing::Values(
        Fault{"/format", "\"rocking.experiment/9\"", "", "not a format", "rocking.experiment/1"},
        Fault{"/block/width_m", "-0.1", "", "must be a positive number of metres", "1.0"},
        Fault{"/block/height_m", "0", "", "must be a positive number of metres", "1.0"},
        Fault{"/block/gravity_m_s2", "-9.81", "", "must be a positive", "9.81"},
        Fault{"/excitation/amplitude", "-1", "", "from 0", "4.2"},
        Fault{"/excitation/frequency_ratio", "0", "", "must be a positive", "10.0"},
        Fault{"/friction/kinetic", "-0.3", "", "must not be negative", "0.35"},
        Fault{"/accuracy/tolerance", "1e-17", "", "1e-16", "1e-13"},
        Fault{"/accuracy/tolerance", "0.1", "", "1e-2", "1e-13"},
        Fault{"/confidence", "1", "", "above 0 and below 1", "0.95"},
        Fault{"/realisations", "0", "", "must be a whole number from 1", "1"},
        Fault{"/horizon/sampled_periods", "0", "", "from 1", "120"},
        Fault{"/fluctuation/friction/sigma", "-0.1", "", "must not be negative", "0.03"},
        Fault{"/fluctuation/friction/refreshes_per_period", "0", "", "from 1 to 100000", "200"},
        Fault{"/fluctuation/friction/refresh_slip_m", "0.001", "", "excludes \"refreshes_per_period\"", "keep one"},
        Fault{"/restitution", "-1", "", "above -1", "0.0"}, Fault{"/restitution", "\"jy26\"", "", "above -1", "jy25"},
        Fault{"/formulation", "\"as-ploted\"", "", "one of", "as-plotted"},
        Fault{"/slide_inertia", "\"central\"", "", "one of", ""}, Fault{"/seed", "-1", "", "64 bits", "0x2012"},
        Fault{"/seed", "\"0x1ffffffffffffffff\"", "", "64 bits", "0x2012"},
        Fault{"/seed", "1.5", "", "64 bits", "0x2012"}));

INSTANTIATE_TEST_SUITE_P(
    Laws, OneFault,
    ::testing::Values(Fault{"/initial/tilt", R"({"uniform": [0.2, 0.1]})", "/initial/tilt/uniform", "first end",
                            "swap"},
                      Fault{"/initial/tilt", R"({"uniform": [0.2]})", "/initial/tilt/uniform", "2 numbers", "["},
                      Fault{"/initial/tilt", R"({"weibull": 1, "normal": {"mean": 0, "sigma": 1}})",
                            "/initial/tilt/weibull", "is not a key", ""},
                      Fault{"/initial/tilt_rate", "{}", "", "has no distribution", "uniform"},
                      Fault{"/excitation/phase_rad", R"({"normal": {"mean": 0, "sigma": -1}})",
                            "/excitation/phase_rad/normal/sigma", "negative", "0.03"}));

INSTANTIATE_TEST_SUITE_P(
    Between, OneFault,
    ::testing::Values(
        Fault{"/friction/static", "0.2", "", "below the kinetic", "at least 0.3"},
        Fault{"/friction", R"({"static": 2, "kinetic": 1.34})", "/friction/kinetic", "Painleve", "less than 1.33333"},
        Fault{"/initial/tilt", "6.42", "", "overturned block", "smaller"},
        Fault{"/initial/tilt", R"({"uniform": [-7, 0]})", "", "overturned block", "smaller"},
        Fault{"/fluctuation/friction/relative_sigma", "0.1", "", "excludes", "keep one"},
        Fault{"/fluctuation/kinetic_friction", R"({"sigma": 0.1})", "", "excludes \"friction\"", "keep one"}));

INSTANTIATE_TEST_SUITE_P(
    RandomBlock, OneFault,
    ::testing::Values(Fault{"/block/width_m", R"({"uniform": [-0.1, 1.0]})", "/block/width_m/uniform/0",
                            "must be a positive number of metres", "1.0"},
                      Fault{"/block/width_m", R"({"uniform": [1.0, 0.5]})", "/block/width_m/uniform",
                            "less than its second", "swap"},
                      Fault{"/block/height_m", R"({"normal": {"mean": 0.0, "sigma": 0.1}})",
                            "/block/height_m/normal/mean", "must be a positive number of metres", "1.0"},
                      Fault{"/block/height_m", R"({"normal": {"mean": 4.0, "sigma": -0.1}})",
                            "/block/height_m/normal/sigma", "must not be negative", "0.03"},
                      Fault{"/block/height_m", "{}", "", "has no distribution", "uniform"},
                      Fault{"/block/gravity_m_s2", R"({"uniform": [9.0, 10.0]})", "", "must be a number", ""}));

// The squattest block that the law can give decides: psi = atan(1/0.5) there.
TEST(BadExperiment, HasATiltThatIsOverturnedForSomeOfItsBlocks) {
  auto document = with(least_experiment(), "/initial", R"({"tilt": 1.5})");
  EXPECT_EQ(problems_of(document).size(), 0U);
  document = with(document, "/block/height_m", R"({"uniform": [0.5, 4.0]})");
  const auto problems = problems_of(document);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].place, "/initial/tilt");
  EXPECT_THAT(problems[0].reason, HasSubstr("1.41878"));
}

// With the inertia about the edge, friction 1.5 has no solution for H/B near 2, and one for the slender and the squat.
TEST(BadExperiment, HasFrictionThatIsTooLargeForSomeOfItsBlocks) {
  auto document = with(least_experiment(), "/friction", R"({"static": 1.5, "kinetic": 1.5})");
  document = with(document, "/slide_inertia", "\"edge\"");
  EXPECT_EQ(problems_of(document).size(), 0U);
  EXPECT_EQ(problems_of(with(document, "/block/height_m", "1.0")).size(), 0U);
  EXPECT_EQ(problems_of(with(document, "/block/height_m", "2.0")).size(), 1U);
  document = with(document, "/block/height_m", R"({"uniform": [1.0, 4.0]})");
  const auto problems = problems_of(document);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].place, "/friction/kinetic");
  EXPECT_THAT(problems[0].remedy, HasSubstr("1.33333"));
}

INSTANTIATE_TEST_SUITE_P(
    Until, OneFault,
    ::testing::Values(
        Fault{"/realisations", R"({"until": {"half_width": 0.5, "at_most": 200}})", "/realisations/until/half_width",
              "below 0.5", "0.02"},
        Fault{"/realisations", R"({"until": {"half_width": 0.02, "at_most": 0}})", "/realisations/until/at_most",
              "from 1", ""},
        Fault{"/realisations", R"({"until": {"half_width": 0.02, "at_most": 9, "after": 1}})",
              "/realisations/until/after", "is not a key", "at_most"},
        Fault{"/realisations", R"({"until": {"at_most": 9}})", "/realisations/until", "no half-width",
              "relative_half_width"},
        Fault{"/realisations",
              R"({"until": {"half_width": 0.02, "relative_half_width": 0.1, "mode": "rest", "at_most": 9}})",
              "/realisations/until", "two half-widths", "half_width"},
        Fault{"/realisations", R"({"until": {"relative_half_width": 1, "mode": "rest", "at_most": 9}})",
              "/realisations/until/relative_half_width", "below 1", "0.1"},
        Fault{"/realisations", R"({"until": {"half_width": 0.1, "mode": "overturn", "at_most": 9}})",
              "/realisations/until/mode", "not the name of a response mode", "(1,3)"},
        Fault{"/realisations", R"json({"until": {"half_width": 0.1, "mode": "(1,0)", "at_most": 9}})json",
              "/realisations/until/mode", "not the name of a response mode", "(1,3)"},
        Fault{"/realisations", R"({"until": {"half_width": 0.1, "mode": 7, "at_most": 9}})", "/realisations/until/mode",
              "not the name of a response mode", "(1,3)"}));

TEST(BadExperiment, NeedsAModeForARelativeHalfWidth) {
  const auto problems = problems_of(
      with(least_experiment(), "/realisations", R"({"until": {"relative_half_width": 0.1, "at_most": 9}})"));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].place, "/realisations/until/mode");
  EXPECT_THAT(problems[0].reason, HasSubstr("is missing"));
  EXPECT_THAT(problems[0].remedy, HasSubstr("overturned"));
}

TEST(BadExperiment, IsToldInAllItsFaultsAtOnce) {
  auto document = with(example_experiment(), "/block/width_m", "-1");
  document = with(document, "/friction/static", "0.1");
  document = with(document, "/sweep/0/step", "0.3");
  document = with(document, "/confidence", "95");
  document = with(document, "/tilt", "0");
  EXPECT_EQ(problems_of(document).size(), 5U);
}

// Demands of values of each other are told once, whatever else is wrong with the keys.
TEST(BadExperiment, IsToldOfEachRelationOnce) {
  Json document = without(example_experiment(), "sweep");
  document["realisations"] = Json::parse(R"({"until": {"half_width": 0.1, "at_most": 9}})");
  document["horizon"] =
      Json::parse(R"({"transient_periods": 10, "sampled_periods": 1001, "until_classified": {"at_most_periods": 50}})");
  document["excitation"] = Json::parse(R"({"kind": "pulse", "shape": "sine", "amplitude": 3, "frequency_ratio": 3})");
  document["friction"] = Json::parse(R"({"static": 0.2, "kinetic": 0.3})");
  document["initial"] = Json::parse(R"({"tilt": 8})");
  const auto problems = problems_of(document);
  const auto told = [&problems](const std::string& place, const std::string& reason) {
    return std::ranges::count_if(problems, [&](const base::Problem& problem) {
      return problem.place == place && problem.reason.find(reason) != std::string::npos;
    });
  };
  EXPECT_EQ(told("/horizon/until_classified", "of a periodic excitation"), 1);
  EXPECT_EQ(told("/friction/static", "is below"), 1);
  EXPECT_EQ(told("/initial/tilt", "overturned"), 1);
  EXPECT_EQ(problems.size(), 3U);
}

TEST(BadExperiment, MissesWhatMustBeSaid) {
  const auto problems = problems_of(Json::object());
  std::vector<std::string> places;
  for (const auto& problem : problems) {
    places.push_back(problem.place);
    EXPECT_THAT(problem.reason, HasSubstr("is missing"));
    EXPECT_THAT(problem.remedy, HasSubstr("add \""));
  }
  EXPECT_THAT(places, ::testing::UnorderedElementsAre("/format", "/block/width_m", "/block/height_m",
                                                      "/excitation/amplitude", "/excitation/frequency_ratio"));
}

TEST(BadExperiment, CannotSlideNorFluctuateWithoutFriction) {
  EXPECT_EQ(problems_of(with(least_experiment(), "/initial", R"({"slip_rate": 0.1})"))[0].place, "/initial/slip_rate");
  EXPECT_TRUE(problems_of(with(least_experiment(), "/initial", R"({"slip_rate": 0})")).empty());
  for (const std::string source : {"friction", "static_friction", "kinetic_friction"}) {
    const auto problems = problems_of(with(least_experiment(), "/fluctuation/" + source, R"({"sigma": 0.1})"));
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].place, "/fluctuation/" + source);
  }
}

TEST(BadExperiment, MeetsPainleveSoonerWithTheInertiaAboutTheEdge) {
  // (1/3 + sin^2 psi)/(sin psi cos psi) of H/B = 4: (1/3 + 1/17)/(4/17) = 5/3.
  const auto edge = with(least_experiment(), "/slide_inertia", "\"edge\"");
  EXPECT_TRUE(problems_of(with(edge, "/friction", R"({"static": 2, "kinetic": 1.666})")).empty());
  const auto problems = problems_of(with(edge, "/friction", R"({"static": 2, "kinetic": 1.667})"));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_THAT(problems[0].remedy, HasSubstr("1.66667"));
}

// What word processors, spreadsheets and people of other languages write.
TEST(BadExperiment, OfCharactersThatAreNotJsonSaysWhichToWrite) {
  const std::string text = least_experiment().dump();
  const auto problem = [](const std::string& document) {
    try {
      static_cast<void>(experiment_in(document));
    } catch (const base::InputError& error) {
      return error.problems().front();
    }
    return base::Problem{};
  };
  const auto replaced = [&text](const std::string& from, const std::string& to) {
    std::string changed = text;
    return changed.replace(changed.find(from), from.size(), to);
  };
  for (const char* quoted : {"\u201Cblock\u201D", "\u201Eblock\u201C", "\u00ABblock\u00BB", "\u2018block\u2019"}) {
    EXPECT_THAT(problem(replaced("\"block\"", quoted)).reason, HasSubstr("a curly quotation mark")) << quoted;
  }
  EXPECT_THAT(problem(replaced("\"block\"", "'block'")).remedy, HasSubstr("write double ones"));
  for (const char* number : {"4,25", "0,5", "-1,5e-3"}) {
    EXPECT_THAT(
        problem(R"({"format": "rocking.experiment/1", "block": {"height_m": )" + std::string(number) + "}}").remedy,
        HasSubstr("write a point"))
        << number;
  }
  const base::Problem sheet = problem(std::string("PK\x03\x04\x14\0\x06\0", 8));
  EXPECT_THAT(sheet.reason, HasSubstr("looks like a zip archive"));
  EXPECT_THAT(sheet.remedy, HasSubstr("as text in UTF-8"));
}

TEST(BadExperiment, WithAKeyThatStandsElsewhereSaysWhere) {
  const auto problems = problems_of(with(least_experiment(), "/until", R"({"half_width": 0.02})"));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].remedy, "it stands under /horizon or /realisations");
  const auto elsewhere = problems_of(with(least_experiment(), "/rerun_every", "10"));
  ASSERT_EQ(elsewhere.size(), 1U);
  EXPECT_EQ(elsewhere[0].remedy, "it stands under /accuracy");
  const auto of_pulses = problems_of(with(least_experiment(), "/excitation/cycles", "2"));
  ASSERT_EQ(of_pulses.size(), 1U);
  EXPECT_EQ(of_pulses[0].remedy, "it is of another kind or form");
}

// The place that a remedy names can be swept: an experiment that follows it is valid.
TEST(BadExperiment, NamesAPlaceOfASweepThatMayBeSwept) {
  for (const char* place : {"/excitation/amplitud", "/excitation/acceleration", "/blok/width_m", "/x"}) {
    const Json sweep = {{{"parameter", place}, {"values", {1.0}}}};
    const auto problems = problems_of(with(least_experiment(), "/sweep", sweep.dump()));
    ASSERT_EQ(problems.size(), 1U) << place;
    const std::string& remedy = problems[0].remedy;
    const std::size_t begin = remedy.find('"') + 1;
    Json followed = sweep;
    followed[0]["parameter"] = remedy.substr(begin, remedy.find('"', begin) - begin);
    EXPECT_THAT(problems_of(with(least_experiment(), "/sweep", followed.dump())), ::testing::IsEmpty()) << remedy;
  }
}

TEST(BadExperiment, OfNumbersThatAreNoneIsNotToldToOmitQuotes) {
  for (const char* value : {"\"nan\"", "\"NaN\"", "\"inf\"", "\"-inf\"", "\"Infinity\""}) {
    const auto problems = problems_of(with(least_experiment(), "/block/width_m", value));
    ASSERT_EQ(problems.size(), 1U);
    EXPECT_EQ(problems[0].reason, "is not a finite number");
    EXPECT_THAT(problems[0].remedy, ::testing::Not(HasSubstr("quotes")));
  }
}

TEST(BadExperiment, NamesTheFlagThatReplacedTheKey) {
  const auto problems = problems_of(example_experiment(), {.seed = "0xz", .realisations = "many"});
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[0].place, "--realisations");
  EXPECT_EQ(problems[1].place, "--seed");
}

TEST(BadExperiment, KeepsAHugeValueOutOfTheMessage) {
  const auto problems = problems_of(with(least_experiment(), "/title", Json(std::vector<int>(10'000, 7)).dump()));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_LE(problems[0].value.size(), 60U);
}

TEST(BadExperiment, TellsAFewOfAMillionUnknownKeys) {
  std::string text = R"({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},)";
  for (int i = 0; i < 200'000; ++i) text += "\"k" + std::to_string(i) + "\": 1,\n";
  text += R"("excitation": {"amplitude": 1, "frequency_ratio": 1}, "sweep": [{"parameter": "/excitation/amplitude",
             "from": 0, "to": 1000, "step": 0.01}]})";
  try {
    static_cast<void>(experiment_in(text));
    ADD_FAILURE() << "accepted";
  } catch (const base::InputError& error) {
    EXPECT_LE(error.problems().size(), 20U);
    EXPECT_THAT(error.what(), HasSubstr("199990 more keys"));
  }
}

TEST(BadExperiment, WorksOutNoSweepBeyondTheLimit) {
  auto document = with(example_experiment(), "/sweep", "[]");
  for (int i = 0; i < 100; ++i) {
    document["sweep"].push_back({{"parameter", "/friction/static"}, {"from", 0}, {"to", 999'999}, {"step", 1}});
  }
  EXPECT_FALSE(problems_of(document).empty());  // 10^8 values would take gigabytes
  document["sweep"].push_back(document["sweep"][0]);
  const auto problems = problems_of(document);
  ASSERT_FALSE(problems.empty());
  EXPECT_THAT(problems[0].reason, HasSubstr("more than 100 entries"));
}

TEST(BadExperiment, RefusesANormalTiltThatCanReachTheGround) {
  const auto tilted = [](const char* law) { return with(least_experiment(), "/initial/tilt", law); };
  EXPECT_TRUE(problems_of(tilted(R"({"normal": {"mean": 0.0, "sigma": 0.5}})")).empty());
  const auto problems = problems_of(tilted(R"({"normal": {"mean": 0.0, "sigma": 5.0}})"));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].place, "/initial/tilt");
}

// A fraction of the mean may make a standard deviation that a condition may not have.
TEST(BadExperiment, MayHaveARelativeScatterOfALargeStandardDeviation) {
  const auto scattered = [](const char* share) {
    return with(without(example_experiment(), "sweep"), "/fluctuation/amplitude",
                "{\"relative_sigma\": " + std::string(share) + "}");
  };
  const Experiment read = experiment_in(scattered("1e5").dump());
  EXPECT_NO_THROW(check_experiment(read));
  const auto problems = problems_of(scattered("1e6"));
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].place, "/fluctuation/amplitude/relative_sigma");
}

TEST(CheckExperiment, TellsWhichConditionsAreBadAndNoMoreThanTwentyProblems) {
  Experiment experiment = experiment_in(least_experiment().dump());
  experiment.conditions.assign(40, experiment.conditions.front());
  EXPECT_NO_THROW(check_experiment(experiment));
  experiment.conditions[3].tolerance = 1.0;
  const auto problems_of_it = [&]() -> std::vector<base::Problem> {
    try {
      check_experiment(experiment);
    } catch (const base::InputError& error) {
      return error.problems();
    }
    return {};
  };
  const auto problems = problems_of_it();
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].place, "/accuracy/tolerance");
  EXPECT_THAT(problems[0].reason, ::testing::EndsWith(" (condition 3)"));
  for (Condition& condition : experiment.conditions) condition.confidence = 2.0;
  EXPECT_EQ(problems_of_it().size(), 20U);
}

}  // namespace
