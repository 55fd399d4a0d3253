#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/motion_series.hpp"

namespace rocking::dynamics {

/// A sample of a recorded base acceleration.
struct RecordSample {
  double time;        ///< [s], from the start of the run; never falls, two equal times are a jump
  double horizontal;  ///< over g
  double vertical;    ///< over g
};

/// A recorded base motion on a run's clock: linear between samples, at rest before the first and after the last. Samples
/// need not be evenly spaced. Every sample is a breakpoint, so that a step never crosses a kink.
class RecordedMotion {
 public:
  /// `frequency_parameter`: p, which turns seconds into normalised time.
  RecordedMotion(const std::vector<RecordSample>& samples, double frequency_parameter, const Clock& clock);

  /// The acceleration at an instant and how it changes until the next sample.
  struct Segment {
    double horizontal = 0.0;
    double horizontal_slope = 0.0;  ///< per unit of normalised time
    double vertical = 0.0;
    double vertical_slope = 0.0;
    std::optional<Instant> end;  ///< absent after the last sample
  };

  [[nodiscard]] Segment segment(const Clock& clock) const;

 private:
  struct Knot {
    Instant instant;
    double horizontal;
    double vertical;
  };
  std::vector<Knot> knots_;
};

/// alpha = scale times the record's horizontal acceleration over g; likewise alpha_v where `vertical`.
template <bool vertical>
class RecordedExcitation {
 public:
  static constexpr bool is_periodic = false;
  static constexpr bool has_vertical = vertical;
  static constexpr bool runs_in_lanes = false;

  /// `scale` of the vertical motion; the horizontal one's is the amplitude.
  RecordedExcitation(std::shared_ptr<const RecordedMotion> motion, double scale)
      : motion_(std::move(motion)), scale_(scale) {}

  [[nodiscard]] static double unit(const Geometry&) { return 1.0; }
  [[nodiscard]] double horizontal(const Clock& clock, double amplitude) const {
    return amplitude * motion_->segment(clock).horizontal;
  }
  /// Not known without looking through the record.
  [[nodiscard]] static double most_horizontal(double) { return std::numeric_limits<double>::infinity(); }
  [[nodiscard]] double weight(const Clock& clock) const {
    return vertical ? 1.0 + scale_ * motion_->segment(clock).vertical : 1.0;
  }
  [[nodiscard]] std::optional<Instant> next_change(const Clock& clock) const { return motion_->segment(clock).end; }

  /// Steps that asked the record for their piece of it.
  [[nodiscard]] std::uint64_t segments_looked_up() const { return segments_looked_up_; }

  template <int order>
  void expand(MotionSeries<double>& series, const Clock& clock, double amplitude) {
    ++segments_looked_up_;
    const RecordedMotion::Segment now = motion_->segment(clock);
    series.base.fill(0.0);
    series.base[0] = amplitude * now.horizontal;
    series.base[1] = amplitude * now.horizontal_slope;
    if constexpr (vertical) {
      series.weight.fill(0.0);
      series.weight[0] = 1.0 + scale_ * now.vertical;
      series.weight[1] = scale_ * now.vertical_slope;
    }
  }

 private:
  std::shared_ptr<const RecordedMotion> motion_;
  double scale_;
  std::uint64_t segments_looked_up_ = 0;
};

}  // namespace rocking::dynamics
