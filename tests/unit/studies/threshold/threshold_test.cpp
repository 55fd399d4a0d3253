// Bands of a number: of events that are known at every value, and of blocks under pulses.

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/base/error.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/studies/threshold/bands.hpp"
#include "rocking/studies/threshold/study.hpp"
#include "rocking/text/json.hpp"
#include "support/temporary_folder.hpp"

namespace rocking {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

using Bands = std::vector<std::array<double, 2>>;

/// An event that happens in these bands, ends included.
PointAt event_in(const std::vector<Bands>& cases) {
  return [cases](std::size_t place, double value) {
    const auto has = [value](const std::array<double, 2>& band) { return band[0] <= value && value <= band[1]; };
    return ThresholdPoint{.value = value,
                          .happens = std::ranges::any_of(cases[place], has),
                          .impacts = static_cast<std::uint64_t>(10.0 * std::abs(value))};
  };
}

ThresholdQuestion scan(double from, double to, std::uint64_t steps, double accuracy = 1e-9) {
  return {.of = "/excitation/amplitude", .from = from, .to = to, .steps = steps, .accuracy = accuracy};
}

ThresholdBands found_in(const Bands& bands, const ThresholdQuestion& question) {
  return bands_of(1, question, event_in({bands}), {}).front();
}

/// Every edge is between its two values, which are as near as asked.
void expect_edges(const ThresholdBands& found, const std::vector<double>& right, double accuracy) {
  ASSERT_THAT(found.edges, SizeIs(right.size()));
  for (std::size_t i = 0; i < right.size(); ++i) {
    const ThresholdEdge& edge = found.edges[i];
    const auto [low, high] = std::minmax(edge.stands.value, edge.happens.value);
    EXPECT_LE(low, right[i]);
    EXPECT_GE(high, right[i]);
    EXPECT_LE(high - low, accuracy * std::max(std::abs(low), std::abs(high))) << right[i];
    EXPECT_TRUE(edge.happens.happens);
    EXPECT_FALSE(edge.stands.happens);
    EXPECT_EQ(edge.stands.impacts, static_cast<std::uint64_t>(10.0 * std::abs(edge.stands.value)));
  }
}

TEST(ThresholdBands, HaveTheEdgesOfAKnownEventToTheAccuracy) {
  for (const double accuracy : {1e-3, 1e-9, 1e-14}) {
    const ThresholdBands found = found_in({{3.1, 4.7}, {6.2, 8.0}}, scan(1.0, 10.0, 90, accuracy));
    expect_edges(found, {3.1, 4.7, 6.2, 8.0}, accuracy);
    ASSERT_THAT(found.bands, SizeIs(2));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(found.bands[i / 2][i % 2], found.edges[i].happens.value);
    EXPECT_THAT(found.gaps(), ElementsAre(ElementsAre(found.edges[1].stands.value, found.edges[2].stands.value)));
    EXPECT_FALSE(found.begins_inside());
    EXPECT_FALSE(found.ends_inside());
  }
}

TEST(ThresholdBands, EndAtNeighbouringDoublesWithoutAnAccuracy) {
  const double edge = 0.1 + 0.2;
  for (const double sign : {1.0, -1.0}) {
    const Bands band{sign > 0.0 ? std::array{edge, 9.0} : std::array{-9.0, -edge}};
    const ThresholdBands found = found_in(band, scan(-1.0, 1.0, 7, 0.0));
    ASSERT_THAT(found.edges, SizeIs(1));
    EXPECT_EQ(found.edges[0].happens.value, sign * edge);
    EXPECT_EQ(found.edges[0].stands.value, std::nextafter(sign * edge, 0.0));
  }
}

TEST(ThresholdBands, BeginAndEndWithTheRange) {
  const ThresholdBands whole = found_in({{0.0, 9.0}}, scan(1.0, 2.0, 10));
  EXPECT_THAT(whole.bands, ElementsAre(ElementsAre(1.0, 2.0)));
  EXPECT_THAT(whole.edges, IsEmpty());
  EXPECT_TRUE(whole.begins_inside() && whole.ends_inside());
  const ThresholdBands start = found_in({{0.0, 1.5}}, scan(1.0, 2.0, 10));
  EXPECT_EQ(start.bands.at(0)[0], 1.0);
  EXPECT_TRUE(start.begins_inside() && !start.ends_inside());
  EXPECT_THAT(start.gaps(), IsEmpty());
  const ThresholdBands end = found_in({{1.5, 9.0}}, scan(1.0, 2.0, 10));
  EXPECT_EQ(end.bands.at(0)[1], 2.0);
  EXPECT_TRUE(!end.begins_inside() && end.ends_inside());
  const ThresholdBands both = found_in({{0.0, 1.2}, {1.7, 9.0}}, scan(1.0, 2.0, 10));
  EXPECT_TRUE(both.begins_inside() && both.ends_inside());
  EXPECT_THAT(both.gaps(), SizeIs(1));
  const ThresholdBands last = found_in({{2.0, 9.0}}, scan(1.0, 2.0, 10));
  EXPECT_THAT(last.bands, ElementsAre(ElementsAre(2.0, 2.0))) << "the band begins at the end of the range";
  EXPECT_TRUE(last.ends_inside());
  const ThresholdBands none = found_in({}, scan(1.0, 2.0, 10));
  EXPECT_THAT(none.bands, IsEmpty());
  EXPECT_FALSE(none.begins_inside() || none.ends_inside());
}

TEST(ThresholdBands, MissOnlyWhatIsNarrowerThanAStep) {
  const Bands narrow{{1.501, 1.549}};
  EXPECT_THAT(found_in(narrow, scan(1.0, 2.0, 10)).bands, IsEmpty());
  EXPECT_THAT(found_in(narrow, scan(1.0, 2.0, 25)).bands, SizeIs(1));
  EXPECT_THAT(found_in({{1.0, 1.501}, {1.549, 2.0}}, scan(1.0, 2.0, 10)).gaps(), IsEmpty());
}

TEST(ThresholdBands, AreTheSameOnAnyNumberOfThreads) {
  const std::vector<Bands> cases{{{3.1, 4.7}}, {}, {{1.0, 2.0}, {5.5, 9.0}}};
  const auto edges_on = [&cases](unsigned threads) {
    std::vector<std::uint64_t> bits;
    std::uint64_t last = 0;
    RunOptions options;
    options.threads = threads;
    options.on_progress = [&last](std::uint64_t done, std::uint64_t all) {
      EXPECT_EQ(done, ++last);
      EXPECT_LE(done, all);
    };
    for (const ThresholdBands& each : bands_of(cases.size(), scan(1.0, 10.0, 60), event_in(cases), options)) {
      for (const auto& [stands, happens] : each.edges) {
        bits.push_back(std::bit_cast<std::uint64_t>(stands.value));
        bits.push_back(std::bit_cast<std::uint64_t>(happens.value));
      }
    }
    EXPECT_EQ(last, 3U * 61U + 5U) << "motions of the scan, and edges";
    return bits;
  };
  EXPECT_THAT(edges_on(1), SizeIs(10));
  EXPECT_EQ(edges_on(1), edges_on(5));
}

TEST(ThresholdBands, TellWhereAMotionHasNoAnswer) {
  const PointAt point_at = [](std::size_t, double value) {
    const bool is_lost = value > 1.25 && value < 1.45;
    return ThresholdPoint{
        .value = value,
        .happens = value > 1.75,
        .termination = is_lost ? dynamics::Termination::painleve : dynamics::Termination::reached_horizon};
  };
  const ThresholdBands found = bands_of(1, scan(1.0, 2.0, 10), point_at, {}).front();
  EXPECT_THAT(found.without_answer, ElementsAre(1.3, 1.4));
  EXPECT_THAT(found.bands, SizeIs(1));
}

TEST(ThresholdBands, AreNotSoughtWhenStopped) {
  std::atomic<bool> stop{true};
  RunOptions options;
  options.stop_requested = &stop;
  EXPECT_THROW(static_cast<void>(bands_of(1, scan(1.0, 2.0, 10), event_in({{}}), options)), base::Stopped);
}

// --- of an experiment

Json under_a_pulse() {
  return Json::parse(
      R"({ "format": "rocking.experiment/1", "title": "pulse", "block": { "width_m": 1.0, "height_m": 4.0 },
    "excitation": { "kind": "pulse", "shape": "sine", "amplitude": 1.0, "frequency_ratio": 5.0 },
    "restitution": { "rate_ratio": 0.9 } })");
}

ThresholdQuestion of_amplitude(double from, double to) { return scan(from, to, 40); }

ThresholdStudy asked(const Json& experiment, const ThresholdQuestion& question) {
  return thresholds(experiment_in(experiment.dump()), question);
}

std::string refused(const Json& experiment, const ThresholdQuestion& question) {
  try {
    check_request(experiment_in(experiment.dump()), question);
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
  for (const std::size_t i : {0, 1}) {
    experiment["excitation"].erase("suite");
    experiment["excitation"]["file"] = i == 0 ? "a.txt" : "b.txt";
    const ThresholdStudy one = thresholds(experiment_in(experiment.dump(), {}, seen_from(files)), question);
    EXPECT_THAT(one.conditions.at(0).found.bands, SizeIs(testing::Ge(1U)));
    EXPECT_EQ(one.conditions[0].found.bands, study.conditions[i].found.bands);
  }
}

TEST(Thresholds, RefuseWhatIsRandomAndSayWhatToUse) {
  Json drawn = under_a_pulse();
  drawn["block"]["width_m"] = Json::parse(R"({ "normal": { "mean": 1.0, "sigma": 0.01 } })");
  EXPECT_THAT(refused(drawn, of_amplitude(1.0, 2.0)),
              AllOf(HasSubstr("/block/width_m"), HasSubstr("is random"), HasSubstr("rocking fragility")));
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
  EXPECT_NE(refused(pulse, scan(1.0, 2.0, 0)), "");
  EXPECT_NE(refused(pulse, scan(1.0, 2.0, 10, -1.0)), "");
  Experiment without_text = experiment_in(pulse.dump());
  without_text.canonical_text.clear();
  EXPECT_THROW(check_request(without_text, of_amplitude(1.0, 2.0)), base::InputError);
}

// --- how it looks

/// The answer about an amplitude at one value of the restitution for each list of bands.
ThresholdStudy made_up(const std::vector<Bands>& cases, const ThresholdQuestion& question) {
  ThresholdStudy study{.question = question, .conditions = {}};
  for (ThresholdBands& found : bands_of(cases.size(), question, event_in(cases), {})) {
    std::vector<Parameter> parameters;
    if (cases.size() > 1) parameters.push_back({"/restitution", 0.1 * static_cast<double>(study.conditions.size())});
    study.conditions.push_back({std::move(parameters), std::move(found)});
  }
  return study;
}

std::string answer_to(const std::vector<Bands>& cases) {
  const std::string text = threshold_table(made_up(cases, scan(1.0, 10.0, 90)));
  return text.substr(0, text.find('\n'));
}

TEST(ThresholdTable, BeginsWithTheAnswer) {
  EXPECT_EQ(answer_to({{{3.1, 4.7}, {6.2, 8.0}, {9.0, 11.0}}}),
            "overturns from 3.1 on, stands again from 4.7 to 6.2 and from 8 to 9");
  EXPECT_EQ(answer_to({{{3.1, 4.7}}}), "overturns from 3.1 on, stands again from 4.7 on");
  EXPECT_EQ(answer_to({{{0.0, 11.0}}}), "overturns from 1 on, where the range begins");
  EXPECT_EQ(answer_to({{}}), "never overturns for amplitude from 1 to 10");
  EXPECT_EQ(answer_to({{{3.1, 4.7}}, {{2.5, 11.0}}, {}, {{0.0, 11.0}}}),
            "overturns from 1 on at restitution 0.3, the least of 4 combinations; in 1 the range begins inside a band; "
            "never for amplitude from 1 to 10 in 1");
}

TEST(ThresholdTable, HasARowForEachBandAndSaysWhatMayBeMissed) {
  const std::string text = threshold_table(made_up({{{3.1, 4.7}, {6.2, 11.0}}, {}}, scan(1.0, 10.0, 90)));
  EXPECT_THAT(text, AllOf(HasSubstr("scanned in 90 steps of 0.1"), HasSubstr("may be missed"), HasSubstr("never")));
  EXPECT_THAT(text, ::testing::ContainsRegex("3\\.1[0-9]* +31 +30 +4\\.[0-9]+ +4[67] +47\n"));
  EXPECT_THAT(text, ::testing::ContainsRegex("6\\.2[0-9]* +6[12] +6[12] +10 +- +-\n"));
}

TEST(ThresholdFigure, IsDrawnOverAnotherNumberAndOnlyThere) {
  const ThresholdQuestion question = scan(1.0, 10.0, 90);
  ThresholdReport report{.input = {.experiment = {{"title", "t"}}, .sha256 = ""},
                         .study = made_up({{{3.1, 4.7}, {6.2, 11.0}}, {}, {{0.0, 11.0}}}, question)};
  const auto figure = analysis::threshold_figure(report);
  ASSERT_TRUE(figure);
  ASSERT_THAT(figure->tables, SizeIs(2));
  EXPECT_THAT(figure->tables[0].rows, SizeIs(3)) << "bands";
  ASSERT_THAT(figure->tables[1].rows, SizeIs(3)) << "values of the other number";
  EXPECT_TRUE(std::holds_alternative<double>(figure->tables[1].rows[0][1]));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(figure->tables[1].rows[1][1])) << "nothing happens";
  EXPECT_TRUE(std::holds_alternative<std::monostate>(figure->tables[1].rows[2][1])) << "it begins below the range";
  EXPECT_EQ(figure->panels.at(0).y.high, 10.0);
  report.study = made_up({{{3.1, 4.7}}}, question);
  EXPECT_FALSE(analysis::threshold_figure(report));
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
