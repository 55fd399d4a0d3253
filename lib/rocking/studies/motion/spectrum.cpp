#include "rocking/studies/motion/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rocking/dynamics/excitation/recorded.hpp"

namespace rocking {
namespace {

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

  [[nodiscard]] Response at(double t) const {
    const double decay = std::exp(-of_.damping * of_.omega * t);
    const double c = decay * std::cos(of_.damped_omega * t);
    const double s = decay * std::sin(of_.damped_omega * t);
    const double free = cosine_ * c + sine_ * s;
    return {.displacement = mean_ + drift_ * t + free,
            .velocity = drift_ - of_.damping * of_.omega * free + of_.damped_omega * (sine_ * c - cosine_ * s),
            .base = base_ + slope_ * t};
  }

 private:
  const Oscillator& of_;
  double base_, slope_, drift_, mean_, cosine_, sine_;
};

/// Follows the largest absolute value of a quantity whose rate of change is known.
template <class Value, class Rate>
class Peak {
 public:
  Peak(Value value, Rate rate) : value_(value), rate_(rate) {}

  /// Takes in the response from `start` to `end` of a piece.
  void take(const PieceResponse& piece, double start, const Response& from, double end, const Response& to) {
    const double ends = std::max(std::abs(value_(from)), std::abs(value_(to)));
    largest_ = std::max(largest_, ends);
    const double rate = rate_(from);
    if ((rate < 0.0) == (rate_(to) < 0.0)) return;
    if (ends + (end - start) * (std::abs(rate) + std::abs(rate_(to))) <= largest_) return;
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

}  // namespace

SpectralPoint spectral_point(const std::vector<dynamics::GroundMotionSample>& samples, double gravity, double period_s,
                             double damping) {
  const Oscillator of(period_s, damping);
  Peak displacement([](const Response& r) { return r.displacement; }, [](const Response& r) { return r.velocity; });
  Peak velocity([](const Response& r) { return r.velocity; }, [&of](const Response& r) { return r.acceleration(of); });
  Peak acceleration([&of](const Response& r) { return r.absolute_acceleration(of); },
                    [&of](const Response& r) { return r.jerk(of); });
  Response now;
  const auto follow = [&](double length, double from, double to) {
    now.base = from;
    const PieceResponse piece(of, now, (to - from) / length);
    const double parts = std::max(1.0, std::ceil(length * points_in_a_period / period_s));
    double start = 0.0;
    for (double part = 1.0; part <= parts; part += 1.0) {
      const double end = length * (part / parts);
      const Response then = piece.at(end);
      displacement.take(piece, start, now, end, then);
      velocity.take(piece, start, now, end, then);
      acceleration.take(piece, start, now, end, then);
      now = then;
      start = end;
    }
  };
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    const double length = samples[i + 1].time - samples[i].time;
    if (length > 0.0) follow(length, samples[i].horizontal * gravity, samples[i + 1].horizontal * gravity);
  }
  follow(period_s, 0.0, 0.0);
  return {.period_s = period_s,
          .sd_m = displacement.largest(),
          .sv_m_s = velocity.largest(),
          .sa_m_s2 = acceleration.largest()};
}

std::vector<double> spaced_periods(double first, double last, int count) {
  std::vector<double> periods;
  for (int i = 0; i < count; ++i)
    periods.push_back(first * std::pow(last / first, static_cast<double>(i) / (count - 1)));
  return periods;
}

}  // namespace rocking
