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

TEST(Reference, HasTwentyTwoCases) { EXPECT_EQ(reference_names().size(), 22U); }

}  // namespace
}  // namespace rocking
