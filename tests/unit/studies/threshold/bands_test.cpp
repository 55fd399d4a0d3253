// Bands of a number: of events that are known at every value, and how they look.

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/base/stop_request.hpp"
#include "rocking/studies/threshold/bands.hpp"
#include "rocking/studies/threshold/study.hpp"

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
            "the block overturns from 3.1 on, stands again from 4.7 to 6.2 and from 8 to 9");
  EXPECT_EQ(answer_to({{{3.1, 4.7}}}), "the block overturns from 3.1 on, stands again from 4.7 on");
  EXPECT_EQ(answer_to({{{0.0, 11.0}}}), "the block overturns from 1 on, where the range begins");
  EXPECT_EQ(answer_to({{}}), "the block overturns nowhere for amplitude from 1 to 10");
  EXPECT_EQ(
      answer_to({{{3.1, 4.7}}, {{2.5, 11.0}}, {}, {{0.0, 11.0}}}),
      "the block overturns from 1 on at restitution 0.3, the least of 4 combinations; in 1 the range begins inside a "
      "band; nowhere for amplitude from 1 to 10 in 1");
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

}  // namespace
}  // namespace rocking
