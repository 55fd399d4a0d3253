#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/excitation/base_excitation.hpp"
#include "rocking/dynamics/excitation/shape.hpp"

namespace rocking::dynamics {

/// A sample on a run's clock.
struct Knot {
  Instant instant;
  double horizontal;
  double vertical;
};

/// Successive samples that are reached one after another.
struct SamplesPassed {
  std::size_t count = 0;
  Instant last;  ///< when the last of them is reached; meaningless if there is none
};

/// A recorded base motion on a run's clock: linear between samples, at rest before the first and after the last.
/// Samples need not be evenly spaced. Every sample is a breakpoint, so that a step never crosses a kink.
class NormalisedGroundMotion {
 public:
  /// `frequency_parameter`: p, which turns seconds into normalised time.
  NormalisedGroundMotion(const std::vector<GroundMotionSample>& samples, double frequency_parameter,
                         const Clock& clock);

  /// The last knot that is reached; the piece goes from it to the knot behind it, which never is the last of all.
  /// `guess`: a knot of this motion or null. The search is short if the knot is that one or the one behind it.
  [[nodiscard]] const Knot* last_reached(const Clock& clock, const Knot* guess) const;

  /// The last of at most `most` knots behind `reached` that comes before `limit` and up to which the horizontal
  /// acceleration stays below `bound`. It stops before a jump and before a gap of half a period, and clearly before
  /// `limit`, so that rounding does not decide whether a knot belongs to it.
  [[nodiscard]] static const Knot* last_below(const Knot* reached, double bound, const Instant& limit, std::size_t most,
                                              const Clock& clock);

 private:
  std::vector<Knot> knots_;  ///< with two of rest on each side; the last is never reached
};

/// alpha = scale times the record's horizontal acceleration over g; likewise alpha_v where `vertical`.
///
/// Each motion has a copy of its own: an object remembers where it looked last, so that two threads must not share it.
template <bool vertical>
class RecordedExcitation {
 public:
  static constexpr bool is_periodic = false;
  static constexpr bool has_vertical = vertical;
  static constexpr bool bounds_acceleration = false;
  static constexpr bool has_knots = true;
  /// Period, time, horizontal and vertical acceleration of two knots, and the scale.
  static constexpr std::size_t piece_numbers = 9;

  /// `scale` of the vertical motion; the horizontal one's is the amplitude.
  RecordedExcitation(std::shared_ptr<const NormalisedGroundMotion> motion, double scale)
      : motion_(std::move(motion)), scale_(scale) {}

  /// The same record, whose knots both share, with another scale.
  [[nodiscard]] RecordedExcitation scaled(double scale) const { return {motion_, scale}; }

  [[nodiscard]] static double unit(const Geometry&) { return 1.0; }
  [[nodiscard]] double horizontal(const Clock& clock, double amplitude) const {
    return amplitude * acceleration(piece(clock), moment_of(clock)).horizontal;
  }
  /// Not known without looking through the record.
  [[nodiscard]] static double most_horizontal(double) { return std::numeric_limits<double>::infinity(); }
  [[nodiscard]] double weight(const Clock& clock) const {
    return vertical ? 1.0 + scale_ * acceleration(piece(clock), moment_of(clock)).upwards : 1.0;
  }
  [[nodiscard]] std::optional<Instant> next_change(const Clock& clock) const {
    const Instant& next = knot(clock)[1].instant;
    return next.time < std::numeric_limits<double>::infinity() ? std::optional(next) : std::nullopt;
  }

  /// Largest abs of the horizontal acceleration, for a scale of 1, from now to the next change.
  [[nodiscard]] double largest_before_change(const Clock& clock) const requires(!vertical) {
    const Knot* reached = knot(clock);
    return std::max(std::abs(reached[0].horizontal), std::abs(reached[1].horizontal));
  }

  /// The coming samples up to which abs of the horizontal acceleration, for a scale of 1, stays below `bound`; see
  /// NormalisedGroundMotion::last_below.
  [[nodiscard]] SamplesPassed samples_below(double bound, const Instant& limit, std::size_t most,
                                            const Clock& clock) const requires(!vertical) {
    const Knot* reached = knot(clock);
    last_ = NormalisedGroundMotion::last_below(reached, bound, limit, most, clock);
    return {.count = static_cast<std::size_t>(last_ - reached), .last = last_->instant};
  }

  [[nodiscard]] const Knot* knot(const Clock& clock) const { return last_ = motion_->last_reached(clock, last_); }
  [[nodiscard]] Piece<RecordedExcitation, double> piece(const Clock& clock) const {
    return piece_from<double>(knot(clock), scale_);
  }

  /// The piece that begins at a knot.
  template <base::Lane Real>
  [[nodiscard]] static Piece<RecordedExcitation, double> piece_from(const Knot* knot, double scale) {
    return {static_cast<double>(knot[0].instant.period),
            knot[0].instant.time,
            knot[0].horizontal,
            knot[0].vertical,
            static_cast<double>(knot[1].instant.period),
            knot[1].instant.time,
            knot[1].horizontal,
            knot[1].vertical,
            scale};
  }

  /// The last knot reached now, from one that was reached before. `Real`: of the lanes for which it is compiled.
  template <base::Lane Real>
  [[nodiscard]] static const Knot* follow(const Knot* knot, const Moment<double>& now, double resolution) {
    while (now.until(static_cast<double>(knot[1].instant.period), knot[1].instant.time) <= resolution) ++knot;
    return knot;
  }

  template <int order, base::Lane Real>
  static void expand(MotionSeries<Real>& series, const Piece<RecordedExcitation, Real>& piece, const Real& amplitude,
                     const Moment<Real>& now) {
    const Acceleration<Real> start = acceleration(piece, now);
    series.base.fill(Real(0.0));
    series.base[0] = amplitude * start.horizontal;
    series.base[1] = amplitude * start.horizontal_slope;
    if constexpr (vertical) {
      const Real& scale = piece[8];
      series.weight.fill(Real(0.0));
      series.weight[0] = Real(1.0) + scale * start.upwards;
      series.weight[1] = scale * start.upwards_slope;
    }
  }

 private:
  /// The record now and how it changes, per unit of normalised time.
  template <base::Lane Real>
  struct Acceleration {
    Real horizontal;
    Real horizontal_slope;
    Real upwards;
    Real upwards_slope;
  };

  template <class Real>
  [[nodiscard]] static Acceleration<Real> acceleration(const std::array<Real, piece_numbers>& piece,
                                                       const Moment<Real>& now) {
    using base::fused;
    const Real elapsed = -now.until(piece[0], piece[1]);
    const Real span = now.until(piece[4], piece[5]) + elapsed;
    const Real horizontal_slope = (piece[6] - piece[2]) / span;
    const Real upwards_slope = vertical ? (piece[7] - piece[3]) / span : Real(0.0);
    return {.horizontal = fused(horizontal_slope, elapsed, piece[2]),
            .horizontal_slope = horizontal_slope,
            .upwards = fused(upwards_slope, elapsed, piece[3]),
            .upwards_slope = upwards_slope};
  }

  std::shared_ptr<const NormalisedGroundMotion> motion_;
  double scale_;
  mutable const Knot* last_ = nullptr;  ///< found last
};

}  // namespace rocking::dynamics
