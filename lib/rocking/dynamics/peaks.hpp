#pragma once

#include <cstddef>
#include <limits>

#include "rocking/base/jet.hpp"
#include "rocking/base/lane.hpp"
#include "rocking/dynamics/motion_series.hpp"

/// The largest values that a motion reaches, also between the ends of its steps.
///
/// abs(theta) and abs(w) are largest at the end of a step (an event, a breakpoint, a strobe instant at which the run
/// ends) or inside a step where their derivative changes sign. That instant is found on the Taylor polynomial of the
/// step with a fixed number of iterations, in IEEE arithmetic. One motion and the lanes evaluate the same expressions,
/// so that a peak has the same bits in both. An extremum between two changes of sign within one step is not seen; at
/// the default tolerance a step is about an eighth of an excitation period.
namespace rocking::dynamics {

/// Largest values so far, >= 0. Infinite if they are not wanted: nothing exceeds them, so that nothing is searched for.
/// Tilts and tilt rates are in units in which balance is psi of the nearer edge on both sides.
struct Peaks {
  double tilt = 0.0;       ///< abs(theta) times Edge::tilt_scale [rad]
  double tilt_rate = 0.0;  ///< abs(w) times that of the same side [rad]
  double slip = 0.0;       ///< abs(X)

  [[nodiscard]] static Peaks unwanted() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {.tilt = infinity, .tilt_rate = infinity, .slip = infinity};
  }
};

/// abs(theta) and abs(w) of them: of one motion or of the lanes.
template <base::Lane Real>
struct TiltPeaks {
  Real tilt;
  Real tilt_rate;
};

/// What is kept of them, as abs(theta) and abs(w) of a block on this side.
template <base::Lane Real, BlockForm form>
[[nodiscard]] inline TiltPeaks<Real> peaks_on_side(const TiltPeaks<Real>& kept,
                                                   const EquationConstants<Real, form>& constants) {
  if constexpr (form == BlockForm::general) {
    return {kept.tilt / constants.tilt_scale, kept.tilt_rate / constants.tilt_scale};
  } else {
    return kept;
  }
}

/// How far a step of a rocking block goes, in the side frame.
template <base::Lane Real>
struct StepFinish {
  Real length;
  Real tilt;       ///< S theta
  Real tilt_rate;  ///< S w
};

namespace peaks {

/// Iterations of third order from the secant of the derivative, whose error is below a tenth of a step. Where the
/// derivative is 0 at the start there is no such secant.
inline constexpr int iterations = 2;
inline constexpr int flat_iterations = 16;

template <base::Lane Real>
[[nodiscard]] inline Real larger(const Real& a, const Real& b) {
  using base::select;
  return select(a < b, b, a);
}

/// sign f(x) over [0, length], f(x) = sum c[k] x^k, k < count. Its derivative is `slope_at_start` >= 0 and
/// `slope_at_end` < 0.
template <base::Lane Real>
struct Arch {
  const Real* c;
  std::size_t count;
  Real length;
  Real sign;
  Real slope_at_start;
  Real slope_at_end;
};

/// The maximum of an arch, in the lanes `wanted`. An iteration takes the zero of the derivative's Taylor polynomial of
/// degree 2 to third order, or halves the bracket where that leaves it.
template <base::Lane Real, class Truth>
[[nodiscard]] inline Real maximum(const Arch<Real>& f, Truth wanted) {
  using base::at_most, base::fused, base::in_any, base::select;
  const Real zero(0.0);
  const Real half(0.5);
  const Truth is_flat = f.slope_at_start == zero;
  Real x = f.length * select(is_flat, half, f.slope_at_start / (f.slope_at_start - f.slope_at_end));
  Real low = zero;
  Real high = f.length;
  Real value = zero;
  for (int done = 0; done < flat_iterations && in_any(wanted); ++done) {
    const base::Jet<Real> p = base::jet_at(f.c, f.count, x);
    const Real first = f.sign * p.first;
    const Real second = f.sign * p.second;
    const Real third = f.sign * p.third;
    const Truth rises = zero < first;
    low = select(rises, x, low);
    high = select(rises, high, x);
    const Real newton = -first / (second + second);
    const Real next = x + fused(newton, Real(-1.5) * third * newton / second, newton);
    const Truth inside = second < zero && at_most(low, next) && at_most(next, high);
    const Real chosen = select(inside, next, half * (low + high));
    const Real by = chosen - x;
    value = select(wanted, fused(fused(fused(third, by, second), by, first), by, f.sign * p.value), value);
    x = chosen;
    if (done + 1 == iterations) wanted = wanted && is_flat;
  }
  return value;
}

/// By how much f may exceed the larger of its ends: sup abs(f'') length^2/8, with twice the first three terms of f'' in
/// place of the supremum, because the terms fall off quickly within a step.
template <base::Lane Real>
[[nodiscard]] inline Real rise(const Real* c, const Real& length) {
  using base::fused, base::magnitude;
  const Real higher = fused(Real(6.0) * length, magnitude(c[4]), Real(3.0) * magnitude(c[3]));
  return Real(0.5) * length * length * fused(length, higher, magnitude(c[2]));
}

/// The derivative at x of sum c[k] x^k, k < count.
template <base::Lane Real>
[[nodiscard]] inline Real slope_at(const Real* c, std::size_t count, const Real& x) {
  using base::fused;
  Real slope = Real(static_cast<double>(count - 1)) * c[count - 1];
  for (std::size_t k = count - 1; k-- > 1;) slope = fused(slope, x, Real(static_cast<double>(k)) * c[k]);
  return slope;
}

/// The largest S theta, from a step in which w changes its sign in the lanes `turns`, or the one before.
template <base::Lane Real, class Truth>
Real tilt_after_turn(const MotionSeries<Real>& m, std::size_t order, const StepFinish<Real>& end, const Real& before,
                     Truth turns) {
  using base::in_any, base::select;
  turns = turns && before < larger(m.tilt[0], end.tilt) + rise(m.tilt.data(), end.length);
  if (!in_any(turns)) return before;
  const Real largest =
      maximum<Real>({m.tilt.data(), order + 2, end.length, Real(1.0), m.tilt_rate[0], end.tilt_rate}, turns);
  return select(turns, larger(before, largest), before);
}

/// The largest abs(w), from a step in which it grows at first in the lanes `grows`, or the one before.
template <base::Lane Real, class Truth>
[[nodiscard]] Real rate_after_growth(const MotionSeries<Real>& m, std::size_t order, const StepFinish<Real>& end,
                                     const Real& before, Truth grows) {
  using base::in_any, base::select;
  const Real zero(0.0);
  const Real one(1.0);
  const Real sign = select(m.tilt_rate[0] + end.tilt_rate < zero, -one, one);
  const Real at_end = sign * slope_at(m.tilt_rate.data(), order + 1, end.length);
  grows = grows && at_end < zero;
  if (!in_any(grows)) return before;
  const Real largest =
      maximum<Real>({m.tilt_rate.data(), order + 1, end.length, sign, sign * m.tilt_rate[1], at_end}, grows);
  return select(grows, larger(before, largest), before);
}

}  // namespace peaks

/// Whether a step of a rocking block with these series may raise a peak. Few steps do: with this test first, the peaks
/// cost most steps nothing else.
template <base::Lane Real>
[[nodiscard]] inline auto may_raise(const MotionSeries<Real>& m, const StepFinish<Real>& end,
                                    const TiltPeaks<Real>& before) {
  using base::magnitude;
  const Real zero(0.0);
  const Real& rate = m.tilt_rate[0];
  const Real fastest = peaks::larger(magnitude(rate), magnitude(end.tilt_rate));
  const auto turns = !(rate < zero) && end.tilt_rate < zero;
  return turns || before.tilt < end.tilt || before.tilt_rate < fastest + peaks::rise(m.tilt_rate.data(), end.length);
}

/// The peaks after a step that may raise them, `order` the order of the step.
template <base::Lane Real>
[[nodiscard, gnu::noinline, gnu::flatten]] TiltPeaks<Real> peaks_after(const MotionSeries<Real>& m, std::size_t order,
                                                                       const StepFinish<Real>& end,
                                                                       const TiltPeaks<Real>& before) {
  using base::at_most, base::in_any, base::magnitude;
  const Real zero(0.0);
  const Real& rate = m.tilt_rate[0];
  const Real fastest = peaks::larger(magnitude(rate), magnitude(end.tilt_rate));
  TiltPeaks<Real> now{.tilt = peaks::larger(before.tilt, end.tilt),
                      .tilt_rate = peaks::larger(before.tilt_rate, magnitude(end.tilt_rate))};
  const auto turns = at_most(zero, rate) && end.tilt_rate < zero;
  if (in_any(turns)) now.tilt = peaks::tilt_after_turn(m, order, end, now.tilt, turns);
  const auto grows = at_most(zero, (rate + end.tilt_rate) * m.tilt_rate[1]);
  const auto may_exceed = grows && now.tilt_rate < fastest + peaks::rise(m.tilt_rate.data(), end.length);
  if (in_any(may_exceed)) now.tilt_rate = peaks::rate_after_growth(m, order, end, now.tilt_rate, may_exceed);
  return now;
}

/// What is kept after that step: `kept` before it, `before` and `after` on the side of the block.
template <base::Lane Real, BlockForm form>
[[nodiscard]] inline TiltPeaks<Real> peaks_to_keep(const TiltPeaks<Real>& kept, const TiltPeaks<Real>& before,
                                                   const TiltPeaks<Real>& after,
                                                   const EquationConstants<Real, form>& constants) {
  if constexpr (form == BlockForm::general) {
    using base::select;
    const auto raised = [&](const Real& old, const Real& low, const Real& high) {
      return select(low < high, peaks::larger(old, constants.tilt_scale * high), old);
    };
    return {raised(kept.tilt, before.tilt, after.tilt), raised(kept.tilt_rate, before.tilt_rate, after.tilt_rate)};
  } else {
    return after;
  }
}

}  // namespace rocking::dynamics
