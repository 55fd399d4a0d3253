// Error rate of the rule by which a response has settled, on a fixed set of realisations that are observed much longer.

#include <algorithm>
#include <cstdint>
#include <map>

#include <gtest/gtest.h>

#include "rocking/realisation/realisation_result.hpp"
#include "support/excitation.hpp"

namespace rocking {
namespace {

struct Errors {
  int settled = 0;
  int wrong = 0;  ///< in another mode than most windows of the second half of the long run
};

Errors errors_of_held(int held_windows) {
  Errors errors;
  for (const double amplitude : {5.5, 6.0, 7.0}) {
    Condition condition;
    support::harmonic(condition.scene).amplitude = amplitude;
    support::harmonic(condition.scene).frequency_ratio = 10.0;
    condition.scene.friction = Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
    condition.scene.fluctuation.static_friction = condition.scene.fluctuation.kinetic_friction = 0.03;
    condition.scene.initial.tilt = Uniform{.low = 0.0, .high = 0.5};
    condition.tolerance = 1e-10;
    condition.horizon = {.transient_periods = 40, .sampled_periods = 60};
    condition.horizon.until_classified =
        UntilClassified{.at_most_periods = 4000, .held_windows = held_windows, .long_run_every = 1};
    for (std::uint64_t number = 0; number < 25; ++number) {
      const RealisationResult result = realise(condition, 0x5e771e, number);
      const Settling& settling = *result.settling;
      if (!settling.settling_period) continue;
      ++errors.settled;
      std::uint64_t most = 0;
      section::ResponseMode in_the_end;
      for (const auto& [mode, count] : *settling.long_run) {
        if (count > most) in_the_end = mode;
        most = std::max(most, count);
      }
      errors.wrong += in_the_end == result.classification.mode ? 0 : 1;
    }
  }
  return errors;
}

// A rule that takes any window, or does not ask for successive ones, is wrong more often.
TEST(SettlingRule, IsNotMoreOftenWrongThanTheDocumentsSay) {
  std::map<int, Errors> errors;
  for (const int held : {1, 2, 3}) {
    errors[held] = errors_of_held(held);
    EXPECT_GE(errors[held].settled, 72) << held;
  }
  EXPECT_GE(errors[1].wrong, 1) << "these realisations cannot show an error";
  EXPECT_LE(errors[1].wrong, 12);
  EXPECT_LE(errors[2].wrong, 5);
  EXPECT_LE(errors[3].wrong, 3);
}

}  // namespace
}  // namespace rocking
