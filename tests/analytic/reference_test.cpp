// Our trajectories, compared with those of an independent program in 50 and 80 digits (tests/reference/README.md).

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "rocking/realisation/trajectory.hpp"
#include "support/reference_case.hpp"

namespace rocking {
namespace {

using nlohmann::json;
using tests::load_reference;
using tests::reference_names;

double number(const json& text) { return tests::reference_number(text); }

/// Error that a good implementation in double attains: a hundred times the error of the reference algorithm in double,
/// or 1e-12, whichever is larger.
double attainable(const std::string& name, int period) {
  static const json table = load_reference("attainable");
  const auto error = table.contains(name) && table[name].contains(std::to_string(period))
                         ? table[name][std::to_string(period)].get<double>()
                         : 0.0;
  return std::max(1e-12, 100.0 * error);
}

std::vector<TrajectoryEvent> without_past_balance(const Trajectory& trajectory) {
  std::vector<TrajectoryEvent> events = trajectory.events;
  std::erase_if(events, [](const auto& event) { return event.kind == dynamics::EventKind::past_balance; });
  return events;
}

class ReferenceTrajectory : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    reference_ = load_reference(GetParam());
    const std::int64_t periods = GetParam().starts_with("18") ? 5 : 20;
    trajectory_ = trajectory_of(tests::condition_of_reference(reference_), 0, 0, periods);
  }

  /// Event times and the states after them have the errors of the states at the ends of periods; the largest of the run
  /// is a bound.
  [[nodiscard]] double event_tolerance() const { return attainable(GetParam(), 20); }

  json reference_;
  Trajectory trajectory_;
};

TEST_P(ReferenceTrajectory, AgreesAtTheCycleEndsToTheAttainableDigits) {
  for (const json& row : reference_["cycle_ends"]) {
    const int period = row[0].get<int>();
    ASSERT_GE(trajectory_.strobe.size(), static_cast<std::size_t>(period));
    const auto& sample = trajectory_.strobe[static_cast<std::size_t>(period) - 1];
    const double tolerance = attainable(GetParam(), period);
    EXPECT_EQ(sample.period, period);
    EXPECT_NEAR(sample.tilt, number(row[1]), tolerance) << "period " << period;
    EXPECT_NEAR(sample.tilt_rate, number(row[2]), tolerance) << "period " << period;
    EXPECT_NEAR(sample.slip, number(row[3]), tolerance) << "period " << period;
    EXPECT_NEAR(sample.slip_rate, number(row[4]), tolerance) << "period " << period;
    const std::vector<std::string> contacts{"rest", "slide", "rock", "rock_slide"};
    EXPECT_EQ(to_string(sample.contact), contacts.at(row[6].get<std::size_t>())) << "period " << period;
  }
}

// Work is a sum over the whole run, so that errors of the motion enter it many times.
TEST_P(ReferenceTrajectory, TellsWhereItsEnergyCameFromAndWent) {
  const json& expected = reference_["energy_over_mR2p2"];
  const EnergyAccount& energy = trajectory_.energy;
  const double tolerance = 10.0 * event_tolerance();
  EXPECT_NEAR(energy.at_start, number(expected["E0"]), tolerance);
  EXPECT_NEAR(energy.base_work, number(expected["W_base"]), tolerance);
  EXPECT_NEAR(energy.friction_work, number(expected["W_friction"]), tolerance);
  EXPECT_NEAR(energy.gained_in_impacts - energy.lost_in_impacts, number(expected["W_impacts"]), tolerance);
  if (reference_["params"]["inertia"] == "centroidal_gamma_3") {
    EXPECT_NEAR(energy.unaccounted(), 0.0, tolerance);
  } else if (reference_["params"]["sliding"].get<bool>()) {
    EXPECT_GT(std::abs(energy.unaccounted()), 1e-4) << "with the inertia about the edge energy does not balance";
  }
}

TEST_P(ReferenceTrajectory, HasTheSameEventsInTheSameOrder) {
  // In case 17 the last impacts of the chatter are closer together than doubles resolve; our list then continues with
  // to_slide.
  const bool chatter_while_sliding = GetParam().starts_with("17");
  const auto events = without_past_balance(trajectory_);
  std::size_t next = 0;
  for (const json& row : reference_["events"]) {
    ASSERT_LT(next, events.size());
    const TrajectoryEvent& event = events[next];
    if (chatter_while_sliding && event.kind == dynamics::EventKind::to_slide && row[1] != "to_slide") {
      EXPECT_LT(std::abs(number(row[3])), 1e-12) << "an impact that matters was dropped";
      continue;
    }
    EXPECT_EQ(to_string(event.kind), row[1].get<std::string>()) << "event " << next;
    EXPECT_NEAR(event.tau, number(row[0]), event_tolerance()) << "event " << next;
    EXPECT_NEAR(event.tilt, number(row[2]), event_tolerance()) << "event " << next;
    EXPECT_NEAR(event.tilt_rate, number(row[3]), event_tolerance()) << "event " << next;
    EXPECT_NEAR(event.slip, number(row[4]), event_tolerance()) << "event " << next;
    EXPECT_NEAR(event.slip_rate, number(row[5]), event_tolerance()) << "event " << next;
    ++next;
  }
}

TEST_P(ReferenceTrajectory, HasAsManyEventsOfEachKind) {
  std::map<std::string, int> counts;
  for (const TrajectoryEvent& event : without_past_balance(trajectory_)) ++counts[std::string(to_string(event.kind))];
  std::map<std::string, int> expected = reference_["event_counts"].get<std::map<std::string, int>>();
  if (GetParam().starts_with("17") ||
      GetParam().starts_with("18")) {  // the number of impacts of a chatter depends on where it is cut off
    for (const char* impact : {"impact_stick", "impact_slip"}) {
      counts.erase(impact);
      expected.erase(impact);
    }
  }
  EXPECT_EQ(counts, expected);
}

TEST_P(ReferenceTrajectory, EndsAsTheReferenceDoes) {
  const bool overturns = reference_["event_counts"].contains("overturn");
  EXPECT_EQ(trajectory_.termination, overturns ? Termination::overturned : Termination::reached_horizon);
}

INSTANTIATE_TEST_SUITE_P(All, ReferenceTrajectory, testing::ValuesIn(reference_names()),
                         [](const auto& instance) { return instance.param; });

/// A block with its mass off the middle, in SI units (tests/reference/README.md).
Condition condition_of_general_block(const json& inputs) {
  Condition condition;
  Scene& scene = condition.scene;
  const auto number = [&inputs](const char* key) { return inputs[key].get<double>(); };
  scene.block.gravity = number("gravity_m_s2");
  scene.block.mass = GivenEdges{.edges = {number("left_edge_m"), number("right_edge_m")},
                                .centre_height = number("centre_height_m"),
                                .radius_of_gyration = std::sqrt(number("inertia_about_centre_over_mass_m2"))};
  const json& base = inputs["base_acceleration"];
  support::harmonic(scene) = {
      .phase = base["phase_rad"].get<double>(),
      .physical_amplitude = PhysicalAmplitude{base["amplitude_m_s2"].get<double>(), AccelerationUnit::m_s2},
      .physical_frequency = PhysicalFrequency{base["frequency_hz"].get<double>(), FrequencyUnit::hertz}};
  if (inputs.contains("wall")) {
    scene.block.wall = inputs["wall"]["side"] == "left" ? dynamics::Side::left : dynamics::Side::right;
    scene.restitution = WallRatio{inputs["wall"]["rate_ratio"].get<double>()};
  } else {
    scene.restitution = number("restitution");
  }
  if (!inputs["static_friction"].is_null()) {
    scene.friction =
        Friction{.static_coefficient = number("static_friction"), .kinetic_coefficient = number("kinetic_friction")};
  }
  const json& vertical = inputs["vertical_base_acceleration"];
  if (vertical["amplitude_m_s2"] != 0.0) {
    support::harmonic(scene).vertical = VerticalHarmonic{
        .phase = vertical["phase_rad"].get<double>(),
        .physical_amplitude = PhysicalAmplitude{vertical["amplitude_m_s2"].get<double>(), AccelerationUnit::m_s2},
        .physical_frequency = PhysicalFrequency{vertical["frequency_hz"].get<double>(), FrequencyUnit::hertz}};
  }
  const json& initial = inputs["initial"];
  scene.initial = {.tilt = initial["tilt_rad"].get<double>(),
                   .tilt_rate = initial["tilt_rate_rad_s"].get<double>(),
                   .slip_rate = initial["slip_rate_m_s"].get<double>(),
                   .units = {.tilt = StateUnit::si, .tilt_rate = StateUnit::si, .slip_rate = StateUnit::si}};
  return condition;
}

/// A reference, a tolerance of the steps, and what the motion may then differ from the reference.
struct GeneralCase {
  std::string name;
  double step_tolerance;
  double tolerance;
};

class GeneralBlock : public testing::TestWithParam<GeneralCase> {
 protected:
  void SetUp() override {
    reference_ = load_reference(GetParam().name);
    Condition condition = condition_of_general_block(reference_["inputs"]);
    condition.tolerance = GetParam().step_tolerance;
    block_ = dynamics::geometry_of(mean_block(condition.scene));
    trajectory_ = trajectory_of(condition, 0, 0, 10);
  }

  /// A state of ours, normalised, and one of the reference, in SI units.
  template <class Sample>
  void expect_state(const Sample& sample, const json& row) const {
    const double tolerance = GetParam().tolerance;
    const double psi = block_.tilt_unit(sample.tilt, sample.tilt_rate);
    const double p = block_.frequency_parameter;
    const double length = block_.half_diagonal;
    EXPECT_NEAR(sample.tilt * psi, row["tilt_rad"].get<double>(), tolerance) << row;
    EXPECT_NEAR(sample.tilt_rate * psi, row["tilt_rate_rad_s"].get<double>() / p, tolerance) << row;
    EXPECT_NEAR(sample.slip, row["slip_m"].get<double>() / length, tolerance) << row;
    EXPECT_NEAR(sample.slip_rate, row["slip_rate_m_s"].get<double>() / (length * p), tolerance) << row;
  }

  json reference_;
  dynamics::Geometry block_{};
  Trajectory trajectory_;
};

TEST_P(GeneralBlock, AgreesAtTheEndsOfPeriods) {
  ASSERT_EQ(trajectory_.strobe.size(), reference_["strobe"].size());
  for (std::size_t i = 0; i < trajectory_.strobe.size(); ++i) {
    const json& row = reference_["strobe"][i];
    expect_state(trajectory_.strobe[i], row);
    EXPECT_EQ(to_string(trajectory_.strobe[i].contact), row["contact"].get<std::string>()) << row;
  }
}

TEST_P(GeneralBlock, HasTheSameEventsInTheSameOrder) {
  // The reference follows a chatter to 1e-20 rad/s, this program until a hop is below its tolerance.
  std::size_t next = 0;
  for (const TrajectoryEvent& event : without_past_balance(trajectory_)) {
    const bool is_at_wall = block_.open_side != 0.0 && event.kind == dynamics::EventKind::impact_stick;
    const std::string kind = is_at_wall ? "impact_wall" : std::string(to_string(event.kind));
    const json& rows = reference_["events"];
    if (kind == "to_rest" || kind == "to_slide") {
      while (next < rows.size() && rows[next]["kind"].get<std::string>().starts_with("impact")) {
        EXPECT_LT(std::abs(rows[next]["tilt_rate_rad_s"].get<double>()), 1e-12) << "an impact that matters was dropped";
        ++next;
      }
    }
    ASSERT_LT(next, rows.size());
    const json& row = rows[next++];
    EXPECT_EQ(kind, row["kind"].get<std::string>()) << row;
    EXPECT_NEAR(event.tau / block_.frequency_parameter, row["time_s"].get<double>(), GetParam().tolerance) << row;
    expect_state(event, row);
  }
  EXPECT_EQ(next, reference_["events"].size());
}

TEST_P(GeneralBlock, BalancesItsEnergy) { EXPECT_NEAR(trajectory_.energy.unaccounted(), 0.0, 10 * 1e-12); }

std::vector<GeneralCase> general_cases() {
  std::vector<GeneralCase> cases;
  for (const char* name : {"g1_offset_rock", "g2_stick_slip", "g3_slipping_impacts", "g4_slide_lift_tip"}) {
    cases.push_back({std::string("general_block/") + name, 1e-13, 1e-11});  // largest: 5e-12, in the rate after twenty
                                                                            // slipping impacts of g4
    cases.push_back({std::string("general_block/") + name, 1e-15, 1e-12});  // largest: 2e-13, there too
  }
  for (const char* name : {"w1_bookcase", "w2_no_rebound", "w3_vertical_free"}) {
    cases.push_back({std::string("wall/") + name, 1e-13, 1e-11});
    cases.push_back({std::string("wall/") + name, 1e-15, 1e-12});
  }
  return cases;
}

INSTANTIATE_TEST_SUITE_P(All, GeneralBlock, testing::ValuesIn(general_cases()), [](const auto& instance) {
  return instance.param.name.substr(instance.param.name.find('/') + 1) +
         (instance.param.step_tolerance < 1e-14 ? "_1em15" : "_1em13");
});

TEST(Reference, HasTwentyTwoCases) { EXPECT_EQ(reference_names().size(), 22U); }

}  // namespace
}  // namespace rocking
