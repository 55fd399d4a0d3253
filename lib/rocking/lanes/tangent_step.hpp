#pragma once

#include <array>
#include <cstddef>

#include "rocking/dynamics/tangent_series.hpp"
#include "rocking/lanes/ending.hpp"
#include "rocking/lanes/moving_lanes.hpp"
#include "rocking/lanes/tangent_rows.hpp"

namespace rocking::lanes {
namespace {

/// The tangent vectors over the coming step of the lanes: combinations of two solutions of the variational equations, with
/// the expressions of dynamics::VariationOfStep.
template <class Form>
class TangentStep {
  using Real = typename Form::Real;
  using Terms = typename dynamics::MotionSeries<Real>::Row;
  static constexpr int order = Form::order;

 public:
  using Vectors = std::array<dynamics::Tangent<Real>, tangent_count>;

  [[gnu::noinline, gnu::flatten]] TangentStep(const LaneAccess<Real>& lanes, const Step<Form>& step) : m_(step.m) {
    for (std::size_t i = 0; i < tangent_count; ++i) {
      const TangentRows::Vector& rows = lanes.state.tangents->now[i];
      start_[i].tilt = lanes.load(rows.tilt);
      start_[i].tilt_rate = lanes.load(rows.tilt_rate);
      start_[i].slip_rate = lanes.load(rows.slip_rate);
    }
    solutions_[0].tilt[0] = solutions_[1].tilt_rate[0] = Real(1.0);
    solutions_[0].tilt_rate[0] = solutions_[1].tilt[0] = Real(0.0);
    dynamics::VariationCoefficients<Real> of;
    if constexpr (Form::slips) {
      drag_ = lanes.load(lanes.state.slip_sign) * kinetic_friction<Form>(lanes);
      dynamics::expand_rock_slide_variation<order>(m_, lanes.template constants<Form>(), drag_, of);
      for (auto& solution : solutions_) dynamics::solve_rock_slide_variation<order>(of, solution);
    } else {
      dynamics::expand_rock_variation<order, Form::Shaking::has_vertical>(m_, lanes.template constants<Form>(), of);
      for (auto& solution : solutions_) dynamics::solve_rock_variation<order>(of, solution);
    }
  }

  [[nodiscard]] const Vectors& start() const { return start_; }

  /// At time x of the step.
  [[nodiscard, gnu::noinline]] Vectors at(const Real& x) const {
    std::array<Real, 2> tilt;
    std::array<Real, 2> rate;
    for (std::size_t k = 0; k < 2; ++k) {
      tilt[k] = value<order + 1>(solutions_[k].tilt, x);
      rate[k] = value<order>(solutions_[k].tilt_rate, x);
    }
    dynamics::SlipVariation<Real> slip{.duration = x};
    if constexpr (Form::slips) slip = slip_until(x);
    Vectors now;
    for (std::size_t i = 0; i < tangent_count; ++i) {
      const dynamics::Tangent<Real>& from = start_[i];
      now[i].tilt = tilt[0] * from.tilt + tilt[1] * from.tilt_rate;
      now[i].tilt_rate = rate[0] * from.tilt + rate[1] * from.tilt_rate;
      now[i].slip_rate = from.slip_rate;
      if constexpr (Form::slips) now[i] = slip.apply(from, now[i].tilt, now[i].tilt_rate);
    }
    return now;
  }

 private:
  [[nodiscard]] dynamics::SlipVariation<Real> slip_until(const Real& x) const {
    const auto lever = [this](const Real& sine, const Real& cosine) { return cosine - drag_ * sine; };
    const auto swing = [this](const Real& sine, const Real& cosine, const Real& rate) {
      return rate * (sine + drag_ * cosine);
    };
    const Real sine = value<order + 1>(m_.sine, x);
    const Real cosine = value<order + 1>(m_.cosine, x);
    dynamics::SlipVariation<Real> slip{.duration = x};
    slip.lever_at_start = lever(m_.sine[0], m_.cosine[0]);
    slip.swing_at_start = swing(m_.sine[0], m_.cosine[0], m_.tilt_rate[0]);
    slip.lever_now = lever(sine, cosine);
    slip.swing_now = swing(sine, cosine, value<order>(m_.tilt_rate, x));
    return slip;
  }

  template <std::size_t degree>
  [[nodiscard]] static Real value(const Terms& row, const Real& x) {
    using base::fused;
    Real sum = row[degree];
#pragma GCC unroll 20
    for (std::size_t k = degree; k > 0; --k) sum = fused(sum, x, row[k - 1]);
    return sum;
  }

  const dynamics::MotionSeries<Real>& m_;
  Vectors start_;
  std::array<dynamics::VariationSeries<Real>, 2> solutions_;
  Real drag_;
};

template <class Real>
inline void store_vectors(const LaneAccess<Real>& lanes, TangentRows::Vectors& rows,
                          const std::array<dynamics::Tangent<Real>, tangent_count>& vectors) {
  for (std::size_t i = 0; i < tangent_count; ++i) {
    lanes.store(rows[i].tilt, vectors[i].tilt);
    lanes.store(rows[i].tilt_rate, vectors[i].tilt_rate);
    lanes.store(rows[i].slip_rate, vectors[i].slip_rate);
  }
}

/// The lanes that move on take the vectors at the end of their steps.
template <class Moving, class Form>
inline void move_vectors(const Moving& moving, const TangentStep<Form>& tangents,
                         const typename TangentStep<Form>::Vectors& end) {
  for (std::size_t i = 0; i < tangent_count; ++i) {
    TangentRows::Vector& rows = moving.lanes.state.tangents->now[i];
    const auto& start = tangents.start()[i];
    moving.store(rows.tilt, end[i].tilt, start.tilt);
    moving.store(rows.tilt_rate, end[i].tilt_rate, start.tilt_rate);
    moving.store(rows.slip_rate, end[i].slip_rate, start.slip_rate);
  }
}

/// S alpha and its rate of change at time x, for the lanes that are not moved on.
template <class Form, class Real = typename Form::Real>
inline void store_end_of_base(const LaneAccess<Real>& lanes, const Step<Form>& step, const Real& x) {
  using base::fused;
  Real base = step.m.base[Form::order];
  Real slope(0.0);
#pragma GCC unroll 20
  for (std::size_t k = Form::order; k > 0; --k) {
    base = fused(base, x, step.m.base[k - 1]);
    slope = fused(slope, x, Real(static_cast<double>(k)) * step.m.base[k]);
  }
  lanes.store(lanes.state.tangents->end_base, base);
  lanes.store(lanes.state.tangents->end_base_slope, slope);
}

}  // namespace
}  // namespace rocking::lanes
