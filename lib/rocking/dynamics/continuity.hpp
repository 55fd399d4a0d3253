#pragma once

#include <cstdint>

namespace rocking::dynamics {

/// How the coming step follows on the last one. Replaced as a whole by each step and each reset.
struct Continuity {
  bool after_reset = true;       ///< the forces may have jumped: N and D are checked when the series are known
  std::int64_t standstills = 0;  ///< steps in a row in which no time went on

  [[nodiscard]] bool time_went_on() const { return standstills == 0; }  ///< in the last step

  [[nodiscard]] static constexpr Continuity after_a_step() { return {.after_reset = false, .standstills = 0}; }
  [[nodiscard]] constexpr Continuity after_a_standstill() const {
    return {.after_reset = false, .standstills = standstills + 1};
  }
  [[nodiscard]] constexpr Continuity after_events() const { return {.after_reset = true, .standstills = standstills}; }
};

}  // namespace rocking::dynamics
