#include "rocking/dynamics/excitation/recorded.hpp"

#include <algorithm>
#include <cmath>

namespace rocking::dynamics {
namespace {

Instant instant_of(double tau, const Clock& clock) {
  const double since_zero = tau + clock.start();
  const double periods = std::floor(since_zero / clock.period_length());
  return {.period = static_cast<std::int64_t>(periods), .time = std::fma(-periods, clock.period_length(), since_zero)};
}

}  // namespace

RecordedMotion::RecordedMotion(const std::vector<RecordSample>& samples, double frequency_parameter,
                               const Clock& clock) {
  knots_.reserve(samples.size());
  for (const RecordSample& sample : samples) {
    knots_.push_back({.instant = instant_of(sample.time * frequency_parameter, clock),
                      .horizontal = sample.horizontal,
                      .vertical = sample.vertical});
  }
}

RecordedMotion::Segment RecordedMotion::segment(const Clock& clock) const {
  const auto is_reached = [&clock](const Knot& knot) { return clock.until(knot.instant) <= clock.resolution(); };
  const auto next = std::partition_point(knots_.begin(), knots_.end(), is_reached);
  Segment segment;
  if (next == knots_.end()) return segment;
  segment.end = next->instant;
  if (next == knots_.begin()) return segment;
  const Knot& last = *(next - 1);
  const double elapsed = -clock.until(last.instant);
  const double span = clock.until(next->instant) + elapsed;
  segment.horizontal_slope = (next->horizontal - last.horizontal) / span;
  segment.vertical_slope = (next->vertical - last.vertical) / span;
  segment.horizontal = std::fma(segment.horizontal_slope, elapsed, last.horizontal);
  segment.vertical = std::fma(segment.vertical_slope, elapsed, last.vertical);
  return segment;
}

}  // namespace rocking::dynamics
