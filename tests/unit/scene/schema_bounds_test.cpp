// The schema of experiment files repeats the bounds of scene/rules.hpp and the defaults of the structs. Each of them is
// compared here, so that none can differ.

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <variant>

#include <gtest/gtest.h>

#include "rocking/input/read_experiment.hpp"
#include "rocking/scene/defaults.hpp"
#include "rocking/scene/rules.hpp"
#include "rocking/text/schema.hpp"
#include "support/experiment_text.hpp"

namespace rocking {
namespace {

using Rule = std::variant<NumberRule, IntegerRule>;

void add_quantity(std::map<std::string, Rule>& all, const std::string& place, const NumberRule& rule) {
  for (const char* part : {"", "/uniform", "/normal/mean"}) all.emplace(place + part, rule);
  all.emplace(place + "/normal/sigma", rules::sigma);
}

/// The rule of each key that takes a number, by its place in a file; ends of an interval are elements of a list.
std::map<std::string, Rule> rules_by_place() {
  std::map<std::string, Rule> all{{"/block/gravity_m_s2", rules::gravity},
                                  {"/restitution", rules::restitution},
                                  {"/restitution/rate_ratio", rules::rate_ratio},
                                  {"/excitation/amplitude", rules::amplitude},
                                  {"/excitation/amplitude_g", rules::amplitude_g},
                                  {"/excitation/amplitude_m_s2", rules::amplitude_m_s2},
                                  {"/excitation/frequency_ratio", rules::frequency_ratio},
                                  {"/excitation/frequency_hz", rules::frequency_hz},
                                  {"/excitation/period_s", rules::period_s},
                                  {"/excitation/scale", rules::scale},
                                  {"/excitation/pga_g", rules::pga_g},
                                  {"/excitation/pgv_m_s", rules::pgv_m_s},
                                  {"/excitation/time_step_s", rules::time_step},
                                  {"/friction/static", rules::friction_coefficient},
                                  {"/friction/kinetic", rules::friction_coefficient},
                                  {"/fluctuation/friction/refreshes_per_period", rules::refreshes},
                                  {"/fluctuation/kinetic_friction/refreshes_per_period", rules::refreshes},
                                  {"/horizon/transient_periods", rules::transient_periods},
                                  {"/horizon/sampled_periods", rules::sampled_periods},
                                  {"/horizon/until_classified/at_most_periods", rules::at_most_periods},
                                  {"/horizon/until_classified/held_windows", rules::held_windows},
                                  {"/horizon/until_classified/watch_windows", rules::watch_windows},
                                  {"/horizon/until_classified/long_run_every", rules::long_run_every},
                                  {"/horizon/until_classified/exponent_pause", rules::exponent_pause},
                                  {"/accuracy/tolerance", rules::tolerance},
                                  {"/accuracy/rerun_every", rules::rerun_every},
                                  {"/realisations", rules::realisations},
                                  {"/realisations/until/half_width", rules::half_width},
                                  {"/realisations/until/relative_half_width", rules::relative_half_width},
                                  {"/realisations/until/at_most", rules::at_most},
                                  {"/check_labels/every", rules::check_every},
                                  {"/check_labels/times_longer", rules::times_longer},
                                  {"/confidence", rules::confidence}};
  for (const char* source : {"friction", "static_friction", "kinetic_friction", "restitution", "amplitude"}) {
    for (const char* key : {"/sigma", "/relative_sigma"})
      all.emplace(std::string("/fluctuation/") + source + key, rules::sigma);
  }
  for (const char* side : {"width_m", "height_m"}) add_quantity(all, std::string("/block/") + side, rules::length);
  add_quantity(all, "/excitation/phase_rad", rules::phase);
  for (const char* key : {"tilt", "tilt_rate", "slip_rate"}) {
    add_quantity(all, std::string("/initial/") + key, rules::initial_value);
  }
  return all;
}

/// Every schema of a number below `schema`, by the place that it describes. Sweep and seed have no bounds of ours.
void collect_numbers(const Json& schema, const std::string& place, std::multimap<std::string, Json>& numbers) {
  if (place == "/sweep" || place == "/seed") return;
  const std::string type = schema.value("type", "");
  if (type == "number" || type == "integer") numbers.emplace(place, schema);
  if (schema.contains("items")) collect_numbers(schema["items"], place, numbers);
  if (schema.contains("oneOf")) {
    for (const Json& choice : schema["oneOf"]) collect_numbers(choice, place, numbers);
  }
  if (!schema.contains("properties")) return;
  for (const auto& [key, child] : schema["properties"].items()) collect_numbers(child, place + '/' + key, numbers);
}

std::multimap<std::string, Json> numbers_of_schema() {
  std::multimap<std::string, Json> numbers;
  collect_numbers(Json::parse(*schema_text("experiment")), "", numbers);
  return numbers;
}

bool allows(const Rule& rule, double value) {
  if (const auto* number = std::get_if<NumberRule>(&rule)) return number->allows(value);
  return std::get<IntegerRule>(rule).allows(static_cast<std::int64_t>(value));
}

/// The next value beyond `bound` that the rule could allow.
double beyond(const Rule& rule, double bound, double side) {
  return std::holds_alternative<IntegerRule>(rule) ? bound + side : std::nextafter(bound, side * 1e300);
}

TEST(SchemaOfExperiments, HasTheBoundsOfTheRules) {
  const auto rules = rules_by_place();
  std::set<std::string> seen;
  for (const auto& [place, schema] : numbers_of_schema()) {
    ASSERT_TRUE(rules.contains(place)) << place << " has no rule";
    seen.insert(place);
    const Rule& rule = rules.at(place);
    EXPECT_EQ(schema["type"] == "integer", std::holds_alternative<IntegerRule>(rule)) << place;
    for (const double side : {-1.0, 1.0}) {
      const std::string inclusive = side < 0.0 ? "minimum" : "maximum";
      const std::string exclusive = side < 0.0 ? "exclusiveMinimum" : "exclusiveMaximum";
      ASSERT_NE(schema.contains(inclusive), schema.contains(exclusive)) << place << ' ' << inclusive;
      const bool is_inclusive = schema.contains(inclusive);
      const auto bound = schema[is_inclusive ? inclusive : exclusive].get<double>();
      EXPECT_EQ(allows(rule, bound), is_inclusive) << place << ' ' << bound;
      EXPECT_FALSE(allows(rule, beyond(rule, bound, side))) << place << " beyond " << bound;
      EXPECT_TRUE(allows(rule, beyond(rule, bound, -side))) << place << " within " << bound;
    }
  }
  EXPECT_EQ(seen.size(), rules.size()) << "a rule of no number of the schema";
}

TEST(Rules, AllowNothingThatIsNotFinite) {
  for (const auto& [place, rule] : rules_by_place()) {
    const auto* number = std::get_if<NumberRule>(&rule);
    if (number == nullptr) continue;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (const double x : {std::nan(""), infinite, -infinite}) EXPECT_FALSE(number->allows(x)) << place << ' ' << x;
  }
}

/// Defaults of the structs, by their place in a file.
std::map<std::string, Json> defaults_by_place() {
  const Condition condition;
  const LabelCheck check;
  const UntilClassified until;
  return {{"/block/gravity_m_s2", condition.scene.block.gravity},
          {"/formulation", "consistent"},
          {"/excitation/kind", name_of(Excitation())},
          {"/excitation/scale", Recorded{}.scale},
          {"/accuracy/tolerance", condition.tolerance},
          {"/accuracy/rerun_every", condition.rerun_every},
          {"/check_labels/every", check.every},
          {"/check_labels/times_longer", check.times_longer},
          {"/confidence", condition.confidence},
          {"/horizon/until_classified/held_windows", until.held_windows},
          {"/horizon/until_classified/watch_windows", until.watch_windows},
          {"/horizon/until_classified/long_run_every", until.long_run_every},
          {"/horizon/until_classified/exponent_pause", until.exponent_pause}};
}

void collect_defaults(const Json& schema, const std::string& place, std::map<std::string, Json>& defaults) {
  if (schema.contains("default")) defaults.emplace(place, schema["default"]);
  if (schema.contains("oneOf")) {
    for (const Json& choice : schema["oneOf"]) collect_defaults(choice, place, defaults);
  }
  if (!schema.contains("properties")) return;
  for (const auto& [key, child] : schema["properties"].items()) collect_defaults(child, place + '/' + key, defaults);
}

TEST(SchemaOfExperiments, HasTheDefaultsOfTheStructs) {
  std::map<std::string, Json> of_schema;
  collect_defaults(Json::parse(*schema_text("experiment")), "", of_schema);
  EXPECT_EQ(of_schema, defaults_by_place());
}

TEST(AFileThatSaysTheLeast, GivesTheDefaultsOfTheStructs) {
  const auto read = read_experiment(support::least_experiment().dump());
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
  EXPECT_EQ(condition.label_check.has_value(), standard.label_check.has_value());
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
