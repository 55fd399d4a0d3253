// Labels of random scenes in which nothing is random along the way, beside where the motion goes. The first 300 of those of
// tests/evidence/label_truth.cpp, whose truth stands in tests/reference/labels.csv: no false alarm.

#include <array>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/api/experiment.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "support/labelled_scenes.hpp"

namespace rocking {
namespace {

constexpr std::uint64_t seed_of_scenes = 11;

/// Where a motion goes that was called so at the default horizon, and until it was classified.
struct Truth {
  int scene;
  std::string at_horizon;
  std::string until_classified;
};

/// `12;(1,3);(1,3)` in each line but the first.
std::vector<Truth> truths() {
  std::ifstream file(ROCKING_SOURCE_DIR "/tests/reference/labels.csv");
  std::vector<Truth> found;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::string number;
    Truth truth{};
    std::getline(fields, number, ';');
    std::getline(fields, truth.at_horizon, ';');
    std::getline(fields, truth.until_classified, ';');
    truth.scene = std::stoi(number);
    found.push_back(truth);
  }
  return found;
}

struct Counts {
  int right = 0;
  int unresolved = 0;
  int of_long_period = 0;  ///< unresolved, of a motion whose period no label names
  int transients = 0;      ///< chaotic, of a motion that comes to an orbit later: its window was chaotic all the same
};

bool is_of_long_period(const std::string& truth) {
  const auto comma = truth.find(',');
  return comma != std::string::npos && std::stoi(truth.substr(comma + 1)) > section::longest_period;
}

void compare(const section::Classification& found, const std::string& truth, int scene, Counts& counts) {
  const std::string verdict = support::verdict_on(found.mode, truth);
  if (verdict == "unresolved") {
    ++(is_of_long_period(truth) ? counts.of_long_period : counts.unresolved);
  } else if (verdict == "right") {
    ++counts.right;
  } else if (found.mode.kind == section::ResponseKind::chaotic) {
    ++counts.transients;
  } else {
    ADD_FAILURE() << "scene " << scene << ": " << verdict;
  }
}

TEST(RandomScenes, AreCalledByThePeriodOfTheOrbitToWhichTheyTend) {
  Counts at_horizon, until_classified;
  const std::vector<Truth> all = truths();
  ASSERT_GT(all.size(), 280U);
  for (const Truth& truth : all) {
    const Experiment experiment = parse_experiment(support::labelled_scene(seed_of_scenes, truth.scene).dump());
    Condition condition = experiment.conditions.front();
    compare(realise(condition, experiment.seed, 0).classification, truth.at_horizon, truth.scene, at_horizon);
    condition.horizon.until_classified = UntilClassified{.at_most_periods = 20'000};
    compare(realise(condition, experiment.seed, 0).classification, truth.until_classified, truth.scene,
            until_classified);
  }
  const auto size = static_cast<int>(all.size());
  EXPECT_LT(at_horizon.unresolved, size / 8);
  EXPECT_LT(until_classified.unresolved, size / 50);
  EXPECT_LE(until_classified.transients, size / 100);
  EXPECT_GT(until_classified.right, size - size / 20);
}

/// Labels of a scene of another seed at the default horizon, and until it is classified.
std::array<section::Classification, 2> labels_of(int scene) {
  constexpr std::uint64_t other_seed = 12;
  const Experiment experiment = parse_experiment(support::labelled_scene(other_seed, scene).dump());
  Condition condition = experiment.conditions.front();
  const section::Classification at_horizon = realise(condition, experiment.seed, 0).classification;
  condition.horizon.until_classified = UntilClassified{.at_most_periods = 20'000};
  return {at_horizon, realise(condition, experiment.seed, 0).classification};
}

// The block lands within 1e-5 psi of the strobe and alternates about the orbit, whose multiplier is -0.991: its points lie
// before and after an impact by turns, as if there were two.
TEST(RandomScenes, AreNotCalledTwiceTheirPeriodWhereAnImpactFallsOnTheStrobe) {
  const auto [at_horizon, in_the_end] = labels_of(382);
  EXPECT_EQ(at_horizon.reason, section::Reason::still_converging);
  EXPECT_EQ(support::verdict_on(in_the_end.mode, "(1,1)"), "right");
}

// Their periods are 13, 13 and 15.
TEST(RandomScenes, AreNotCalledQuasiPeriodicWhereAnOrbitOfALongPeriodAttractsSlowly) {
  for (const int scene : {306, 673, 968}) {
    for (const section::Classification& label : labels_of(scene)) {
      EXPECT_EQ(label.mode.kind, section::ResponseKind::unresolved) << scene;
    }
  }
}

}  // namespace
}  // namespace rocking
