#include "rocking/scene/intensity_measures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rocking/base/elementary.hpp"
#include "rocking/base/natural_logarithm.hpp"

namespace rocking {
namespace {

constexpr double standard_damping = 0.05;
/// Points in a period at which the response is looked at; extremes between two of them are found as roots.
constexpr double points_in_a_period = 40.0;

struct Oscillator {
  double omega;
  double damping;
  double damped_omega;

  Oscillator(double period, double ratio)
      : omega(2.0 * std::numbers::pi / period), damping(ratio), damped_omega(omega * std::sqrt(1.0 - ratio * ratio)) {}
};

/// The oscillator at an instant, and what its base does then.
struct Response {
  double displacement = 0.0;
  double velocity = 0.0;
  double base = 0.0;

  [[nodiscard]] double absolute_acceleration(const Oscillator& of) const {
    return -of.omega * (2.0 * of.damping * velocity + of.omega * displacement);
  }
  [[nodiscard]] double acceleration(const Oscillator& of) const { return absolute_acceleration(of) - base; }
  /// Rate of change of the absolute acceleration.
  [[nodiscard]] double jerk(const Oscillator& of) const {
    return -of.omega * (2.0 * of.damping * acceleration(of) + of.omega * velocity);
  }
};

/// exp(-damping omega t) times cosine and sine of damped_omega t, for t of a small part of a period.
struct FreeMotion {
  double time = 0.0;
  double cosine = 1.0;
  double sine = 0.0;

  FreeMotion(const Oscillator& of, double t) : time(t) {
    const double decay = base::exponential(-of.damping * of.omega * t);
    const auto [sine_there, cosine_there] = base::sin_cos(of.damped_omega * t);
    cosine = decay * cosine_there;
    sine = decay * sine_there;
  }
};

/// The exact response to a base acceleration a + s t, from t = 0 on.
class PieceResponse {
 public:
  PieceResponse(const Oscillator& of, const Response& start, double slope)
      : of_(of),
        base_(start.base),
        slope_(slope),
        drift_(-slope / (of.omega * of.omega)),
        mean_(-(start.base - 2.0 * of.damping * slope / of.omega) / (of.omega * of.omega)),
        cosine_(start.displacement - mean_),
        sine_((start.velocity - drift_ + of.damping * of.omega * cosine_) / of.damped_omega) {}

  [[nodiscard]] Response at(const FreeMotion& free) const {
    const double change = cosine_ * free.cosine + sine_ * free.sine;
    return {.displacement = mean_ + drift_ * free.time + change,
            .velocity = drift_ - of_.damping * of_.omega * change +
                        of_.damped_omega * (sine_ * free.cosine - cosine_ * free.sine),
            .base = base_ + slope_ * free.time};
  }
  [[nodiscard]] Response at(double t) const { return at(FreeMotion(of_, t)); }

 private:
  const Oscillator& of_;
  double base_, slope_, drift_, mean_, cosine_, sine_;
};

/// Follows the largest absolute value of a quantity whose rate of change is known.
template <class Value, class Rate>
class Peak {
 public:
  Peak(Value value, Rate rate) : value_(value), rate_(rate) {}

  /// Takes in the response over a piece.
  void take(const PieceResponse& piece, const Response& from, double length, const Response& to) {
    const double ends = std::max(std::abs(value_(from)), std::abs(value_(to)));
    largest_ = std::max(largest_, ends);
    const double rate = rate_(from);
    if ((rate < 0.0) == (rate_(to) < 0.0)) return;
    if (ends + length * (std::abs(rate) + std::abs(rate_(to))) <= largest_) return;
    double start = 0.0;
    double end = length;
    for (int i = 0; i < 40; ++i) {  // the value is flat there: half the digits of the time suffice
      const double middle = 0.5 * (start + end);
      ((rate_(piece.at(middle)) < 0.0) == (rate < 0.0) ? start : end) = middle;
    }
    largest_ = std::max(largest_, std::abs(value_(piece.at(0.5 * (start + end)))));
  }

  [[nodiscard]] double largest() const { return largest_; }

 private:
  Value value_;
  Rate rate_;
  double largest_ = 0.0;
};

auto peak_displacement() {
  return Peak([](const Response& r) { return r.displacement; }, [](const Response& r) { return r.velocity; });
}

auto peak_acceleration_of(const Oscillator& of) {
  return Peak([&of](const Response& r) { return r.absolute_acceleration(of); },
              [&of](const Response& r) { return r.jerk(of); });
}

/// Takes the response to a motion, and that of one period after it, into the peaks.
template <class... Peaks>
void follow(const std::vector<dynamics::GroundMotionSample>& samples, const Oscillator& of, double period_s,
            Peaks&... peaks) {
  Response now;
  FreeMotion free(of, 0.0);
  const auto pass = [&](double length, double from, double to) {
    const double parts = std::max(1.0, std::ceil(length * points_in_a_period / period_s));
    const double part = length / parts;
    if (free.time != part) free = FreeMotion(of, part);
    for (double i = 0.0; i < parts; i += 1.0) {
      now.base = from + (to - from) * (i / parts);
      const PieceResponse piece(of, now, (to - from) / length);
      const Response then = piece.at(free);
      (peaks.take(piece, now, part, then), ...);
      now = then;
    }
  };
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const double length = samples[i + 1].time - samples[i].time;
    if (length > 0.0) pass(length, samples[i].horizontal, samples[i + 1].horizontal);
  }
  pass(period_s, 0.0, 0.0);
}

}  // namespace

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

double final_velocity(const std::vector<dynamics::GroundMotionSample>& samples, double gravity) {
  double velocity = 0.0;  // over g, in s
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    velocity += 0.5 * (samples[i + 1].time - samples[i].time) * (samples[i].horizontal + samples[i + 1].horizontal);
  }
  return velocity * gravity;
}

OscillatorPeaks oscillator_peaks(const std::vector<dynamics::GroundMotionSample>& samples, double period_s,
                                 double damping) {
  const Oscillator of(period_s, damping);
  Peak displacement = peak_displacement();
  Peak velocity([](const Response& r) { return r.velocity; }, [&of](const Response& r) { return r.acceleration(of); });
  Peak acceleration = peak_acceleration_of(of);
  follow(samples, of, period_s, displacement, velocity, acceleration);
  return {
      .displacement = displacement.largest(), .velocity = velocity.largest(), .acceleration = acceleration.largest()};
}

double spectral_acceleration(const std::vector<dynamics::GroundMotionSample>& samples, double period_s,
                             OscillatorAcceleration which) {
  const Oscillator of(period_s, standard_damping);
  if (which == OscillatorAcceleration::absolute) {
    Peak acceleration = peak_acceleration_of(of);
    follow(samples, of, period_s, acceleration);
    return acceleration.largest();
  }
  Peak displacement = peak_displacement();
  follow(samples, of, period_s, displacement);
  return of.omega * of.omega * displacement.largest();
}

double average_spectral_acceleration(const std::vector<dynamics::GroundMotionSample>& samples, double first_s,
                                     double last_s) {
  constexpr int periods = 10;
  const double width = base::natural_logarithm(last_s / first_s);
  double sum = 0.0;
  for (int i = 0; i < periods; ++i) {
    const double period = i + 1 == periods ? last_s : first_s * base::exponential(width * i / (periods - 1));
    const double found = spectral_acceleration(samples, period, OscillatorAcceleration::pseudo);
    if (!(found > 0.0)) return 0.0;
    sum += base::natural_logarithm(found);
  }
  return base::exponential(sum / periods);
}

}  // namespace rocking
