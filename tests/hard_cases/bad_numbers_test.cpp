// A denormal number, an infinity or NaN in every place that takes a number: either it is refused with its place, or it
// is valid and the results of the run are finite.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/input/record_formats.hpp"
#include "rocking/output/report.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

constexpr std::array<const char*, 12> bad_numbers{"1e-320", "-1e-320", "5e-324", "1e308",    "-1e308", "-0.0",
                                                  "1e400",  "-1e400",  "NaN",    "Infinity", "-nan",   "1e-400"};

Json parse(const char* text) { return Json::parse(text); }

/// Files that contain every key with a numeric value, with a short horizon.
std::vector<Json> full_experiments() {
  return {parse(R"({
    "format": "rocking.experiment/1", "block": { "width_m": 1.0, "height_m": 4.0, "gravity_m_s2": 9.81 },
    "restitution": 0.1, "excitation": { "amplitude": 4.2, "frequency_ratio": 10.0, "phase_rad": 0.5 },
    "friction": { "static": 0.35, "kinetic": 0.30 },
    "fluctuation": { "static_friction": { "sigma": 0.03 }, "kinetic_friction": { "sigma": 0.02 },
                     "restitution": { "sigma": 0.01 }, "amplitude": { "sigma": 0.2 } },
    "initial": { "tilt": 0.1, "tilt_rate": 0.2, "slip_rate": 0.3 },
    "horizon": { "transient_periods": 2, "sampled_periods": 3 }, "accuracy": { "tolerance": 1e-10 },
    "realisations": 3, "confidence": 0.95, "seed": 7,
    "sweep": [ { "parameter": "/block/height_m", "from": 3.0, "to": 4.0, "step": 0.5 } ] })"),
          parse(R"({
    "format": "rocking.experiment/1", "block": { "width_m": 1.0, "height_m": 4.0 },
    "excitation": { "amplitude": 4.2, "frequency_ratio": 10.0, "phase_rad": { "uniform": [0.1, 6.0] } },
    "friction": { "static": 0.35, "kinetic": 0.30 },
    "fluctuation": { "friction": { "relative_sigma": 0.1, "refreshes_per_period": 20 },
                     "amplitude": { "relative_sigma": 0.1 } },
    "initial": { "tilt": { "normal": { "mean": 0.1, "sigma": 0.2 } }, "tilt_rate": { "uniform": [-0.1, 0.1] },
                 "slip_rate": { "normal": { "mean": 0.1, "sigma": 0.2 } } },
    "horizon": { "transient_periods": 2, "sampled_periods": 3 }, "realisations": 3,
    "sweep": [ { "parameter": "/excitation/amplitude", "values": [1.0, 2.0] } ] })"),
          parse(R"({
    "format": "rocking.experiment/1", "block": { "width_m": 1.0, "height_m": 4.0, "gravity_m_s2": 9.81 },
    "excitation": { "kind": "recorded", "file": "any", "scale": 1.5, "time_step_s": 0.1, "columns": ["horizontal", "vertical"],
                    "frequency_ratio": 10.0 },
    "friction": { "static": 0.35, "kinetic": 0.30 }, "initial": { "tilt": 0.1 },
    "horizon": { "transient_periods": 2, "sampled_periods": 3 } })")};
}

std::string record_file(const std::string&, std::size_t) { return "0 0\n3 1\n-4 9\n0 -12\n"; }

/// The pointers of all numbers below `value`.
void collect_numbers(const Json& value, const std::string& pointer, std::vector<std::string>& numbers) {
  if (value.is_number()) numbers.push_back(pointer);
  if (value.is_object()) {
    for (const auto& [key, child] : value.items()) collect_numbers(child, child_pointer(pointer, key), numbers);
  }
  if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      collect_numbers(value[i], child_pointer(pointer, std::to_string(i)), numbers);
    }
  }
}

bool is_finite(const Json& value) {
  if (value.is_number_float()) return std::isfinite(value.get<double>());
  return !value.is_structured() || std::all_of(value.begin(), value.end(), is_finite);
}

/// The text of `document` with the value at `pointer` replaced by a word.
std::string with_word(Json document, const std::string& pointer, const std::string& word) {
  document[Json::json_pointer(pointer)] = "PLACE";
  std::string text = document.dump();
  return text.replace(text.find("\"PLACE\""), 7, word);
}

/// Whether a problem is reported at the key of the number, at the object that contains it, or, for a sweep, at its
/// other numbers or its target.
bool names(const base::InputError& error, const std::string& pointer, const Json& document) {
  const bool in_sweep = pointer.starts_with("/sweep/");
  const auto is_of = [&](const base::Problem& problem) {
    const std::string place = problem.place.substr(0, problem.place.find(' '));
    if (!place.starts_with('/')) return false;
    if (in_sweep && place == document["sweep"][0]["parameter"].get<std::string>()) return true;
    return pointer.starts_with(place) || place.starts_with(in_sweep ? "/sweep/0" : pointer);
  };
  return std::any_of(error.problems().begin(), error.problems().end(), is_of);
}

/// Runs the experiment and checks all numbers that its report would contain.
void expect_finite_result(const Experiment& read, const std::string& what) {
  auto result = run(read, {});
  ASSERT_TRUE(result) << what;
  EXPECT_NO_THROW(static_cast<void>(report_document().text(report_of(read, *std::move(result), {})))) << what;
  for (std::size_t i = 0; i < read.conditions.size(); ++i) {
    const auto& horizon = read.conditions[i].horizon;
    const auto trajectory =
        trajectory_of(read.conditions[i], read.seed, 0, horizon.transient_periods + horizon.sampled_periods);
    for (const auto& sample : trajectory.strobe) {
      ASSERT_TRUE(std::isfinite(sample.tilt) && std::isfinite(sample.tilt_rate)) << what;
      ASSERT_TRUE(std::isfinite(sample.slip) && std::isfinite(sample.slip_rate)) << what;
    }
    for (const auto& event : trajectory.events) ASSERT_TRUE(std::isfinite(event.tau)) << what;
  }
}

TEST(BadNumber, InAnyKeyOfAnExperimentIsRefusedByItsNameOrRunsToFiniteNumbers) {
  int refused = 0;
  int ran = 0;
  for (const Json& document : full_experiments()) {
    std::vector<std::string> pointers;
    collect_numbers(document, "", pointers);
    for (const std::string& pointer : pointers) {
      for (const char* word : bad_numbers) {
        const std::string what = pointer + " = " + word;
        try {
          const auto read = experiment_in(with_word(document, pointer, word), {}, {.files = record_file});
          ++ran;
          expect_finite_result(read, what);
        } catch (const base::InputError& error) {
          ++refused;
          EXPECT_TRUE(names(error, pointer, document)) << what << ": " << error.what();
        }
      }
    }
  }
  EXPECT_GT(refused, 300);
  EXPECT_GT(ran, 100) << "a denormal is a number";
}

// --- a ground motion
// -------------------------------------------------------------------------------------------------------

TEST(BadNumber, InAnyPlaceOfAGroundMotionIsRefusedWithItsLineOrIsANumber) {
  const std::vector<std::vector<std::string>> lines{
      {"0", "0", "0"}, {"0.5", "2", "1"}, {"0.7", "-2", "-3"}, {"0.9", "0", "0"}};
  int read = 0;
  for (std::size_t row = 0; row < lines.size(); ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      for (const char* word : bad_numbers) {
        auto changed = lines;
        changed[row][column] = word;
        std::ostringstream text;
        for (const auto& line : changed) text << line[0] << ' ' << line[1] << ' ' << line[2] << '\n';
        const std::string what = "line " + std::to_string(row + 1) + ": " + word;
        Problems problems;
        GroundMotionReading how{.name = "record.txt", .time_step = {}, .gravity = 9.81};
        how.columns = {RecordColumn::time, RecordColumn::horizontal, RecordColumn::vertical};
        const auto motion = read_ground_motion(text.str(), how, problems);
        ASSERT_EQ(motion.has_value(), problems.empty()) << what;
        for (const base::Problem& problem : problems) {
          EXPECT_EQ(problem.place, "record.txt, line " + std::to_string(row + 1)) << what;
        }
        if (!motion) continue;
        ++read;
        Condition condition;
        condition.scene.excitation = support::recorded_by(*motion, 5.0);
        condition.horizon = {.transient_periods = 0, .sampled_periods = 3};
        for (const auto& point : realise(condition, 0, 0).strobe) {
          ASSERT_TRUE(std::isfinite(point.tilt) && std::isfinite(point.tilt_rate)) << what;
        }
      }
    }
  }
  EXPECT_GT(read, 30) << "a denormal is a number";
}

// --- the command line
// --------------------------------------------------------------------------------------------------

class CommandLine : public support::ProgramTest {};

TEST_F(CommandLine, RefusesBadNumbersAsUsageOrInputAndNeverAsItsOwnFault) {
  write("quick.json", support::quick_experiment().dump());
  const std::array<const char*, 8> commands{"run quick.json --dry-run -j ",
                                            "run quick.json --dry-run --seed ",
                                            "run quick.json --dry-run --realisations ",
                                            "trajectory quick.json --periods ",
                                            "trajectory quick.json --condition ",
                                            "trajectory quick.json --realisation ",
                                            "check-normal --n ",
                                            "check-normal --seed "};
  for (const char* command : commands) {
    for (const char* word : bad_numbers) {
      const auto outcome = rocking(std::string(command) + word);
      EXPECT_TRUE(outcome.exit_code == 64 || outcome.exit_code == 65) << command << word << ": " << outcome.exit_code;
      EXPECT_NE(outcome.errors, "") << command << word;
    }
  }
}

TEST_F(CommandLine, TakesNoLawThatIsNone) {
  for (const std::string option : {"--mean ", "--sigma "}) {
    for (const std::string word : {"nan", "-nan", "NaN", "inf", "-inf", "1e400", "1e308"}) {
      EXPECT_EQ(rocking("check-normal --n 100 " + option + word).exit_code, 64) << option << word;
    }
  }
  const auto outcome = rocking("check-normal --n 100 --json --mean 1e-320");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(is_finite(Json::parse(outcome.output)));
}

// --- the library's structs
// ---------------------------------------------------------------------------------------------

/// A scene that uses each of its numbers.
Condition full_condition() {
  Condition condition;
  condition.scene.excitation = Harmonic{.amplitude = 4.0, .frequency_ratio = 10.0, .phase = 0.5};
  condition.scene.friction = Friction{.static_coefficient = 0.35, .kinetic_coefficient = 0.3};
  condition.scene.fluctuation = {.static_friction = 0.03,
                                 .kinetic_friction = 0.03,
                                 .refreshes_per_period = 20,
                                 .restitution = 0.01,
                                 .amplitude = 0.1};
  condition.scene.initial = {.tilt = 0.2, .tilt_rate = 0.1, .slip_rate = 0.1};
  condition.horizon = {.transient_periods = 1, .sampled_periods = 2};
  return condition;
}

struct Place {
  const char* pointer;
  std::function<void(Condition&, double)> put;
  bool may_be_zero;
};

std::vector<Place> places() {
  return {
      {"/block/width_m", [](auto& c, double x) { c.scene.block.width = x; }, false},
      {"/block/height_m", [](auto& c, double x) { c.scene.block.height = x; }, false},
      {"/block/gravity_m_s2", [](auto& c, double x) { c.scene.block.gravity = x; }, false},
      {"/restitution", [](auto& c, double x) { c.scene.restitution = x; }, true},
      {"/excitation/amplitude", [](auto& c, double x) { support::harmonic(c.scene).amplitude = x; }, true},
      {"/excitation/frequency_ratio", [](auto& c, double x) { support::harmonic(c.scene).frequency_ratio = x; }, false},
      {"/excitation/amplitude_g",
       [](auto& c, double x) {
         support::harmonic(c.scene).physical_amplitude = PhysicalAmplitude{x, AccelerationUnit::gravity};
       },
       true},
      {"/excitation/amplitude_m_s2",
       [](auto& c, double x) {
         support::harmonic(c.scene).physical_amplitude = PhysicalAmplitude{x, AccelerationUnit::m_s2};
       },
       true},
      {"/excitation/frequency_hz",
       [](auto& c, double x) {
         support::harmonic(c.scene).physical_frequency = PhysicalFrequency{x, FrequencyUnit::hertz};
       },
       false},
      {"/excitation/period_s",
       [](auto& c, double x) {
         support::harmonic(c.scene).physical_frequency = PhysicalFrequency{x, FrequencyUnit::period_s};
       },
       false},
      {"/restitution/rate_ratio", [](auto& c, double x) { c.scene.restitution = RateRatio{x}; }, false},
      {"/excitation/phase_rad", [](auto& c, double x) { support::harmonic(c.scene).phase = x; }, true},
      {"/friction/static",
       [](auto& c, double x) {  // kinetic friction is not above it
         const double kinetic = std::min(mean_kinetic(*c.scene.friction), x);
         c.scene.friction = Friction{.static_coefficient = x, .kinetic_coefficient = kinetic};
       },
       true},
      {"/friction/kinetic", [](auto& c, double x) { c.scene.friction->kinetic_coefficient = x; }, true},
      {"/fluctuation/static_friction/sigma", [](auto& c, double x) { c.scene.fluctuation.static_friction = x; }, true},
      {"/fluctuation/kinetic_friction/sigma", [](auto& c, double x) { c.scene.fluctuation.kinetic_friction = x; },
       true},
      {"/fluctuation/restitution/sigma", [](auto& c, double x) { c.scene.fluctuation.restitution = x; }, true},
      {"/fluctuation/amplitude/sigma", [](auto& c, double x) { c.scene.fluctuation.amplitude = x; }, true},
      {"/initial/tilt", [](auto& c, double x) { c.scene.initial.tilt = x; }, true},
      {"/initial/tilt_rate", [](auto& c, double x) { c.scene.initial.tilt_rate = x; }, true},
      {"/initial/slip_rate", [](auto& c, double x) { c.scene.initial.slip_rate = x; }, true},
      {"/accuracy/tolerance", [](auto& c, double x) { c.tolerance = x; }, false}};
}

// Structs filled in by a C++ caller do not pass the reader of experiment files.
TEST(BadNumber, InAnyPlaceOfASceneIsRefusedByItsName) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  for (const Place& place : places()) {
    for (const double x : {std::nan(""), infinite, -infinite}) {
      Condition condition = full_condition();
      place.put(condition, x);
      try {
        static_cast<void>(realise(condition, 0, 0));
        ADD_FAILURE() << place.pointer << " = " << x << " was run";
      } catch (const base::InputError& error) {
        EXPECT_EQ(error.problems().at(0).place, place.pointer) << x;
      }
    }
  }
}

// Valid numbers, however large, run to their end or to the budget of steps, a million per period, or are refused.
TEST(HugeNumber, InAnyPlaceOfASceneEndsTheRun) {
  for (const Place& place : places()) {
    for (const double x : {1e308, -1e308, 1e154, -1e154}) {
      Condition condition = full_condition();
      place.put(condition, x);
      try {
        const auto result = realise(condition, 0, 0);
        EXPECT_LE(result.operations.steps, 3'000'003U) << place.pointer << " = " << x;
        for (const auto& point : result.strobe) EXPECT_TRUE(std::isfinite(point.tilt)) << place.pointer << " = " << x;
      } catch (const base::InputError& error) {
        EXPECT_TRUE(std::string(place.pointer).starts_with(error.problems().at(0).place)) << place.pointer;
      }
    }
  }
}

// A nearly zero value has nearly no effect, or is refused where zero is not allowed.
TEST(Denormal, InAPlaceThatMayBeZeroGivesTheMotionOfZero) {
  for (const Place& place : places()) {
    Condition tiny = full_condition();
    tiny.scene.fluctuation.static_friction = 0.0;  // any slip rate stops, however small, and a stop draws
    place.put(tiny, 1e-320);
    if (!place.may_be_zero) {
      EXPECT_THROW(static_cast<void>(realise(tiny, 0, 0)), base::InputError) << place.pointer;
      continue;
    }
    Condition zero = full_condition();
    zero.scene.fluctuation.static_friction = 0.0;
    place.put(zero, 0.0);
    const auto a = realise(tiny, 0, 0);
    const auto b = realise(zero, 0, 0);
    ASSERT_EQ(a.strobe.size(), b.strobe.size()) << place.pointer;
    for (std::size_t k = 0; k < a.strobe.size(); ++k) {
      EXPECT_NEAR(a.strobe[k].tilt, b.strobe[k].tilt, 1e-12) << place.pointer;
      EXPECT_NEAR(a.strobe[k].tilt_rate, b.strobe[k].tilt_rate, 1e-12) << place.pointer;
      EXPECT_NEAR(a.strobe[k].slip_rate, b.strobe[k].slip_rate, 1e-12) << place.pointer;
    }
  }
}

}  // namespace
}  // namespace rocking
