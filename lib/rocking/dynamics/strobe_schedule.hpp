#pragma once

#include <cstdint>

#include "rocking/dynamics/clock.hpp"

namespace rocking::dynamics {

/// When a run is sampled and how long it is.
struct Schedule {
  Instant first_strobe;      ///< the following ones come a period apart
  std::int64_t strobes = 0;  ///< after the last the run ends
};

/// How far a run has come in its schedule.
class StrobeSchedule {
 public:
  explicit StrobeSchedule(const Schedule& schedule) : next_(schedule.first_strobe), left_(schedule.strobes) {}

  [[nodiscard]] const Instant& next() const { return next_; }
  [[nodiscard]] Instant last() const {
    return {.period = next_.period - 1, .time = next_.time};
  }                                                          ///< the one passed last
  [[nodiscard]] std::int64_t left() const { return left_; }  ///< strobe points until the end of the run
  [[nodiscard]] std::int64_t steps_since_last() const { return steps_since_last_; }

  void pass() {
    ++next_.period;
    --left_;
    steps_since_last_ = 0;
  }
  void count_step() { ++steps_since_last_; }
  /// Of steps that were not counted one by one.
  void set_steps_since_last(std::int64_t steps) { steps_since_last_ = steps; }
  void extend(std::int64_t more) { left_ += more; }

 private:
  Instant next_;
  std::int64_t left_;
  std::int64_t steps_since_last_ = 0;
};

}  // namespace rocking::dynamics
