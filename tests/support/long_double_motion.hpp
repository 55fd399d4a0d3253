#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <vector>

#include "support/long_double_rock.hpp"

namespace rocking::support {

/// A block that does not slide, from the middle to its edges, on a base that shakes as sin(frequency tau): rocking over both
/// edges, impacts that keep `ratio` of the rate, rest. In long double, sharing nothing with the library. The equations are
/// those of model.md, 1 to 4 and 11.
class LongDoubleMotion {
 public:
  using Real = long double;
  using Point = std::array<Real, 2>;  ///< theta and theta' at the end of a period of the base

  struct Edge {
    Real psi;
    Real factor;  ///< K r
    Real ratio;   ///< of the rates after and before an impact on this edge
  };

  LongDoubleMotion(const Edge& left, const Edge& right, Real peak, Real frequency)
      : edges_{left, right},
        rocks_{LongDoubleRock{left.psi, peak, frequency, 0.0L, left.factor},
               LongDoubleRock{right.psi, -peak, frequency, 0.0L, right.factor}},
        peak_(peak),
        frequency_(frequency) {}

  struct Passed {
    Point point;
    int impacts = 0;  ///< on another edge than the one before
    bool moved = false;
    bool came_to_rest = false;
    bool overturned = false;
  };

  /// One period of the base from `start`, a state at the beginning of a period.
  [[nodiscard]] Passed period_from(const Point& start) const {
    State state{.tau = 0.0L, .tilt = start[0], .rate = start[1]};
    const Real length = 2.0L * std::numbers::pi_v<Real> / frequency_;
    Passed passed{.point = start};
    while (state.tau < length && !passed.overturned) {
      if (state.tilt == 0.0L && state.rate == 0.0L) {
        rest(state, length, passed);
      } else {
        rock(state, length, passed);
      }
      passed.overturned = std::abs(state.tilt) > 0.5L * std::numbers::pi_v<Real>;
    }
    passed.point = {state.tilt, state.rate};
    return passed;
  }

 private:
  struct State {
    Real tau;
    Real tilt;
    Real rate;
  };
  static constexpr Real smallest_rate = 1e-9L;  ///< below it the impacts of a chatter end in rest

  [[nodiscard]] Real alpha(Real tau) const { return peak_ * std::sin(frequency_ * tau); }
  [[nodiscard]] bool holds(Real tau) const {
    return alpha(tau) <= std::tan(edges_[0].psi) && alpha(tau) >= -std::tan(edges_[1].psi);
  }

  /// In full contact up to the first instant at which the base acceleration lifts the block, or to the end.
  void rest(State& state, Real end, Passed& passed) const {
    const Real step = end / 512.0L;
    Real before = state.tau;
    while (before < end && holds(std::min(end, before + step))) before = std::min(end, before + step);
    if (before >= end) {
      state.tau = end;
      return;
    }
    Real after = std::min(end, before + step);
    for (int i = 0; i < 80; ++i) {
      const Real middle = 0.5L * (before + after);
      (holds(middle) ? before : after) = middle;
    }
    // Away from the edge of the side to which the block turns: a rate that any further step makes larger.
    state = {after, 0.0L, std::copysign(1e-18L, alpha(after))};
    passed.moved = true;
  }

  void rock(State& state, Real end, Passed& passed) const {
    const bool left = state.tilt > 0.0L || (state.tilt == 0.0L && state.rate > 0.0L);
    const Real sign = left ? 1.0L : -1.0L;
    LongDoubleRock::Series tilt{};
    LongDoubleRock::Series rate{};
    rocks_[left ? 0 : 1].expand(state.tau, sign * state.tilt, sign * state.rate, tilt, rate);
    passed.moved = true;
    const Real step = std::min(1.0L / frequency_, end - state.tau);
    const std::optional<Real> ground = first_contact(tilt, rate, step);
    if (!ground) {
      const bool ends = step >= end - state.tau;
      state = {ends ? end : state.tau + step, sign * LongDoubleRock::value(tilt, step),
               sign * LongDoubleRock::value(rate, step)};
      return;
    }
    const Real before = sign * LongDoubleRock::value(rate, *ground);
    state = {state.tau + *ground, 0.0L, edges_[before > 0.0L ? 0 : 1].ratio * before};
    if (std::abs(state.rate) < smallest_rate && holds(state.tau)) {
      state.rate = 0.0L;
      passed.came_to_rest = true;
    } else {
      ++passed.impacts;
    }
  }

  /// The first time in (0, step] at which the tilt, which is positive before, passes 0.
  [[nodiscard]] static std::optional<Real> first_contact(const LongDoubleRock::Series& tilt,
                                                         const LongDoubleRock::Series& rate, Real step) {
    constexpr int parts = 16;
    Real low = 0.0L;
    for (int k = 1; k <= parts; ++k) {
      const Real high = step * static_cast<Real>(k) / parts;
      if (LongDoubleRock::value(tilt, high) <= 0.0L) return crossing(tilt, low, high);
      const bool turns = LongDoubleRock::value(rate, low) < 0.0L && LongDoubleRock::value(rate, high) > 0.0L;
      if (turns) {
        const Real lowest = crossing(rate, low, high);
        if (LongDoubleRock::value(tilt, lowest) <= 0.0L) return crossing(tilt, low, lowest);
      }
      low = high;
    }
    return std::nullopt;
  }

  [[nodiscard]] static Real crossing(const LongDoubleRock::Series& series, Real low, Real high) {
    const bool rises = LongDoubleRock::value(series, high) > 0.0L;
    for (int i = 0; i < 70; ++i) {
      const Real middle = 0.5L * (low + high);
      ((LongDoubleRock::value(series, middle) > 0.0L) == rises ? high : low) = middle;
    }
    return high;
  }

  std::array<Edge, 2> edges_;
  std::array<LongDoubleRock, 2> rocks_;
  Real peak_;
  Real frequency_;
};

/// Where a motion tends to: a stable orbit of `period` periods of the base; 0: none was found.
struct OrbitInTheEnd {
  int period = 0;
  int impacts = 0;  ///< in so many periods
  bool moved = false;
  bool rests = false;  ///< within a period: impacts of a chatter were counted one by one
  bool overturned = false;
};

/// Follows a motion until its points repeat to rounding, or until it follows for 1000 periods a stable orbit that Newton's method
/// finds for it, approaching as the multipliers of the orbit say.
class EndOfMotion {
 public:
  EndOfMotion(const LongDoubleMotion& motion, const LongDoubleMotion::Point& start) : motion_(&motion), start_(start) {}

  /// Newton's method tries `longest` periods, and points are compared after five times as many.
  [[nodiscard]] OrbitInTheEnd found(int at_most_periods, int longest) {
    for (int passed = 0; passed < at_most_periods; passed += block) {
      points_.clear();
      for (int k = 0; k < block; ++k) {
        points_.push_back(motion_->period_from(start_));
        start_ = points_.back().point;
        if (points_.back().overturned) return {.overturned = true};
      }
      for (int n = 1; n <= 5 * longest; ++n) {
        if (repeats(n)) return of(n);
      }
      const bool looks = (passed / block & (passed / block - 1)) == 0;  // after 1, 2, 3, 5, 9, ... blocks
      for (int n = 1; looks && n <= longest; ++n) {
        if (follows_orbit(n)) return of(n);
      }
    }
    return {};
  }

 private:
  using Real = long double;
  using Point = LongDoubleMotion::Point;
  static constexpr int block = 500;

  static Real apart(const Point& a, const Point& b) { return std::max(std::abs(a[0] - b[0]), std::abs(a[1] - b[1])); }

  /// Largest difference of the last points from those n periods before.
  [[nodiscard]] Real difference(int n) const {
    Real largest = 0.0L;
    for (std::size_t k = points_.size() - 60; k < points_.size(); ++k) {
      largest = std::max(largest, apart(points_[k].point, points_[k - static_cast<std::size_t>(n)].point));
    }
    return largest;
  }

  /// To rounding, and after no divisor of n to anything near it: on a spiral the difference after a multiple of the period may
  /// be the first to be small.
  [[nodiscard]] bool repeats(int n) const {
    if (difference(n) > 1e-14L) return false;
    for (int divisor = 1; divisor < n; ++divisor) {
      if (n % divisor == 0 && difference(divisor) < 1e-8L) return false;
    }
    return true;
  }

  [[nodiscard]] OrbitInTheEnd of(int n) const {
    OrbitInTheEnd orbit{.period = n};
    Point point = start_;
    for (int k = 0; k < n; ++k) {
      const LongDoubleMotion::Passed passed = motion_->period_from(point);
      point = passed.point;
      orbit.impacts += passed.impacts;
      orbit.moved = orbit.moved || passed.moved;
      orbit.rests = orbit.rests || passed.came_to_rest || !passed.moved;
    }
    return orbit;
  }

  [[nodiscard]] Point after(Point point, int n) const {
    for (int k = 0; k < n; ++k) point = motion_->period_from(point).point;
    return point;
  }

  struct Linear {
    Real a, b, c, d;
    [[nodiscard]] Real largest_multiplier() const {
      const Real half = 0.5L * (a + d);
      const Real determinant = a * d - b * c;
      const Real root = half * half - determinant;
      return root < 0.0L ? std::sqrt(determinant) : std::abs(half) + std::sqrt(root);
    }
  };

  [[nodiscard]] Linear derivative(const Point& at, int n) const {
    constexpr Real h = 1e-8L;
    const Point right = after({at[0] + h, at[1]}, n), left = after({at[0] - h, at[1]}, n);
    const Point up = after({at[0], at[1] + h}, n), down = after({at[0], at[1] - h}, n);
    return {(right[0] - left[0]) / (2 * h), (up[0] - down[0]) / (2 * h), (right[1] - left[1]) / (2 * h),
            (up[1] - down[1]) / (2 * h)};
  }

  [[nodiscard]] bool is_of_divisor(const Point& orbit, int n) const {
    for (int divisor = 1; divisor < n; ++divisor) {
      if (n % divisor == 0 && apart(after(orbit, divisor), orbit) < 1e-9L) return true;
    }
    return false;
  }

  [[nodiscard]] bool follows_orbit(int n) {
    Point orbit = start_;
    Real last = 1.0L;
    for (int i = 0; i < 12 && last > 1e-15L; ++i) {
      const Linear m = derivative(orbit, n);
      const Point image = after(orbit, n);
      const Real determinant = (1.0L - m.a) * (1.0L - m.d) - m.b * m.c;
      const Real x = image[0] - orbit[0], y = image[1] - orbit[1];
      if (determinant == 0.0L) return false;
      const Point change{((1.0L - m.d) * x + m.b * y) / determinant, (m.c * x + (1.0L - m.a) * y) / determinant};
      orbit = {orbit[0] + change[0], orbit[1] + change[1]};
      last = std::max(std::abs(change[0]), std::abs(change[1]));
      if (!(apart(orbit, start_) < 0.1L)) return false;
    }
    if (last > 1e-13L || is_of_divisor(orbit, n)) return false;
    const Real multiplier = derivative(orbit, n).largest_multiplier();
    if (!(multiplier < 1.0L - 1e-7L * static_cast<Real>(n))) return false;
    return approaches(orbit, n, multiplier);
  }

  /// Over up to 12 times 500 periods the distance from the orbit falls as the multiplier says: at once or, where two multipliers
  /// beat, in the mean.
  [[nodiscard]] bool approaches(const Point& orbit, int n, Real multiplier) {
    const int times = (block + n - 1) / n;
    const Real expected = static_cast<Real>(times) * std::log(multiplier);
    const Real first = largest_distance(orbit, n, 0);
    for (int k = 1; k <= 12; ++k) {
      const Real next = largest_distance(orbit, n, times);
      if (next < 1e-12L) return true;
      const Real change = std::log(next / first);
      if (change > 1.0L) return false;
      const bool is_as_expected = change < 0.7L * static_cast<Real>(k) * expected;
      if (is_as_expected && (change < -3.0L || k == 12)) return true;
    }
    return false;
  }

  /// After so many times n periods, the largest distance from the orbit in the next 24 times n.
  [[nodiscard]] Real largest_distance(const Point& orbit, int n, int times) {
    constexpr int looked_at = 24;
    start_ = after(start_, n * std::max(0, times - looked_at));
    Real largest = 0.0L;
    for (int k = 0; k < looked_at; ++k) {
      largest = std::max(largest, apart(start_, orbit));
      start_ = after(start_, n);
    }
    return largest;
  }

  const LongDoubleMotion* motion_;
  Point start_;
  std::vector<LongDoubleMotion::Passed> points_;
};

}  // namespace rocking::support
