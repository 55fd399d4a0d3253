// Realisations that leave the range of the model are counted, never dropped, and can be replayed from their numbers
// (lib/docs/model.md, 7).

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/program.hpp"
#include "rocking/ensemble/run.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "support/simulation.hpp"

namespace rocking {
namespace {

using dynamics::Termination;

/// Random numbers decide which realisations overturn, with falls so fast that N reaches 0.
Json leaves_the_ground() {
  return Json::parse(R"({
    "format": "rocking.experiment/1", "block": { "width_m": 1.0, "height_m": 4.0 },
    "excitation": { "amplitude": 2.0, "frequency_ratio": 10.0 },
    "initial": { "tilt_rate": { "normal": { "mean": 0.0, "sigma": 1.2 } } },
    "horizon": { "transient_periods": 2, "sampled_periods": 5 },
    "realisations": 40, "seed": "0x7" })");
}

/// H/B = 2: the block slides with mu_k > tan(psi) and tips; D <= 0 where a draw reaches 4/3.
Json meets_painleve() {
  return Json::parse(R"({
    "format": "rocking.experiment/1", "block": { "width_m": 1.0, "height_m": 2.0 },
    "excitation": { "amplitude": 0.5, "frequency_ratio": 10.0 },
    "friction": { "static": 1.33, "kinetic": 1.3 }, "fluctuation": { "friction": { "sigma": 0.1, "refreshes_per_period": 5 } },
    "initial": { "slip_rate": 3.0 }, "horizon": { "transient_periods": 2, "sampled_periods": 3 },
    "realisations": 40, "seed": "0x7" })");
}

/// A ground motion with more samples in a strobe period than the budget of steps allows. Realisations that start beyond
/// the balance overturn before that.
Json exhausts_the_steps() {
  return Json::parse(R"({
    "format": "rocking.experiment/1", "block": { "width_m": 1.0, "height_m": 4.0 },
    "excitation": { "kind": "recorded", "file": "dense.txt", "time_step_s": 0.001, "frequency_ratio": 0.001 },
    "initial": { "tilt": { "uniform": [0.5, 1.5] } },
    "horizon": { "transient_periods": 1, "sampled_periods": 1 },
    "realisations": 2, "seed": "0x8" })");
}

std::string dense_record() {
  std::string text;
  for (int i = 0; i < 500'000; ++i) text += "0\n1e-9\n";
  return text;
}

/// Runs `document` as a C++ caller would, and follows each realisation by its numbers.
struct Replayed {
  ConditionResult result;
  std::vector<Trajectory> trajectories;
};

Replayed replay(const Json& document) {
  const Experiment read = experiment_in(document.dump());
  const Condition& condition = read.conditions.at(0);
  Replayed replayed{.result = run(read, {})->conditions.at(0), .trajectories = {}};
  const auto& horizon = condition.horizon;
  for (std::uint64_t number = 0; number < condition.realisations; ++number) {
    replayed.trajectories.push_back(
        trajectory_of(condition, read.seed, number, horizon.transient_periods + horizon.sampled_periods));
  }
  return replayed;
}

/// Each realisation has a response mode. Each unresolved one has a reason or ended before its horizon.
void expect_all_counted(const ConditionResult& result, std::uint64_t realisations) {
  std::uint64_t named = 0;
  std::uint64_t unresolved = result.validity.painleve.count + result.validity.stopped.count;
  for (const auto& [reason, cases] : result.validity.unresolved) unresolved += cases.count;
  for (const auto& mode : result.modes) {
    named += mode.probability.counts.successes;
    EXPECT_EQ(mode.probability.counts.trials, realisations);
    if (mode.mode.kind == section::ResponseKind::unresolved) {
      EXPECT_EQ(mode.probability.counts.successes, unresolved);
    }
  }
  EXPECT_EQ(named, realisations) << "a realisation is missing from the modes";
}

/// The cases are those trajectories for which `holds` is true; for some it is false.
void expect_cases(const Cases& cases, const std::vector<Trajectory>& all,
                  const std::function<bool(const Trajectory&)>& holds) {
  Cases seen;
  for (std::uint64_t number = 0; number < all.size(); ++number) {
    if (holds(all[number])) seen.add(number);
  }
  EXPECT_EQ(cases.count, seen.count);
  EXPECT_EQ(cases.first, seen.first);
  EXPECT_GT(seen.count, Cases::kept) << "the scene shows more than is listed";
  EXPECT_LT(seen.count, all.size()) << "and some that are not";
}

TEST(LeavingTheGround, IsCountedListedAndSeenAgainFromItsNumbers) {
  const Replayed replayed = replay(leaves_the_ground());
  expect_all_counted(replayed.result, 40);
  expect_cases(replayed.result.validity.left_ground, replayed.trajectories,
               [](const Trajectory& trajectory) { return trajectory.losses_of_contact > 0; });
  EXPECT_GT(replayed.result.validity.past_balance.count, replayed.result.validity.left_ground.count) << "not the same";
  for (const Trajectory& trajectory : replayed.trajectories) {
    ASSERT_EQ(trajectory.first_loss_of_contact.has_value(), trajectory.losses_of_contact > 0);
    if (!trajectory.first_loss_of_contact) continue;
    if (trajectory.termination == Termination::overturned) {
      EXPECT_LT(*trajectory.first_loss_of_contact, trajectory.events.back().tau) << "the run goes on";
    }
  }
}

TEST(Painleve, IsCountedListedAndSeenAgainFromItsNumbers) {
  const Replayed replayed = replay(meets_painleve());
  expect_all_counted(replayed.result, 40);
  expect_cases(replayed.result.validity.painleve, replayed.trajectories,
               [](const Trajectory& trajectory) { return trajectory.termination == Termination::painleve; });
}

/// A source of coefficients that announces another change at the same instant for ever: time does not advance.
struct ChangesForever : dynamics::ConstantCoefficients {
  [[nodiscard]] std::optional<dynamics::Instant> next_change(const dynamics::Clock& clock, bool) const {
    return clock.now();
  }
};

TEST(EventBudget, EndsARunInWhichTimeStandsStill) {
  support::Simulation<ChangesForever> run({.start = {.tilt = 0.1}, .periods = 1}, {});
  run.run();
  EXPECT_EQ(run.motion.termination(), Termination::stopped);
  EXPECT_EQ(run.motion.clock().tau(), 0.0);
  EXPECT_LT(run.counts.steps, 2'000U);
}

class LeavingTheModel : public support::ProgramTest {
 protected:
  /// Runs `document` and returns the validity of its only condition.
  Json validity_of(const Json& document) const {
    write("question.json", document.dump());
    EXPECT_EQ(rocking("run question.json -o out -q").exit_code, 0);
    report_ = Json::parse(read("out/report.json"));
    return report_["result"]["conditions"][0]["validity"];
  }
  Json trajectory_of(std::uint64_t realisation) const {
    const std::string number = std::to_string(realisation);
    return Json::parse(rocking("trajectory question.json --condition 0 --realisation " + number).output);
  }
  [[nodiscard]] int counted() const {
    int sum = 0;
    for (const auto& count : report_["result"]["conditions"][0]["counts"]) sum += count.get<int>();
    return sum;
  }

  mutable Json report_;
};

TEST_F(LeavingTheModel, ByTheGroundShowsInTheTrajectoryOfEachListedRealisation) {
  const Json validity = validity_of(leaves_the_ground());
  const Json first = validity["first_realisations"]["left_ground"];
  ASSERT_EQ(first.size(), 5U);
  EXPECT_EQ(counted(), 40);
  for (const auto& number : first) {
    const Json trajectory = trajectory_of(number.get<std::uint64_t>());
    EXPECT_GT(trajectory["validity"]["losses_of_contact"], 0) << number;
    EXPECT_GT(trajectory["validity"]["first_loss_of_contact"], 0.0) << number;
  }
}

TEST_F(LeavingTheModel, ByPainleveShowsInTheTrajectoryOfEachListedRealisation) {
  const Json validity = validity_of(meets_painleve());
  const Json first = validity["first_realisations"]["painleve"];
  ASSERT_EQ(first.size(), 5U);
  EXPECT_EQ(counted(), 40);
  for (const auto& number : first) {
    EXPECT_EQ(trajectory_of(number.get<std::uint64_t>())["termination"], "painleve") << number;
  }
}

TEST_F(LeavingTheModel, ByTheBudgetOfStepsShowsInTheTrajectory) {
  write("dense.txt", dense_record());
  const Json validity = validity_of(exhausts_the_steps());
  EXPECT_EQ(counted(), 2) << "the one that is stopped is unresolved, not dropped";
  EXPECT_EQ(validity["stopped"], 1);
  EXPECT_EQ(validity["first_realisations"]["stopped"], Json::array({1}));
  EXPECT_EQ(validity["unresolved"], Json::object()) << "its reason is its end, not the classification";
  EXPECT_EQ(trajectory_of(1)["termination"], "stopped");
  EXPECT_EQ(trajectory_of(0)["termination"], "overturned");
}

}  // namespace
}  // namespace rocking
