// The one list of keys (scene/experiment_keys.hpp), as a reader of files and of the schema sees it.

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "rocking/input/read_experiment.hpp"
#include "rocking/scene/defaults.hpp"
#include "rocking/scene/rules.hpp"
#include "rocking/text/json.hpp"
#include "support/experiment_text.hpp"

namespace rocking {
namespace {

/// Every schema of a number at a place that an experiment with harmonic excitation may have.
void collect_numbers(const Json& schema, const std::string& place, std::map<std::string, Json>& numbers) {
  const std::string type = schema.value("type", "");
  if (type == "number" || type == "integer") numbers.emplace(place, schema);
  if (schema.contains("oneOf")) collect_numbers(schema["oneOf"].front(), place, numbers);
  if (!schema.contains("properties")) return;
  for (const auto& [key, child] : schema["properties"].items()) collect_numbers(child, place + '/' + key, numbers);
}

/// Whether the value at a place of an otherwise small experiment is refused; of other places nothing is looked at.
bool is_refused(const std::string& place, const Json& value) {
  Json document = support::least_experiment();
  if (place.starts_with("/excitation/amplitude")) document["excitation"].erase("amplitude");
  if (place == "/excitation/frequency_hz" || place == "/excitation/period_s") {
    document["excitation"].erase("frequency_ratio");
  }
  document[Json::json_pointer(place)] = value;
  try {
    static_cast<void>(experiment_in(document.dump()));
  } catch (const base::InputError& error) {
    for (const base::Problem& problem : error.problems()) {
      if (problem.place == place && problem.reason.starts_with("must")) return true;
    }
  }
  return false;
}

TEST(SchemaOfExperiments, HasTheBoundsThatTheReaderKeeps) {
  std::map<std::string, Json> numbers;
  collect_numbers(Json::parse(experiment_schema_text()), "", numbers);
  numbers.erase("/seed");
  ASSERT_GT(numbers.size(), 30U);
  for (const auto& [place, schema] : numbers) {
    const double step = schema["type"] == "integer" ? 1.0 : 0.0;
    for (const double side : {-1.0, 1.0}) {
      const std::string inclusive = side < 0.0 ? "minimum" : "maximum";
      const std::string exclusive = side < 0.0 ? "exclusiveMinimum" : "exclusiveMaximum";
      ASSERT_NE(schema.contains(inclusive), schema.contains(exclusive)) << place << ' ' << inclusive;
      const bool is_inclusive = schema.contains(inclusive);
      const auto bound = schema[is_inclusive ? inclusive : exclusive].get<double>();
      const double beyond = step == 0.0 ? std::nextafter(bound, side * 1e300) : bound + side;
      EXPECT_EQ(is_refused(place, bound), !is_inclusive) << place << ' ' << bound;
      EXPECT_TRUE(is_refused(place, beyond)) << place << ' ' << beyond;
    }
  }
}

TEST(AFileThatSaysTheLeast, GivesTheDefaultsOfTheStructs) {
  const auto read = experiment_in(support::least_experiment().dump());
  const Condition& condition = read.conditions.at(0);
  const Condition standard;
  EXPECT_EQ(condition.scene.block.gravity, standard.scene.block.gravity);
  EXPECT_EQ(condition.scene.slide_inertia, standard.scene.slide_inertia);
  EXPECT_EQ(condition.scene.impact_slip_rule, standard.scene.impact_slip_rule);
  EXPECT_EQ(condition.scene.restitution, standard.scene.restitution);
  EXPECT_EQ(start_phase(condition.scene.excitation), start_phase(standard.scene.excitation));
  EXPECT_EQ(condition.scene.initial.tilt, standard.scene.initial.tilt);
  EXPECT_EQ(condition.scene.initial.tilt_rate, standard.scene.initial.tilt_rate);
  EXPECT_EQ(condition.scene.initial.slip_rate, standard.scene.initial.slip_rate);
  EXPECT_EQ(condition.horizon.transient_periods, standard.horizon.transient_periods);
  EXPECT_EQ(condition.horizon.sampled_periods, standard.horizon.sampled_periods);
  EXPECT_EQ(condition.tolerance, standard.tolerance);
  EXPECT_EQ(condition.rerun_every, standard.rerun_every);
  EXPECT_EQ(condition.realisations, standard.realisations);
  EXPECT_EQ(condition.confidence, standard.confidence);
}

TEST(DefaultStrobe, IsOneSecondWithinTheBoundsOfTheRatio) {
  const dynamics::Block block{.width = 1.0, .height = 4.0, .gravity = 9.81};
  const double p = dynamics::geometry_of(block).frequency_parameter;
  EXPECT_DOUBLE_EQ(strobe_once_a_second(block) * p, 2.0 * 3.14159265358979323846);
  for (const double size : {1e-6, 1e6}) {
    for (const double gravity : {1e-6, 1e6}) {
      EXPECT_TRUE(rules::frequency_ratio.allows(strobe_once_a_second({size, size, gravity}))) << size << ' ' << gravity;
    }
  }
}

}  // namespace
}  // namespace rocking
