// Questions that callers in C++ ask: each number out of its range, each list of another length is refused with its place.

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "rocking/rocking.hpp"
#include "rocking/studies/cost/study.hpp"
#include "rocking/studies/infer/study.hpp"
#include "rocking/studies/orbits/study.hpp"
#include "rocking/studies/rare/study.hpp"

namespace rocking {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

Experiment swept_block() {
  return parse_experiment(R"({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
    "excitation": {"amplitude": 2, "frequency_ratio": 10, "phase_rad": {"uniform": [0, 6.28]}},
    "horizon": {"transient_periods": 5, "sampled_periods": 15}, "restitution": 0.9, "realisations": 12,
    "unknown": [{"parameter": "/restitution", "from": 0.8, "to": 0.95}],
    "sweep": [{"parameter": "/excitation/amplitude", "values": [2, 4]}]})");
}

/// The first problem of what `act` throws: its place and value; empty if it throws nothing.
template <class Act>
std::string refusal(const Act& act) {
  try {
    act();
  } catch (const base::InputError& error) {
    const base::Problem& first = error.problems().front();
    return first.place + " = " + first.value + ": " + first.reason;
  }
  return "";
}

template <class Question>
struct Refused {
  std::function<void(Question&)> change;
  const char* place_and_value;
};

class Questions : public ::testing::Test {
 protected:
  template <class Question, class Ask>
  void expect_refused(const Question& good, const Ask& ask, const std::vector<Refused<Question>>& all) {
    EXPECT_EQ(refusal([&] { ask(good); }), "");
    for (const auto& [change, place_and_value] : all) {
      Question changed = good;
      change(changed);
      EXPECT_THAT(refusal([&] { ask(changed); }), StartsWith(place_and_value));
    }
  }

  const Experiment experiment_ = swept_block();
};

TEST_F(Questions, AboutFragilityHaveAHazardCurveThatFalls) {
  const RunResult done = run(experiment_);
  const HazardCurve good{
      .name = "h", .intensity = "amplitude", .points = {{.intensity = 0.5, .rate = 1e-2}, {3.0, 1e-4}}};
  using Points = std::vector<HazardPoint>;
  const auto ask = [&](const Points& points) {
    FragilityQuestion question{.hazard = good};
    question.hazard->points = points;
    static_cast<void>(fragility(experiment_, done, question));
  };
  expect_refused<Points>(
      good.points, ask,
      {{[](Points& p) { p.clear(); }, "hazard/points = 0 points: a hazard curve needs at least two points"},
       {[](Points& p) { p.pop_back(); }, "hazard/points = 1 points"},
       {[](Points& p) { p[1].rate = p[0].rate; }, "hazard/points = : has the same rate of exceedance"},
       {[](Points& p) { p[1].intensity = 0.5; },
        "hazard/points/1/intensity = 0.5: is not above the intensity before it"},
       {[](Points& p) { p[1].rate = 1e-1; }, "hazard/points/1/rate = 0.1: is above the number before it"},
       {[](Points& p) { p[0].intensity = -1.0; }, "hazard/points/0/intensity = -1"},
       {[](Points& p) { p[1].rate = -1e-3; }, "hazard/points/1/rate = -0.001: must not be negative"},
       {[](Points& p) { p[0].rate = nan; }, "hazard/points/0/rate = nan"},
       {[](Points& p) { p[1].intensity = nan; }, "hazard/points/1/intensity = nan"},
       {[](Points& p) { p[1].intensity = infinite; }, "hazard/points/1/intensity = inf"}});
}

TEST_F(Questions, AboutFragilityHaveRareEstimatesOfOneProbabilityEach) {
  const RunResult done = run(experiment_);
  using Rare = std::vector<RareOfCurve>;
  const RareLevel level{.intensity = 1.5, .probability = 1e-4, .interval = {5e-5, 2e-4}, .relative_error = 0.1};
  const Rare good{{.others = {}, .event = {}, .level = level}};
  const auto ask = [&](const Rare& rare) { static_cast<void>(fragility(experiment_, done, {.rare = rare})); };
  expect_refused<Rare>(
      good, ask,
      {{[](Rare& r) { r.push_back(r[0]); }, "rare/1 = intensity 1.5: is a second estimate of the same probability"},
       {[](Rare& r) { r[0].level.probability = 0.0; }, "rare/0/level/probability = 0"},
       {[](Rare& r) { r[0].level.probability = nan; }, "rare/0/level/probability = nan"},
       {[](Rare& r) { r[0].level.intensity = -2.0; }, "rare/0/level/intensity = -2"},
       {[](Rare& r) { r[0].level.relative_error = nan; }, "rare/0/level/relative_error = nan"},
       {[](Rare& r) { r[0].level.degrees_of_freedom = 0.0; }, "rare/0/level/degrees_of_freedom = 0"},
       {[](Rare& r) {
          r[0].event = {EventName::tilt, nan};
        },
        "rare/0/event = nan"},
       {[](Rare& r) {
          r[0].event = {EventName::tilt, 0.5};
        },
        "rare = : has no estimate of an event that is asked for"}});
}

TEST_F(Questions, AboutFragilityHaveNumbersInRange) {
  const RunResult done = run(experiment_);
  const auto ask = [&](const FragilityQuestion& question) {
    static_cast<void>(fragility(experiment_, done, question));
  };
  expect_refused<FragilityQuestion>({}, ask,
                                    {{[](auto& q) {
                                        q.years = {50.0, nan};
                                      },
                                      "years/1 = nan"},
                                     {[](auto& q) { q.years = {0.0}; }, "years/0 = 0"}});
}

TEST_F(Questions, AboutRareEventsHaveRepetitionsThatCanBe) {
  RareQuestion good{.event = {rocking::EventName::tilt, 0.1}, .relative_error = 0.5, .particles = 20};
  good.earlier.emplace_back().repetitions.assign(16, {.estimate = 0.5, .ancestors = 10, .work = 20.0});
  const auto ask = [&](const RareQuestion& request) { check_question(experiment_, request); };
  expect_refused<RareQuestion>(
      good, ask,
      {{[](auto& r) { r.earlier[0].repetitions[3].estimate = nan; }, "earlier/0/repetitions/3/estimate = nan"},
       {[](auto& r) { r.earlier[0].repetitions[3].estimate = -0.1; }, "earlier/0/repetitions/3/estimate = -0.1"},
       {[](auto& r) { r.earlier[0].repetitions[3].estimate = infinite; }, "earlier/0/repetitions/3/estimate = inf"},
       {[](auto& r) { r.earlier[0].repetitions[0].work = nan; }, "earlier/0/repetitions/0/work = nan"},
       {[](auto& r) { r.earlier[0].repetitions.resize(100'000); },
        "earlier/0 = 100000 repetitions: must be fewer than 20000"},
       {[](auto& r) { r.earlier.resize(3); }, "earlier = 3 entries: must be at most one for each condition"},
       {[](auto& r) { r.particles = 19; }, "particles = 19: must be at least 20 and at most 100000"},
       {[](auto& r) { r.relative_error = nan; }, "relative_error = nan"},
       {[](auto& r) {
          r.event = {EventName::tilt, nan};
        },
        "event = \"nan\""},
       {[](auto& r) { r.seconds = nan; }, "seconds = nan"}});
  good.seconds = 1.0;
  EXPECT_THAT(refusal([&] { static_cast<void>(rare_probabilities(experiment_, good)); }),
              StartsWith("seconds = : needs"));
}

TEST_F(Questions, AboutCountedTestsHaveListsThatFit) {
  InferQuestion good{.tests = {.groups = {{.name = "overturned", .modes = {{section::ResponseKind::overturned}}},
                                          {.name = "other", .modes = {}}},
                               .conditions = {{.parameters = {{"/excitation/amplitude", 4.0}}, .counts = {1, 4}}}}};
  good.tests.candidates = {{.parameters = {{"/excitation/amplitude", 3.0}}, .counts = {}}};
  good.earlier = {{.at = {0.8}, .counts = {{2, 10}, {0, 12}}}};
  const auto ask = [&](const InferQuestion& request) { check_question(experiment_, request); };
  expect_refused<InferQuestion>(
      good, ask,
      {{[](auto& r) { r.tests.groups.clear(); }, "tests/groups = 0 groups"},
       {[](auto& r) { r.tests.conditions.clear(); }, "tests = 0 conditions"},
       {[](auto& r) { r.tests.conditions[0].counts = {1}; },
        "tests/0/counts = 1 entries: must be 2, one for each group"},
       {[](auto& r) {
          r.tests.conditions[0].counts = {0, 0};
        },
        "tests/0/counts = : has no tests"},
       {[](auto& r) {
          r.tests.conditions[0].counts = {1, 1'000'001};
        },
        "tests/0/counts/1 = 1000001"},
       {[](auto& r) { r.tests.conditions.resize(1001, r.tests.conditions[0]); }, "tests = 1001 conditions"},
       {[](auto& r) { r.tests.conditions[0].parameters[0].pointer = "amplitude"; }, "tests/0/parameters/0 = amplitude"},
       {[](auto& r) { r.tests.conditions[0].parameters[0].pointer = "/excitation/~"; }, "tests/0/parameters/0 = /exc"},
       {[](auto& r) { r.tests.conditions[0].parameters[0].pointer = "/restitution"; },
        "tests/0/parameters/0 = /restitution: is an unknown"},
       {[](auto& r) { r.tests.conditions[0].parameters[0].value = WrittenPart{"four"}; },
        "tests/0/parameters/0 = four: is not JSON text"},
       {[](auto& r) {
          r.tests.candidates[0].counts = {1, 4};
        },
        "candidates/0/counts = 2 entries: must be 0"},
       {[](auto& r) {
          r.earlier[0].at = {0.8, 0.9};
        },
        "earlier/0/at = 2 entries: must be 1, one for each unknown"},
       {[](auto& r) { r.earlier[0].at = {nan}; }, "earlier/0/at/0 = nan"},
       {[](auto& r) { r.earlier[0].counts.pop_back(); }, "earlier/0/counts = 1 entries"},
       {[](auto& r) { r.earlier[0].counts[1] = {12}; }, "earlier/0/counts/1 = 1 entries"},
       {[](auto& r) {
          r.earlier[0].counts[1] = {1, 2};
        },
        "earlier/0/counts/1 = 3 realisations: must be those of the"},
       {[](auto& r) { r.next_tests = 1001; }, "next_tests = 1001"},
       {[](auto& r) { r.seconds = infinite; }, "seconds = inf"}});
  InferQuestion bad_value = good;
  bad_value.earlier.clear();
  bad_value.tests.conditions[0].parameters[0].value = -4;
  EXPECT_THAT(refusal([&] { static_cast<void>(infer_unknowns(experiment_, bad_value)); }), HasSubstr("/amplitude"));
}

TEST_F(Questions, AboutCountedTestsHaveAnExperimentWithUnknownsInAText) {
  const auto ask = [](const Experiment& experiment) { check_infer(experiment); };
  expect_refused<Experiment>(experiment_, ask,
                             {{[](Experiment& e) { e.canonical_text.clear(); }, "/unknown = : is a place in a text"},
                              {[](Experiment& e) { e.conditions.clear(); }, "the experiment = : has no conditions"},
                              {[](Experiment& e) { e.unknowns.resize(4, e.unknowns[0]); }, "/unknown = 4 entries"},
                              {[](Experiment& e) { e.unknowns[0].to = nan; }, "/unknown/0/to = nan"},
                              {[](Experiment& e) { e.unknowns[0].to = 0.8; }, "/unknown/0/to = 0.8"}});
}

TEST_F(Questions, OfOtherStudiesHaveNumbersInRange) {
  const Experiment still = parse_experiment(
      R"({"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
          "excitation": {"amplitude": 2, "frequency_ratio": 10}, "restitution": 0.9,
          "horizon": {"transient_periods": 5, "sampled_periods": 15}})");
  expect_refused<TrajectoryRequest>({}, [&](const auto& request) { static_cast<void>(trajectory(still, request)); },
                                    {{[](auto& r) { r.condition = 1; }, "condition = 1"},
                                     {[](auto& r) { r.realisation = 1'000'000'000; }, "realisation = 1000000000"},
                                     {[](auto& r) { r.periods = 0; }, "periods = 0"},
                                     {[](auto& r) { r.samples_per_period = -1; }, "samples_per_period = -1"}});
  expect_refused<OrbitsQuestion>({}, [&](const auto& request) { static_cast<void>(checked(still, request)); },
                                 {{[](auto& r) { r.longest = 13; }, "longest = 13"},
                                  {[](auto& r) { r.from = nan; }, "from = nan"},
                                  {[](auto& r) { r.to = infinite; }, "to = inf"},
                                  {[](auto& r) { r.most_points = 0; }, "most_points = 0"}});
  expect_refused<CostQuestion>({}, [&](const auto& request) { check_question(still, request); },
                               {{[](auto& r) { r.seconds = nan; }, "seconds = nan"},
                                {[](auto& r) { r.sample = 0; }, "sample = 0"},
                                {[](auto& r) { r.tolerances.push_back(nan); }, "tolerances/0 = nan"}});
  expect_refused<MotionQuestion>({}, [](const auto& request) { static_cast<void>(motion(request)); },
                                 {{[](auto& r) { r.format = "xls"; }, "format = xls: must be one of columns"},
                                  {[](auto& r) { r.units = "gal"; }, "units = gal: must be one of"},
                                  {[](auto& r) { r.time_step = infinite; }, "time_step = inf"},
                                  {[](auto& r) { r.gravity = nan; }, "gravity = nan"},
                                  {[](auto& r) { r.damping = 1.0; }, "damping = 1"},
                                  {[](auto& r) { r.periods.back() = -1.0; }, "periods/9 = -1"},
                                  {[](auto& r) { r.block.emplace(2, -1.0); }, "block = -1"}});
  expect_refused<SamplerQuestion>({.n = 20}, [](const auto& question) { static_cast<void>(check_normal(question)); },
                                  {{[](auto& q) { q.n = 19; }, "n = 19"},
                                   {[](auto& q) { q.mean = nan; }, "mean = nan"},
                                   {[](auto& q) { q.sigma = 0.0; }, "sigma = 0"},
                                   {[](auto& q) { q.sampler = "dice"; }, "sampler = dice: must be one of box-muller"}});
  expect_refused<Execution>({}, [&](const Execution& execution) { static_cast<void>(run(still, execution)); },
                            {{[](auto& e) { e.threads = 0; }, "threads = 0: must be at least 1 and at most 4096"},
                             {[](auto& e) { e.threads = 4097; }, "threads = 4097"},
                             {[](auto& e) { e.shard = Shard{.part = 3, .parts = 2}; }, "shard = 3/2"}});
  for (const double confidence : {nan, 0.0, 1.0, -infinite}) {
    EXPECT_THAT(refusal([&] { static_cast<void>(wilson(1, 2, confidence)); }), StartsWith("confidence = "));
    EXPECT_THAT(refusal([&] { static_cast<void>(clopper_pearson(1, 2, confidence)); }), StartsWith("confidence = "));
  }
  // Boost.Math gave up there.
  EXPECT_THAT(refusal([&] { static_cast<void>(clopper_pearson(4, 9, 3e-36)); }), StartsWith("confidence = "));
  EXPECT_THAT(refusal([&] { static_cast<void>(clopper_pearson(141'082'354'047, 801'859'547'590, 0.96875)); }),
              StartsWith("trials = 801859547590"));
}

TEST_F(Questions, AboutAReportHaveADurationThatCanBe) {
  const RunResult done = run(experiment_);
  for (const double duration : {nan, -1.0, infinite}) {
    EXPECT_THAT(refusal([&] { static_cast<void>(report(experiment_, done, {.duration_s = duration})); }),
                StartsWith("duration_s = "));
  }
}

TEST_F(Questions, TellTwentyProblemsAtMost) {
  RareQuestion request{.event = {rocking::EventName::tilt, 0.1}};
  request.earlier.emplace_back().repetitions.assign(1000, {.estimate = nan});
  try {
    check_question(experiment_, request);
    FAIL();
  } catch (const base::InputError& error) {
    EXPECT_EQ(error.problems().size(), 20U);
  }
}

}  // namespace
}  // namespace rocking
