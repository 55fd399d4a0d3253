#include "rocking/studies/motion/motion.hpp"

#include <cmath>

#include "rocking/scene/intensity_measures.hpp"

namespace rocking {

SpectralPoint spectral_point(const std::vector<dynamics::GroundMotionSample>& samples, double gravity, double period_s,
                             double damping) {
  const OscillatorPeaks peaks = oscillator_peaks(samples, period_s, damping);
  return {.period_s = period_s,
          .sd_m = peaks.displacement * gravity,
          .sv_m_s = peaks.velocity * gravity,
          .sa_m_s2 = peaks.acceleration * gravity};
}

std::vector<double> spaced_periods(double first, double last, int count) {
  std::vector<double> periods;
  for (int i = 0; i < count; ++i)
    periods.push_back(first * std::pow(last / first, static_cast<double>(i) / (count - 1)));
  return periods;
}

}  // namespace rocking
