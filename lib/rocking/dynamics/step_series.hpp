#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/excitation/excitation.hpp"
#include "rocking/dynamics/forces.hpp"
#include "rocking/dynamics/motion_series.hpp"
#include "rocking/dynamics/setting.hpp"

namespace rocking::dynamics {

/// Sign of the frame in which a motion is expanded: that of the block's side; in full contact that of the fixed frame.
[[nodiscard]] inline double frame_side(const State& state) {
  return state.contact == ContactState::slide ? 1.0 : state.side;
}

/// What determines the series of a step.
struct StepStart {
  const Setting& setting;
  const State& state;
  const Clock& clock;
  double amplitude;         ///< of alpha
  double kinetic_friction;  ///< mu_k in force while the block slips
  bool lift_starts_flat;    ///< the tilt's acceleration is 0
  bool slip_starts_flat;    ///< the slip's is
};

/// The Taylor series of the coming step. `Steps`: see BlockMotion.
template <class Steps>
class StepSeries {
 public:
  explicit StepSeries(Steps steps) : steps_(steps) {}

  [[nodiscard]] const MotionSeries<double>& rows() const { return rows_; }
  [[nodiscard]] int order() const { return order_; }

  /// Fills the series to `order`; returns the length at which its last terms reach the tolerance.
  template <int order>
  double expand(const StepStart& start, const Excitation& excitation) {
    order_ = order;
    has_vertical_ = excitation.has_vertical();
    return excitation.visit([&](const auto& kind) {
      return with_constants(start.setting, frame_side(start.state),
                            [&](const auto& constants) { return expand_under<order>(start, kind, constants); });
    });
  }

  /// The state x after `start`, where the series begin.
  [[nodiscard]] State state_at(double x, const State& start) const {
    const double side = frame_side(start);
    State state = start;
    if (is_rocking(start.contact)) {
      state.tilt = side * value(rows_.tilt, order_ + 1, x);
      state.tilt_rate = side * value(rows_.tilt_rate, order_, x);
    }
    if (is_sliding(start.contact)) {
      state.slip_rate = side * value(rows_.slip_rate, order_, x);
      state.slip = side * value(rows_.slip, order_ + 1, x);
    }
    return state;
  }

  /// The base's motion then.
  [[nodiscard]] BaseMotion base_at(double x, const State& start) const {
    return {.horizontal = frame_side(start) * value(rows_.base, order_, x),
            .weight = has_vertical_ ? value(rows_.weight, order_, x) : 1.0};
  }

 private:
  template <int order, BaseExcitation Kind, class Constants>
  double expand_under(const StepStart& start, const Kind& excitation, const Constants& constants) {
    const State& state = start.state;
    const double side = frame_side(state);
    constexpr bool vertical = Kind::has_vertical;
    Kind::template expand<order>(rows_, excitation.piece(start.clock), side * start.amplitude, moment_of(start.clock));
    const double largest = start.setting.tolerance * start.setting.block.shape_angle;
    const SlipParameters<double> slip{.drag = side * state.slip_direction * start.kinetic_friction,
                                      .first_rate_gate = start.slip_starts_flat ? 0.0 : 1.0};
    const auto length = [this, largest](const auto& row) { return steps_(row[order - 1], row[order], order, largest); };
    // Guards contain the weight itself. Between the samples of a ground motion it is linear.
    const auto within_weight = [&](double own) {
      if constexpr (vertical && !Kind::has_knots) return std::min(own, length(rows_.weight));
      return own;
    };
    rows_.slip_rate[0] = side * state.slip_rate;
    rows_.slip[0] = side * state.slip;
    switch (state.contact) {
      case ContactState::rest: return within_weight(length(rows_.base));
      case ContactState::slide:
        expand_slide<order, vertical>(rows_, constants, slip);
        return within_weight(length(rows_.slip_rate));
      case ContactState::rock:
        begin_rocking(state, constants);
        expand_rock<order, vertical>(rows_, constants, start.lift_starts_flat ? 0.0 : 1.0);
        expand_normal<order, vertical>(rows_, constants);
        return within_weight(length(rows_.tilt_rate));
      case ContactState::rock_slide:
        begin_rocking(state, constants);
        expand_rock_slide<order, vertical>(rows_, constants, slip);
        return within_weight(std::min(length(rows_.tilt_rate), length(rows_.slip_rate)));
      case ContactState::overturned: break;
    }
    return 0.0;
  }

  template <class Row>
  [[nodiscard]] static double value(const Row& row, int degree, double x) {
    double sum = row[static_cast<std::size_t>(degree)];
    for (int k = degree - 1; k >= 0; --k) sum = std::fma(sum, x, row[static_cast<std::size_t>(k)]);
    return sum;
  }

  template <class Constants>
  void begin_rocking(const State& state, const Constants& constants) {
    rows_.tilt[0] = state.side * state.tilt;
    rows_.tilt_rate[0] = state.side * state.tilt_rate;
    begin_angle(rows_, constants);
  }

  MotionSeries<double> rows_{};
  int order_ = full_order;
  bool has_vertical_ = false;
  Steps steps_;
};

}  // namespace rocking::dynamics
