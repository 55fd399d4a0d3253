// Bands of an experiment: blocks under pulses and records, and what is refused.

#include <cmath>
#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/base/error.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/studies/threshold/study.hpp"
#include "rocking/text/files.hpp"
#include "support/temporary_folder.hpp"

namespace rocking {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;

Json under_a_pulse() {
  return Json::parse(
      R"({ "format": "rocking.experiment/1", "title": "pulse", "block": { "width_m": 1.0, "height_m": 4.0 },
    "excitation": { "kind": "pulse", "shape": "sine", "amplitude": 1.0, "frequency_ratio": 5.0 },
    "restitution": { "rate_ratio": 0.9 } })");
}

ThresholdQuestion of_amplitude(double from, double to) {
  return {.of = "/excitation/amplitude", .from = from, .to = to, .steps = 40};
}

ThresholdStudy asked(const Json& experiment, const ThresholdQuestion& question) {
  return thresholds(experiment_in(experiment.dump()), question);
}

std::string refused(const Json& experiment, const ThresholdQuestion& question) {
  try {
    check_question(experiment_in(experiment.dump()), question);
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Thresholds, AreThoseOfRunsToTheBit) {
  const ThresholdStudy study = asked(under_a_pulse(), of_amplitude(1.0, 10.0));
  const ThresholdBands& found = study.conditions.at(0).found;
  ASSERT_THAT(found.edges, SizeIs(3));
  for (const ThresholdEdge& edge : found.edges) {
    for (const ThresholdPoint& side : {edge.stands, edge.happens}) {
      Json one = under_a_pulse();
      one["excitation"]["amplitude"] = side.value;
      const RealisationResult run = realise(experiment_in(one.dump()).conditions[0], 0, 0);
      EXPECT_EQ(run.termination, side.termination);
      EXPECT_EQ(run.termination == dynamics::Termination::overturned, side.happens);
    }
  }
}

TEST(Thresholds, AreFoundForEachCombinationOfTheOtherValues) {
  Json experiment = under_a_pulse();
  experiment["sweep"] = Json::parse(R"([ { "parameter": "/excitation/frequency_ratio", "values": [2.0, 5.0] },
    { "parameter": "/excitation/amplitude", "values": [1.0, 4.0, 10.0] },
    { "parameter": "/restitution/rate_ratio", "values": [0.8, 0.9] } ])");
  ThresholdQuestion question{.of = "/excitation/amplitude", .steps = 40};
  const ThresholdStudy study = asked(experiment, question);
  EXPECT_EQ(study.question.from, 1.0);
  EXPECT_EQ(study.question.to, 10.0);
  ASSERT_THAT(study.conditions, SizeIs(4));
  EXPECT_THAT(study.conditions[3].parameters, SizeIs(2));
  const ThresholdStudy alone = asked(under_a_pulse(), of_amplitude(1.0, 10.0));
  EXPECT_EQ(study.conditions[3].found.bands, alone.conditions[0].found.bands);
  EXPECT_NE(study.conditions[2].found.bands, alone.conditions[0].found.bands);
  question.to = 8.0;
  EXPECT_EQ(asked(experiment, question).question.to, 8.0) << "a flag replaces an end of the sweep";
}

TEST(Thresholds, AreOfOtherEventsToo) {
  ThresholdQuestion question = of_amplitude(1.0, 2.0);
  question.event = {.name = EventName::tilt, .threshold = 0.25};
  const double share = asked(under_a_pulse(), question).conditions[0].found.bands.at(0)[0];
  const double angle = 0.25 * std::atan(0.25);
  question.event = {EventName::tilt, angle, AskedTilt{.value = angle, .unit = TiltUnit::rad}};
  EXPECT_NEAR(asked(under_a_pulse(), question).conditions[0].found.bands.at(0)[0], share, 1e-8);
  question.event = {.name = EventName::slip, .threshold = 0.01};
  EXPECT_THAT(refused(under_a_pulse(), question), HasSubstr("the block has no friction"));
}

TEST(Thresholds, AreOfEachRecordOfASuite) {
  const support::TemporaryFolder folder;
  const std::filesystem::path files = folder / "";
  for (const char* name : {"a.txt", "b.txt"}) {
    std::string text;
    for (int i = 0; i <= 100; ++i) {
      text += Json(0.01 * i).dump() + ' ' + Json(std::sin((name[0] == 'a' ? 0.12 : 0.2) * i)).dump() + '\n';
    }
    write_atomically(files / name, text);
  }
  Json experiment = under_a_pulse();
  experiment["excitation"] =
      Json::parse(R"({ "kind": "recorded", "suite": ["a.txt", "b.txt"], "units": "g", "pga_g": 1.0 })");
  const ThresholdQuestion question{
      .of = "/excitation/pga_g", .from = 0.2, .to = 3.0, .steps = 14, .accuracy = 1e-3, .folder = files};
  const ThresholdStudy study =
      thresholds(experiment_in(experiment.dump(), {}, seen_from(files)), question, {.threads = 2});
  ASSERT_THAT(study.conditions, SizeIs(2));
  for (const std::size_t i : {0U, 1U}) {
    experiment["excitation"].erase("suite");
    experiment["excitation"]["file"] = i == 0 ? "a.txt" : "b.txt";
    const ThresholdStudy one = thresholds(experiment_in(experiment.dump(), {}, seen_from(files)), question);
    EXPECT_THAT(one.conditions.at(0).found.bands, SizeIs(testing::Ge(1U)));
    EXPECT_EQ(one.conditions[0].found.bands, study.conditions[i].found.bands);
  }
}

TEST(Thresholds, RefuseWhatIsRandomWithoutAProbability) {
  Json drawn = under_a_pulse();
  drawn["block"]["width_m"] = Json::parse(R"({ "normal": { "mean": 1.0, "sigma": 0.01 } })");
  EXPECT_THAT(refused(drawn, of_amplitude(1.0, 2.0)),
              AllOf(HasSubstr("/block/width_m"), HasSubstr("is random"), HasSubstr("--probability 0.5")));
  Json along = under_a_pulse();
  along["fluctuation"] = Json::parse(R"({ "restitution": { "sigma": 0.01 } })");
  EXPECT_THAT(refused(along, of_amplitude(1.0, 2.0)), HasSubstr("/fluctuation: is random"));
  EXPECT_THAT(refused(along, {.of = "/fluctuation/restitution/sigma", .from = 0.0, .to = 0.1}), HasSubstr("is random"));
}

TEST(Thresholds, RefuseAPlaceOrARangeThatIsNone) {
  const Json pulse = under_a_pulse();
  EXPECT_THAT(refused(pulse, {.of = "/excitation/amplitud", .from = 1.0, .to = 2.0}), HasSubstr("did you mean"));
  EXPECT_THAT(refused(pulse, {.of = "/excitation/shape", .from = 1.0, .to = 2.0}), HasSubstr("not a number"));
  EXPECT_THAT(refused(pulse, {.of = "", .from = 1.0, .to = 2.0}), HasSubstr("of"));
  EXPECT_THAT(refused(pulse, of_amplitude(2.0, 2.0)), HasSubstr("must be less than"));
  EXPECT_THAT(refused(pulse, of_amplitude(-1.0, 2.0)), HasSubstr("/excitation/amplitude"));
  EXPECT_THAT(refused(pulse, {.of = "/excitation/amplitude", .from = 1.0}), HasSubstr("to: is missing"));
  EXPECT_THAT(refused(pulse, {.of = "/horizon/sampled_periods", .from = 1.0, .to = 10.0}), HasSubstr("whole number"));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_NE(refused(pulse, of_amplitude(1.0, infinity)), "");
  EXPECT_NE(refused(pulse, of_amplitude(1.0, std::nan(""))), "");
  ThresholdQuestion question = of_amplitude(1.0, 2.0);
  question.steps = 0;
  EXPECT_NE(refused(pulse, question), "");
  question.steps = 10;
  question.accuracy = -1.0;
  EXPECT_NE(refused(pulse, question), "");
  Experiment without_text = experiment_in(pulse.dump());
  without_text.canonical_text.clear();
  EXPECT_THROW(check_question(without_text, of_amplitude(1.0, 2.0)), base::InputError);
}

TEST(ThresholdDocument, IsReadAsItWasWritten) {
  const Experiment experiment = experiment_in(under_a_pulse().dump());
  const ThresholdReport report{.input = input_of(experiment), .study = thresholds(experiment, of_amplitude(1.0, 10.0))};
  const std::string text = threshold_document().text(report);
  EXPECT_EQ(threshold_document().text(threshold_document().read(Json::parse(text))), text);
  const Json condition = Json::parse(text)["conditions"][0];
  EXPECT_EQ(condition["threshold"], condition["bands"][0][0]);
  EXPECT_EQ(condition["gaps"].size(), 1U);
  EXPECT_EQ(condition["ends_inside"], true);
}

}  // namespace
}  // namespace rocking
