#include "rocking/scene/building.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>

#include "rocking/base/elementary.hpp"
#include "rocking/base/natural_logarithm.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/scene/drawn_quantities.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using Samples = std::vector<dynamics::GroundMotionSample>;

constexpr double steps_in_a_period = 10.0;
constexpr double end_of_motion = 1e-3;   ///< over the peak
constexpr double step_rounding = 1e-11;  ///< of the steps between times of even samples, over the step

/// Displacement and velocity after a step, of a unit of something at its beginning.
struct ModeState {
  double displacement = 0.0;
  double velocity = 0.0;
};

/// A mode as an oscillator.
struct ModeOscillator {
  double omega;    ///< w [rad/s]
  double damping;  ///< z
  double factor;

  /// After a step, from this displacement and velocity, under the base acceleration a + s t/step. By its Taylor series, which
  /// has no cancellation where the step is short: at most a tenth of a period, so that 24 terms are exact to rounding.
  [[nodiscard]] ModeState after(double step, double displacement, double velocity, double a, double s) const {
    constexpr int terms = 24;
    const double turn = omega * step;
    double last = displacement;
    double next = velocity * step;
    ModeState sum{.displacement = last + next, .velocity = next};
    for (int k = 0; k < terms; ++k) {
      const double forcing = k == 0 ? a : k == 1 ? s : 0.0;
      const double coefficient =
          (-2.0 * damping * turn * (k + 1) * next - turn * turn * last - step * step * forcing) / ((k + 2) * (k + 1));
      last = next;
      next = coefficient;
      sum.displacement += coefficient;
      sum.velocity += (k + 2) * coefficient;
    }
    sum.velocity /= step;
    return sum;
  }
};

/// The exact change of an oscillator over a step with a linear base acceleration: a matrix.
struct ModeStep {
  ModeState of_displacement, of_velocity, of_base, of_change;

  ModeStep() = default;
  ModeStep(const ModeOscillator& of, double length)
      : of_displacement(of.after(length, 1.0, 0.0, 0.0, 0.0)),
        of_velocity(of.after(length, 0.0, 1.0, 0.0, 0.0)),
        of_base(of.after(length, 0.0, 0.0, 1.0, 0.0)),
        of_change(of.after(length, 0.0, 0.0, 0.0, 1.0)) {}
};

/// A mode as it moves.
class ModeMotion {
 public:
  explicit ModeMotion(const ModeOscillator& of) : of_(of) {}

  void set_step(double length) { step_ = ModeStep(of_, length); }
  void pass_step(double from, double to) {
    const auto after = [&](double ModeState::*part) {
      return step_.of_displacement.*part * now_.displacement + step_.of_velocity.*part * now_.velocity +
             step_.of_base.*part * from + step_.of_change.*part * (to - from);
    };
    now_ = {.displacement = after(&ModeState::displacement), .velocity = after(&ModeState::velocity)};
  }
  /// What the mode adds to the acceleration of the ground.
  [[nodiscard]] double acceleration(double ground) const {
    const double relative = -of_.omega * (2.0 * of_.damping * now_.velocity + of_.omega * now_.displacement) - ground;
    return of_.factor * relative;
  }
  /// The largest that it adds from now on over a ground that rests.
  [[nodiscard]] double largest_from_now_on() const {
    const double sine = (now_.velocity + of_.damping * of_.omega * now_.displacement) /
                        (of_.omega * std::sqrt(1.0 - of_.damping * of_.damping));
    return std::abs(of_.factor) * of_.omega * of_.omega *
           std::sqrt(now_.displacement * now_.displacement + sine * sine);
  }

 private:
  ModeOscillator of_;
  ModeStep step_;
  ModeState now_;
};

/// The modes of a building one after another, and the floor.
class FloorMotion {
 public:
  explicit FloorMotion(const std::vector<BuildingMode>& modes) {
    for (const BuildingMode& mode : modes) {
      const double frequency = std::get<double>(mode.frequency_hz);
      highest_frequency_ = std::max(highest_frequency_, frequency);
      modes_.emplace_back(ModeOscillator{.omega = 2.0 * std::numbers::pi * frequency,
                                         .damping = std::get<double>(mode.damping_ratio),
                                         .factor = std::get<double>(mode.factor)});
    }
  }

  void add_sample(double time, double ground, double vertical) {
    double acceleration = ground;
    for (const ModeMotion& mode : modes_) acceleration += mode.acceleration(ground);
    peak_ = std::max(peak_, std::abs(acceleration));
    samples_.push_back({.time = time, .horizontal = acceleration, .vertical = vertical});
  }

  /// From a sample of the ground to the next one, which is later.
  void pass(const dynamics::GroundMotionSample& from, const dynamics::GroundMotionSample& to) {
    const double length = to.time - from.time;
    const double needed = length * highest_frequency_ * steps_in_a_period;
    const double parts = std::max(1.0, std::ceil(needed - step_rounding * needed));
    set_step(length / parts);
    double before = from.horizontal;
    for (double i = 1.0; i <= parts; i += 1.0) {
      const bool is_last = i == parts;
      const double share = i / parts;
      const double ground = is_last ? to.horizontal : from.horizontal + share * (to.horizontal - from.horizontal);
      for (ModeMotion& mode : modes_) mode.pass_step(before, ground);
      add_sample(is_last ? to.time : from.time + share * length, ground,
                 is_last ? to.vertical : from.vertical + share * (to.vertical - from.vertical));
      before = ground;
    }
  }

  /// Over a ground that rests from now on.
  void come_to_rest() {
    const double start = samples_.back().time;
    for (double i = 1.0; largest_from_now_on() >= end_of_motion * peak_ && peak_ > 0.0; i += 1.0) {
      for (ModeMotion& mode : modes_) mode.pass_step(0.0, 0.0);
      add_sample(start + i * step_, 0.0, 0.0);
    }
    while (samples_.back().time > start && std::abs(samples_[samples_.size() - 2].horizontal) < end_of_motion * peak_) {
      samples_.pop_back();
    }
  }

  [[nodiscard]] Samples samples() && { return std::move(samples_); }

 private:
  /// Times of even samples differ from multiples of their step by rounding, from which no new matrix is computed.
  void set_step(double length) {
    if (std::abs(length - step_) <= step_rounding * length) return;
    step_ = length;
    for (ModeMotion& mode : modes_) mode.set_step(length);
  }

  [[nodiscard]] double largest_from_now_on() const {
    double sum = 0.0;
    for (const ModeMotion& mode : modes_) sum += mode.largest_from_now_on();
    return sum;
  }

  std::vector<ModeMotion> modes_;
  double highest_frequency_ = 0.0;
  double step_ = 0.0;
  double peak_ = 0.0;
  Samples samples_;
};

}  // namespace

bool is_drawn(const Building& building) {
  bool found = false;
  quantities::visit_building(
      building, [&found](const QuantityPlace&, const Quantity& number) { found = found || is_drawn(number); });
  return found;
}

std::vector<BuildingMode> modes_of(const Building& building) {
  std::vector<BuildingMode> modes;
  for (const auto& [frequency, damping, factor] : building.modes) {
    modes.push_back({.frequency_hz = mean_of(frequency), .damping_ratio = mean_of(damping), .factor = mean_of(factor)});
  }
  if (!modes.empty()) return modes;
  for (int i = 1; i <= building.uniform_modes; ++i) {
    const double odd = 2.0 * i - 1.0;
    const double shape = base::sin_cos(0.5 * odd * std::numbers::pi * mean_of(building.height_ratio)).sine;
    modes.push_back({.frequency_hz = odd * mean_of(building.frequency_hz),
                     .damping_ratio = mean_of(building.damping_ratio),
                     .factor = 4.0 / (odd * std::numbers::pi) * shape});
  }
  return modes;
}

BuildingNumber mode_number(std::size_t i, std::size_t k) {
  static const auto texts = [] {
    constexpr std::array<std::string_view, 3> keys{"frequency_hz", "damping_ratio", "factor"};
    constexpr std::array<std::string_view, 3> names{"frequency", "damping ratio", "factor"};
    std::vector<std::array<std::string, 2>> made;
    for (std::size_t mode = 0; mode < most_building_modes; ++mode) {
      const std::string number = std::to_string(mode);
      for (std::size_t j = 0; j < keys.size(); ++j) {
        made.push_back({"/excitation/building/modes/" + number + '/' + std::string(keys[j]),
                        std::string(names[j]) + " of mode " + number});
      }
    }
    return made;
  }();
  const std::size_t place = 3 * i + k;
  const auto source =
      static_cast<random::Source>(static_cast<std::size_t>(random::Source::first_building_mode) + place);
  constexpr std::array<const Rule*, 3> bounds{&rules::building_frequency_hz, &rules::damping_ratio, nullptr};
  return {{{texts[place][0], texts[place][1]}, source}, bounds[k]};
}

std::string floor_in_words(const Building& building) {
  const auto number = [](const Quantity& quantity) { return base::significant(mean_of(quantity), 3); };
  const std::vector<BuildingMode> modes = modes_of(building);
  const std::string of = "a building of " + number(modes.front().frequency_hz) + " Hz, " +
                         base::significant(100.0 * mean_of(modes.front().damping_ratio), 3) + " % damping";
  const std::string means = is_drawn(building) ? " (means of what is drawn)" : "";
  if (!building.modes.empty()) return "on a floor of " + of + ", with " + counted(modes.size(), "mode") + means;
  return "on a floor at " + number(building.height_ratio) + " of the height of " + of + means;
}

double settling_time(const Building& building) {
  double slowest = std::numeric_limits<double>::infinity();
  for (const BuildingMode& mode : modes_of(building)) {
    slowest = std::min(slowest, mean_of(mode.damping_ratio) * 2.0 * std::numbers::pi * mean_of(mode.frequency_hz));
  }
  return -base::natural_logarithm(end_of_motion) / slowest;
}

Samples floor_motion(const Samples& ground, const Building& building) {
  FloorMotion floor(modes_of(building));
  const auto& first = ground.front();
  floor.add_sample(first.time, first.horizontal, first.vertical);
  for (std::size_t i = 1; i < ground.size(); ++i) {
    if (ground[i].time > ground[i - 1].time) {
      floor.pass(ground[i - 1], ground[i]);
    } else {
      floor.add_sample(ground[i].time, ground[i].horizontal, ground[i].vertical);
    }
  }
  const auto& last = ground.back();
  if (last.horizontal != 0.0 || last.vertical != 0.0) floor.add_sample(last.time, 0.0, 0.0);
  floor.come_to_rest();
  return std::move(floor).samples();
}

}  // namespace rocking
