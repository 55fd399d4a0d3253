#include "rocking/scene/ground_motion_peaks.hpp"

#include <algorithm>
#include <cmath>

namespace rocking {

double peak_acceleration(const std::vector<dynamics::GroundMotionSample>& samples) {
  double peak = 0.0;
  for (const dynamics::GroundMotionSample& sample : samples) peak = std::max(peak, std::abs(sample.horizontal));
  return peak;
}

double peak_velocity(const std::vector<dynamics::GroundMotionSample>& samples, double gravity) {
  double velocity = 0.0;  // over g, in s
  double peak = 0.0;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const double step = samples[i + 1].time - samples[i].time;
    const double from = samples[i].horizontal;
    const double to = samples[i + 1].horizontal;
    if ((from < 0.0) != (to < 0.0)) {
      const double until_zero = step * (from / (from - to));
      peak = std::max(peak, std::abs(velocity + 0.5 * from * until_zero));
    }
    velocity += 0.5 * step * (from + to);
    peak = std::max(peak, std::abs(velocity));
  }
  return peak * gravity;
}

}  // namespace rocking
