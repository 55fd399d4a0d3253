#include "rocking/studies/motion/study.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "rocking/plan/plan.hpp"
#include "rocking/scene/intensity_measures.hpp"

namespace rocking {
namespace {

using GroundMotionSamples = std::vector<dynamics::GroundMotionSample>;

/// From one sample to the next: a + s t, with its integrals from there on.
struct LinearPiece {
  double length;        ///< [s]
  double acceleration;  ///< a at its start
  double end;           ///< a at its end

  [[nodiscard]] double slope() const { return (end - acceleration) / length; }
  [[nodiscard]] double velocity(double t) const { return t * (acceleration + 0.5 * slope() * t); }
  [[nodiscard]] double displacement(double t) const { return t * t * (0.5 * acceleration + slope() * t / 6.0); }
  /// Integral of a^2.
  [[nodiscard]] double energy(double t) const {
    const double a = acceleration + slope() * t;
    return t * (acceleration * acceleration + acceleration * a + a * a) / 3.0;
  }
  [[nodiscard]] double absolute() const {
    if ((acceleration < 0.0) == (end < 0.0)) return 0.5 * length * (std::abs(acceleration) + std::abs(end));
    return 0.5 * length * (acceleration * acceleration + end * end) / (std::abs(acceleration) + std::abs(end));
  }
};

/// Calls visit(piece, start) for each piece that lasts, with its accelerations in m/s^2.
template <class Visit>
void for_each_piece(const GroundMotionSamples& samples, double gravity, Visit&& visit) {
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const double length = samples[i + 1].time - samples[i].time;
    if (!(length > 0.0)) continue;
    visit(LinearPiece{length, samples[i].horizontal * gravity, samples[i + 1].horizontal * gravity}, samples[i].time);
  }
}

/// Times within a piece at which a velocity that is `before` at its start passes 0; at most two.
std::vector<double> turning_points(const LinearPiece& piece, double before) {
  const double a = 0.5 * piece.slope();
  const double b = piece.acceleration;
  const double discriminant = b * b - 4.0 * a * before;
  std::vector<double> times;
  if (discriminant < 0.0) return times;
  const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
  for (const double time : {q / a, before / q}) {
    if (time > 0.0 && time < piece.length) times.push_back(time);  // not where it is infinite or no number
  }
  return times;
}

/// When the integral of a^2 reaches `goal`; it is monotone, so that bisection finds the time to the last bits.
double time_of_energy(const GroundMotionSamples& samples, double gravity, double goal) {
  double before = 0.0;
  std::optional<double> found;
  for_each_piece(samples, gravity, [&](const LinearPiece& piece, double start) {
    const double all = piece.energy(piece.length);
    if (!found && before + all >= goal) {
      double low = 0.0;
      double high = piece.length;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (before + piece.energy(middle) < goal ? low : high) = middle;
      }
      found = start + high;
    }
    before += all;
  });
  return found.value_or(samples.back().time);
}

}  // namespace

std::vector<BasePoint> base_motion_of(const GroundMotionSamples& samples, double gravity) {
  std::vector<BasePoint> points;
  points.reserve(samples.size());
  BasePoint now{.time = samples.front().time, .acceleration = 0.0, .velocity = 0.0, .displacement = 0.0};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    now.acceleration = samples[i].horizontal * gravity;
    if (const double length = samples[i].time - now.time; length > 0.0) {
      const LinearPiece piece{length, samples[i - 1].horizontal * gravity, now.acceleration};
      now.displacement += now.velocity * length + piece.displacement(length);
      now.velocity += piece.velocity(length);
      now.time = samples[i].time;
    }
    points.push_back(now);
  }
  return points;
}

IntensityMeasures intensity_measures(const GroundMotionSamples& samples, double gravity) {
  IntensityMeasures found;
  found.pga_g = peak_acceleration(samples);
  const auto reaches_peak = [&found](const auto& sample) { return std::abs(sample.horizontal) == found.pga_g; };
  found.pga_time_s = std::ranges::find_if(samples, reaches_peak)->time;
  found.pgv_m_s = peak_velocity(samples, gravity);
  double velocity = 0.0;
  double displacement = 0.0;
  double energy = 0.0;
  for_each_piece(samples, gravity, [&](const LinearPiece& piece, double) {
    for (const double time : turning_points(piece, velocity)) {
      found.pgd_m = std::max(found.pgd_m, std::abs(displacement + velocity * time + piece.displacement(time)));
    }
    displacement += velocity * piece.length + piece.displacement(piece.length);
    velocity += piece.velocity(piece.length);
    energy += piece.energy(piece.length);
    found.cav_m_s += piece.absolute();
    found.pgd_m = std::max(found.pgd_m, std::abs(displacement));
  });
  found.arias_m_s = std::numbers::pi / (2.0 * gravity) * energy;
  found.significant_from_s = time_of_energy(samples, gravity, 0.05 * energy);
  found.significant_to_s = time_of_energy(samples, gravity, 0.95 * energy);
  for (const auto& sample : samples) found.vertical_pga_g = std::max(found.vertical_pga_g, std::abs(sample.vertical));
  return found;
}

SpectralPoint spectral_point(const std::vector<dynamics::GroundMotionSample>& samples, double gravity, double period_s,
                             double damping) {
  const OscillatorPeaks peaks = oscillator_peaks(samples, period_s, damping);
  constexpr double two_pi = 0x1.921fb54442d18p+2;
  const double omega = two_pi / period_s;
  const double displacement = peaks.displacement * gravity;
  return {.period_s = period_s,
          .sa_g = omega * omega * displacement / gravity,
          .sa_absolute_g = peaks.acceleration * gravity / gravity,  // with the bits of an acceleration in m/s^2
          .sv_m_s = peaks.velocity * gravity,
          .sd_m = displacement,
          .psv_m_s = omega * displacement};
}

std::vector<double> spaced_periods(double first, double last, int count) {
  std::vector<double> periods;
  for (int i = 0; i < count; ++i)
    periods.push_back(first * std::pow(last / first, static_cast<double>(i) / (count - 1)));
  return periods;
}

MeasuredMotion measured(std::shared_ptr<const GroundMotion> motion, std::string sha256,
                        const MotionQuestion& question) {
  MeasuredMotion found;
  found.measures = intensity_measures(motion->samples, question.gravity);
  for (const double period : question.periods) {
    found.spectrum.push_back(spectral_point(motion->samples, question.gravity, period, question.damping));
  }
  if (const auto& block = question.block) {
    const dynamics::Block of_lengths{block->front(), block->back(), question.gravity};
    found.uplift_scale = least_uplift_scale(motion->samples, dynamics::geometry_of(of_lengths).tangents());
  }
  found.motion = std::move(motion);
  found.sha256 = std::move(sha256);
  return found;
}

}  // namespace rocking
