// A condition that comes from C++ gets the checks of an experiment file: the same thing done to both is told at the
// same place, with the same reason and remedy.

#include <functional>
#include <limits>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "rocking/input/read_experiment.hpp"
#include "rocking/scene/check_condition.hpp"
#include "support/excitation.hpp"
#include "support/experiment_text.hpp"

namespace rocking {
namespace {

using support::harmonic;
using support::recorded;

std::string record_of_file(const std::string&, std::size_t) { return "0 0 0\n1 2 1\n2 -1 0\n"; }

Experiment read(const Json& document) { return experiment_in(document.dump(), {}, {.files = record_of_file}); }

/// A file that has every key of a condition.
Json full_document() {
  return Json::parse(R"({
    "format": "rocking.experiment/1", "block": { "width_m": 1.0, "height_m": 4.0, "gravity_m_s2": 9.81 },
    "slide_inertia": "centroidal", "restitution": 0.1,
    "excitation": { "amplitude": 4.2, "frequency_ratio": 10.0, "phase_rad": 0.5 },
    "friction": { "static": 0.35, "kinetic": 0.30 },
    "fluctuation": { "static_friction": { "sigma": 0.03 }, "kinetic_friction": { "sigma": 0.02, "refreshes_per_period": 20 },
                     "restitution": { "sigma": 0.01 }, "amplitude": { "sigma": 0.2 } },
    "initial": { "tilt": 0.1, "tilt_rate": 0.2, "slip_rate": 0.3 },
    "horizon": { "transient_periods": 2, "sampled_periods": 100 }, "accuracy": { "tolerance": 1e-10, "rerun_every": 5 },
    "realisations": 3, "confidence": 0.95 })");
}

Json recorded_document() {
  auto document = support::with(full_document(), "/excitation",
                                R"({"kind": "recorded", "file": "any", "columns": ["time", "horizontal", "vertical"],
                                    "scale": 1.5, "frequency_ratio": 10.0})");
  document["fluctuation"].erase("amplitude");
  return document;
}

/// Keys of a file and what stands there instead; an empty text removes the key.
using Edits = std::vector<std::pair<std::string, std::string>>;

Json edited(Json document, const Edits& edits) {
  for (const auto& [pointer, value] : edits) {
    const Json::json_pointer place(pointer);
    if (!value.empty()) {
      document[place] = Json::parse(value);
    } else {
      document.at(place.parent_pointer()).erase(place.back());
    }
  }
  return document;
}

/// One thing done to a file and to a condition, and where it is told.
struct Change {
  Edits of_file;
  std::function<void(Condition&)> of_condition;
  std::vector<std::string> places;
};

void PrintTo(const Change& change, std::ostream* out) {
  for (const auto& [pointer, value] : change.of_file) *out << pointer << " = " << value << ' ';
}

/// A number at `place` that is `value` in both.
Change number(const std::string& place, const std::string& value, std::function<void(Condition&)> put) {
  return {{{place, value}}, std::move(put), {place}};
}

std::vector<base::Problem> problems_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const base::InputError& error) {
    return error.problems();
  }
  return {};
}

void expect_equal_problems(const Json& sound, const Change& change) {
  const Json bad = edited(sound, change.of_file);
  const auto of_file = problems_of([&] { static_cast<void>(read(bad)); });
  Condition condition = read(sound).conditions.at(0);
  EXPECT_NO_THROW(check_condition(condition));
  change.of_condition(condition);
  const auto of_condition = problems_of([&] { check_condition(condition); });
  ASSERT_EQ(of_file.size(), change.places.size()) << base::InputError(of_file).what();
  ASSERT_EQ(of_condition.size(), change.places.size()) << base::InputError(of_condition).what();
  for (std::size_t i = 0; i < change.places.size(); ++i) {
    EXPECT_EQ(of_file[i].place, change.places[i]);
    EXPECT_EQ(of_condition[i].place, of_file[i].place);
    EXPECT_EQ(of_condition[i].reason, of_file[i].reason);
    EXPECT_EQ(of_condition[i].remedy, of_file[i].remedy);
    const Json value = Json::parse(of_condition[i].value, nullptr, false);
    if (!value.is_number()) continue;
    EXPECT_EQ(value, bad.at(Json::json_pointer(of_file[i].place)));
  }
}

class HarmonicChange : public ::testing::TestWithParam<Change> {};
TEST_P(HarmonicChange, IsToldOfAConditionAsOfAFile) { expect_equal_problems(full_document(), GetParam()); }

class RecordedChange : public ::testing::TestWithParam<Change> {};
TEST_P(RecordedChange, IsToldOfAConditionAsOfAFile) { expect_equal_problems(recorded_document(), GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Numbers, HarmonicChange,
    ::testing::Values(
        number("/block/width_m", "-0.1", [](auto& c) { c.scene.block.width = -0.1; }),
        number("/block/height_m", "1e7", [](auto& c) { c.scene.block.height = 1e7; }),
        number("/block/gravity_m_s2", "0", [](auto& c) { c.scene.block.gravity = 0; }),
        number("/restitution", "-1", [](auto& c) { c.scene.restitution = -1.0; }),
        number("/restitution", "1.5", [](auto& c) { c.scene.restitution = 1.5; }),
        number("/excitation/amplitude", "-1", [](auto& c) { harmonic(c.scene).amplitude = -1; }),
        number("/excitation/frequency_ratio", "0", [](auto& c) { harmonic(c.scene).frequency_ratio = 0; }),
        number("/excitation/phase_rad", "1001", [](auto& c) { harmonic(c.scene).phase = 1001.0; }),
        number("/friction/static", "1e7", [](auto& c) { c.scene.friction->static_coefficient = 1e7; }),
        number("/friction/kinetic", "-0.3", [](auto& c) { c.scene.friction->kinetic_coefficient = -0.3; }),
        number("/fluctuation/static_friction/sigma", "-1", [](auto& c) { c.scene.fluctuation.static_friction = -1; }),
        number("/fluctuation/kinetic_friction/sigma", "1e7",
               [](auto& c) { c.scene.fluctuation.kinetic_friction = 1e7; }),
        number("/fluctuation/kinetic_friction/refreshes_per_period", "0",
               [](auto& c) { c.scene.fluctuation.refreshes_per_period = 0; }),
        number("/fluctuation/kinetic_friction/refreshes_per_period", "100001",
               [](auto& c) { c.scene.fluctuation.refreshes_per_period = 100001; }),
        Change{{{"/fluctuation/kinetic_friction/refreshes_per_period", ""},
                {"/fluctuation/kinetic_friction/refresh_slip_m", "0"}},
               [](auto& c) { c.scene.fluctuation.refresh_slip_m = 0.0; },
               {"/fluctuation/kinetic_friction/refresh_slip_m"}},
        number("/fluctuation/restitution/sigma", "-1", [](auto& c) { c.scene.fluctuation.restitution = -1; }),
        number("/fluctuation/amplitude/sigma", "-1", [](auto& c) { c.scene.fluctuation.amplitude = -1; }),
        number("/initial/tilt", "1e7", [](auto& c) { c.scene.initial.tilt = 1e7; }),
        number("/initial/tilt_rate", "-1e7", [](auto& c) { c.scene.initial.tilt_rate = -1e7; }),
        number("/initial/slip_rate", "1e7", [](auto& c) { c.scene.initial.slip_rate = 1e7; })));

INSTANTIATE_TEST_SUITE_P(
    NumbersOfTheRun, HarmonicChange,
    ::testing::Values(number("/horizon/transient_periods", "-1", [](auto& c) { c.horizon.transient_periods = -1; }),
                      number("/horizon/sampled_periods", "0", [](auto& c) { c.horizon.sampled_periods = 0; }),
                      number("/accuracy/tolerance", "1e-17", [](auto& c) { c.tolerance = 1e-17; }),
                      number("/accuracy/tolerance", "0.1", [](auto& c) { c.tolerance = 0.1; }),
                      number("/accuracy/rerun_every", "1000000001", [](auto& c) { c.rerun_every = 1'000'000'001; }),
                      number("/realisations", "0", [](auto& c) { c.realisations = 0; }),
                      number("/confidence", "1", [](auto& c) { c.confidence = 1; }),
                      Change{{{"/realisations", R"({"until": {"half_width": 0.5, "at_most": 9}})"}},
                             [](auto& c) { c.realisations = 9, c.until = Until{0.5}; },
                             {"/realisations/until/half_width"}},
                      Change{{{"/realisations", R"({"until": {"half_width": 0.1, "at_most": 0}})"}},
                             [](auto& c) { c.realisations = 0, c.until = Until{0.1}; },
                             {"/realisations/until/at_most"}},
                      Change{
                          {{"/realisations", R"({"until": {"relative_half_width": 1, "mode": "rest", "at_most": 9}})"}},
                          [](auto& c) {
                            c.realisations = 9;
                            c.until = Until{.relative_half_width = 1.0,
                                            .mode = section::ResponseMode{section::ResponseKind::rest}};
                          },
                          {"/realisations/until/relative_half_width"}},
                      Change{{{"/realisations", R"({"until": {"at_most": 9}})"}},
                             [](auto& c) { c.realisations = 9, c.until = Until{}; },
                             {"/realisations/until"}},
                      Change{{{"/realisations", R"({"until": {"relative_half_width": 0.1, "at_most": 9}})"}},
                             [](auto& c) { c.realisations = 9, c.until = Until{.relative_half_width = 0.1}; },
                             {"/realisations/until/mode"}}));

INSTANTIATE_TEST_SUITE_P(
    Laws, HarmonicChange,
    ::testing::Values(Change{{{"/initial/tilt", R"({"uniform": [0.2, 0.1]})"}},
                             [](auto& c) {
                               c.scene.initial.tilt = Uniform{0.2, 0.1};
                             },
                             {"/initial/tilt/uniform"}},
                      Change{{{"/initial/tilt_rate", R"({"uniform": [-1e7, 1e7]})"}},
                             [](auto& c) {
                               c.scene.initial.tilt_rate = Uniform{-1e7, 1e7};
                             },
                             {"/initial/tilt_rate/uniform/0", "/initial/tilt_rate/uniform/1"}},
                      Change{{{"/initial/slip_rate", R"({"normal": {"mean": 1e7, "sigma": -1}})"}},
                             [](auto& c) {
                               c.scene.initial.slip_rate = Normal{1e7, -1};
                             },
                             {"/initial/slip_rate/normal/mean", "/initial/slip_rate/normal/sigma"}},
                      Change{{{"/excitation/phase_rad", R"({"normal": {"mean": 0, "sigma": -1}})"}},
                             [](auto& c) {
                               harmonic(c.scene).phase = Normal{0, -1};
                             },
                             {"/excitation/phase_rad/normal/sigma"}}));

INSTANTIATE_TEST_SUITE_P(
    Between, HarmonicChange,
    ::testing::Values(Change{{{"/friction/static", "0.2"}},
                             [](auto& c) { c.scene.friction->static_coefficient = 0.2; },
                             {"/friction/static"}},
                      Change{{{"/friction", R"({"static": 2, "kinetic": 1.34})"}},
                             [](auto& c) {
                               c.scene.friction = Friction{2, 1.34};
                             },
                             {"/friction/kinetic"}},
                      Change{{{"/friction", R"({"static": 1, "kinetic": 2})"}},
                             [](auto& c) {
                               c.scene.friction = Friction{1, 2};
                             },
                             {"/friction/static"}},
                      Change{{{"/friction", R"({"static": 2, "kinetic": 1.667})"}, {"/slide_inertia", "\"edge\""}},
                             [](auto& c) {
                               c.scene.friction = Friction{2, 1.667};
                               c.scene.slide_inertia = dynamics::SlideInertia::edge;
                             },
                             {"/friction/kinetic"}},
                      Change{
                          {{"/initial/tilt", "6.42"}}, [](auto& c) { c.scene.initial.tilt = 6.42; }, {"/initial/tilt"}},
                      Change{{{"/initial/tilt", R"({"uniform": [-7, 0]})"}},
                             [](auto& c) {
                               c.scene.initial.tilt = Uniform{-7, 0};
                             },
                             {"/initial/tilt"}},
                      Change{{{"/initial/tilt", R"({"normal": {"mean": 0, "sigma": 5}})"}},
                             [](auto& c) {
                               c.scene.initial.tilt = Normal{0, 5};
                             },
                             {"/initial/tilt"}},
                      Change{{{"/friction", ""}},
                             [](auto& c) { c.scene.friction.reset(); },
                             {"/fluctuation/static_friction", "/fluctuation/kinetic_friction", "/initial/slip_rate"}}));

/// Physical units in place of A_h, Omega_h and e, of the same file.
Json physical_document() {
  auto document = full_document();
  document["excitation"] = Json::parse(R"({"amplitude_g": 1.0, "frequency_hz": 3.0, "phase_rad": 0.5})");
  document["restitution"] = Json::parse(R"({"rate_ratio": 0.9})");
  return document;
}

void set(Condition& condition, double amplitude, AccelerationUnit unit) {
  harmonic(condition.scene).physical_amplitude = PhysicalAmplitude{amplitude, unit};
}
void set(Condition& condition, double frequency, FrequencyUnit unit) {
  harmonic(condition.scene).physical_frequency = PhysicalFrequency{frequency, unit};
}

/// Another unit in place of the one of the file.
Change in_unit(const std::string& key, const std::string& value, std::function<void(Condition&)> put) {
  const std::string old = key.starts_with("amplitude") ? "/excitation/amplitude_g" : "/excitation/frequency_hz";
  const std::string place = "/excitation/" + key;
  return {{{old, ""}, {place, value}}, std::move(put), {place}};
}

class PhysicalChange : public ::testing::TestWithParam<Change> {};
TEST_P(PhysicalChange, IsToldOfAConditionAsOfAFile) { expect_equal_problems(physical_document(), GetParam()); }

INSTANTIATE_TEST_SUITE_P(
    Numbers, PhysicalChange,
    ::testing::Values(
        number("/excitation/amplitude_g", "-0.1", [](auto& c) { set(c, -0.1, AccelerationUnit::gravity); }),
        number("/excitation/amplitude_g", "1.1e6", [](auto& c) { set(c, 1.1e6, AccelerationUnit::gravity); }),
        in_unit("amplitude_m_s2", "-1e-9", [](auto& c) { set(c, -1e-9, AccelerationUnit::m_s2); }),
        number("/excitation/frequency_hz", "0", [](auto& c) { set(c, 0.0, FrequencyUnit::hertz); }),
        in_unit("period_s", "-2", [](auto& c) { set(c, -2.0, FrequencyUnit::period_s); }),
        number("/restitution/rate_ratio", "1.5", [](auto& c) { c.scene.restitution = RateRatio{1.5}; }),
        number("/restitution/rate_ratio", "-0.9", [](auto& c) { c.scene.restitution = RateRatio{-0.9}; }),
        Change{{{"/restitution/rate_ratio", "[0.9, 1.5]"}},
               [](auto& c) { c.scene.restitution = RateRatio{.value = 0.9, .right = 1.5}; },
               {"/restitution/rate_ratio/1"}}));

// psi is 0.245, and p 1.889 rad/s: A_h = 1e6 is 0.245e6 g, Omega_h = 0.001 is 3.01e-4 Hz. e = 1 is the ratio 0.8235.
INSTANTIATE_TEST_SUITE_P(
    Relations, PhysicalChange,
    ::testing::Values(
        number("/excitation/amplitude_g", "245000", [](auto& c) { set(c, 245000, AccelerationUnit::gravity); }),
        Change{{{"/block/width_m", "1e-6"}, {"/restitution", "0"}, {"/excitation/amplitude_g", "10"}},
               [](auto& c) {
                 c.scene.block.width = 1e-6;
                 c.scene.restitution = 0.0;
                 set(c, 10.0, AccelerationUnit::gravity);
               },
               {"/excitation/amplitude_g"}},
        Change{{{"/fluctuation/amplitude/sigma", "245000"}},
               [](auto& c) { c.scene.fluctuation.amplitude = 245000; },
               {"/fluctuation/amplitude"}},
        number("/excitation/frequency_hz", "3e-4", [](auto& c) { set(c, 3e-4, FrequencyUnit::hertz); }),
        number("/excitation/frequency_hz", "302000", [](auto& c) { set(c, 302000, FrequencyUnit::hertz); }),
        in_unit("period_s", "3350", [](auto& c) { set(c, 3350, FrequencyUnit::period_s); }),
        in_unit("period_s", "3e-6", [](auto& c) { set(c, 3e-6, FrequencyUnit::period_s); }),
        Change{{{"/initial/tilt", ""}, {"/initial/tilt_rad", "1.6"}},
               [](auto& c) {
                 c.scene.initial.tilt = 1.6;
                 c.scene.initial.units.tilt = StateUnit::si;
               },
               {"/initial/tilt_rad"}},
        Change{{{"/restitution/rate_ratio", "[0.823, 0.8]"}},
               [](auto& c) { c.scene.restitution = RateRatio{.value = 0.823, .right = 0.8}; },
               {"/restitution/rate_ratio/0"}},
        number("/restitution/rate_ratio", "0.823", [](auto& c) { c.scene.restitution = RateRatio{0.823}; })));

// The limits that a remedy names are allowed, and a little beyond them is not.
TEST(PhysicalUnits, AreAllowedUpToTheLimitsOfEveryBlockThatCanBeDrawn) {
  Condition condition = read(physical_document()).conditions.at(0);
  const auto is_sound = [&condition] { return problems_of([&] { check_condition(condition); }).empty(); };
  condition.scene.block.width = Uniform{1.0, 2.0};
  condition.scene.restitution = RateRatio{0.8236};
  EXPECT_TRUE(is_sound());
  condition.scene.block.width = Uniform{0.99, 2.0};
  EXPECT_FALSE(is_sound()) << "the most slender block needs e > 1";
  condition.scene.restitution = 0.0;
  set(condition, 0.24e6, AccelerationUnit::gravity);
  EXPECT_TRUE(is_sound());
  condition.scene.block.width = Uniform{0.97, 2.0};
  EXPECT_FALSE(is_sound()) << "A_h of the most slender block";
  set(condition, 1.0, AccelerationUnit::gravity);
  condition.scene.block.width = 1.0;
  set(condition, 3.01e-4, FrequencyUnit::hertz);
  EXPECT_TRUE(is_sound());
  condition.scene.block.height = Uniform{3.9, 4.1};
  EXPECT_FALSE(is_sound()) << "Omega_h of the smallest block";
}

INSTANTIATE_TEST_SUITE_P(Numbers, RecordedChange,
                         ::testing::Values(number("/excitation/scale", "-1",
                                                  [](auto& c) { recorded(c.scene).scale = -1; }),
                                           number("/excitation/frequency_ratio", "1e7",
                                                  [](auto& c) { recorded(c.scene).frequency_ratio = 1e7; }),
                                           Change{{{"/fluctuation/amplitude", R"({"sigma": 0.1})"}},
                                                  [](auto& c) { c.scene.fluctuation.amplitude = 0.1; },
                                                  {"/fluctuation/amplitude"}}));

// A relation is not checked of a number that is refused.
TEST(CheckCondition, TellsARelationOnlyOfNumbersThatAreAllowed) {
  Condition condition = read(full_document()).conditions.at(0);
  condition.scene.block.width = std::numeric_limits<double>::quiet_NaN();
  condition.scene.friction = Friction{1.0, 50.0};
  const auto problems = problems_of([&] { check_condition(condition); });
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[0].place, "/block/width_m");
  EXPECT_EQ(problems[0].value, "nan");
  EXPECT_EQ(problems[1].place, "/friction/static");
}

TEST(CheckCondition, RefusesAGroundMotionAsItsFileIsRefused) {
  const std::vector<std::string> files{"",
                                       "0 0 0\n",
                                       "1 0 0\n1 1 0\n",
                                       "-1 0 0\n1 1 0\n",
                                       "0 0 0\n2 1 0\n1 1 0\n",
                                       "0 0 0\n1e8 1 0\n",
                                       "0 0 0\n1 2e6 0\n2 0 0\n",
                                       "0 0 0\n1 0 -2e6\n"};
  const std::vector<std::vector<dynamics::GroundMotionSample>> motions{{},
                                                                       {{0, 0, 0}},
                                                                       {{1, 0, 0}, {1, 1, 0}},
                                                                       {{-1, 0, 0}, {1, 1, 0}},
                                                                       {{0, 0, 0}, {2, 1, 0}, {1, 1, 0}},
                                                                       {{0, 0, 0}, {1e8, 1, 0}},
                                                                       {{0, 0, 0}, {1, 2e6 / 9.81, 0}, {2, 0, 0}},
                                                                       {{0, 0, 0}, {1, 0, -2e6 / 9.81}}};
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto source = [&](const std::string&, std::size_t) { return files[i]; };
    const auto of_file =
        problems_of([&] { static_cast<void>(experiment_in(recorded_document().dump(), {}, {.files = source})); });
    Condition condition = read(recorded_document()).conditions.at(0);
    recorded(condition.scene).ground_motion = std::make_shared<const GroundMotion>(GroundMotion{motions[i], true});
    const auto of_condition = problems_of([&] { check_condition(condition); });
    ASSERT_EQ(of_file.size(), 1U) << files[i];
    ASSERT_EQ(of_condition.size(), 1U) << files[i];
    EXPECT_EQ(of_condition[0].place, "/excitation/file");
    const std::string reason = of_file[0].reason;
    EXPECT_THAT(of_condition[0].reason, ::testing::StartsWith(i == 4 ? reason.substr(0, reason.find(',')) : reason));
    EXPECT_EQ(of_condition[0].remedy, of_file[0].remedy);
  }
}

TEST(CheckCondition, AcceptsTheLargestAccelerationThatAFileMayHave) {
  for (const double gravity : {9.81, 1e-6, 3.7, 1e6}) {
    Condition condition = read(recorded_document()).conditions.at(0);
    condition.scene.block.gravity = gravity;
    const GroundMotion motion{{{0, 0, 0}, {1, 1e6 / gravity, -1e6 / gravity}}, true};
    recorded(condition.scene).ground_motion = std::make_shared<const GroundMotion>(motion);
    EXPECT_NO_THROW(check_condition(condition)) << gravity;
  }
}

TEST(CheckCondition, MissesAGroundMotion) {
  Condition condition = read(recorded_document()).conditions.at(0);
  recorded(condition.scene).ground_motion = nullptr;
  const auto problems = problems_of([&] { check_condition(condition); });
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].place, "/excitation/file");
}

}  // namespace
}  // namespace rocking
