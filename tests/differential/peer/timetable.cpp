#include "differential/peer/timetable.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace rocking::peer {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;

std::int64_t whole(double count) {
  constexpr double rounding = 1e-10;
  return static_cast<std::int64_t>(std::floor(count + rounding));
}

double after(std::int64_t count, double pitch) { return static_cast<double>(count + 1) * pitch; }

}  // namespace

Timetable::Timetable(const Scene& scene)
    : frequency_(scene.frequency),
      phase_(scene.phase),
      period_(turn / scene.frequency),
      pitch_(period_ / scene.refreshes_per_period),
      pulse_(scene.pulse),
      friction_changes_(scene.sigmas.sliding > 0.0),
      amplitude_changes_(scene.sigmas.amplitude > 0.0) {}

double Timetable::sine(double tau) const {
  return pulse_ && strobes(tau) > 0 ? 0.0 : std::sin(frequency_ * tau + phase_);
}

std::int64_t Timetable::strobes(double tau) const { return whole(tau / period_); }

std::int64_t Timetable::interval(double tau) const { return whole(tau / pitch_); }

std::int64_t Timetable::excitation_period(double tau) const { return whole((frequency_ * tau + phase_) / turn); }

double Timetable::next_break(double tau, bool slips) const {
  double next = after(strobes(tau), period_);
  if (amplitude_changes_) next = std::min(next, after(excitation_period(tau), period_) - phase_ / frequency_);
  if (slips && friction_changes_) next = std::min(next, after(interval(tau), pitch_));
  return next;
}

double Timetable::next_reach(double tau, double up, double down) const {
  double first = std::numeric_limits<double>::infinity();
  if (pulse_ && strobes(tau) > 0) return first;
  const double argument = frequency_ * tau + phase_;
  const auto reach = [&first, argument](double root) {
    first = std::min(first, root + turn * std::ceil((argument - root) / turn));
  };
  if (up < 1.0) reach(std::asin(up));
  if (down < 1.0) reach(turn / 2.0 + std::asin(down));
  return std::max(tau, (first - phase_) / frequency_);
}

}  // namespace rocking::peer
