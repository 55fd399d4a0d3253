#include "rocking/experiment/realisation.hpp"

#include <cmath>
#include <variant>

#include "rocking/experiment/check_condition.hpp"

namespace rocking::experiment {
namespace {

using random::Source;

class QuantityReader {
 public:
  explicit QuantityReader(const random::Draws& draws) : draws_(&draws) {}

  [[nodiscard]] double value(const Quantity& quantity, Source source) {
    if (const auto* number = std::get_if<double>(&quantity)) return *number;
    ++count_;
    if (const auto* law = std::get_if<Uniform>(&quantity)) {
      return law->low + (law->high - law->low) * draws_->uniform(source, 0);
    }
    const auto& law = std::get<Normal>(quantity);
    return law.mean + law.sigma * draws_->standard_normal(source, 0);
  }

  [[nodiscard]] std::uint64_t count() const { return count_; }

 private:
  const random::Draws* draws_;
  std::uint64_t count_ = 0;
};

/// The same angle in [0, 2 pi).
double wrapped(double angle) {
  constexpr double two_pi = 0x1.921fb54442d18p+2;
  const double turns = std::floor(angle / two_pi);
  const double rest = std::fma(-turns, two_pi, angle);
  return rest < two_pi && rest >= 0.0 ? rest : 0.0;
}

}  // namespace

Start start_of(const Scene& scene, const random::Draws& draws) {
  const double psi = dynamics::geometry_of(scene.block).shape_angle;
  QuantityReader reader(draws);
  Start start{};
  start.phase = wrapped(reader.value(start_phase(scene.excitation), Source::phase));
  start.state.tilt = psi * reader.value(scene.initial.tilt, Source::tilt);
  start.state.tilt_rate = psi * reader.value(scene.initial.tilt_rate, Source::tilt_rate);
  start.state.slip_rate = reader.value(scene.initial.slip_rate, Source::slip_rate);
  start.draws = reader.count();
  return start;
}

Beginning begin_realisation(const Condition& condition, const random::Draws& draws, const Start& start, Strobe strobe,
                            std::int64_t periods) {
  check_condition(condition);
  const Scene& scene = condition.scene;
  const dynamics::Clock clock(frequency_ratio(scene.excitation), start.phase);
  const double first = strobe == Strobe::poincare ? 0.0 : clock.start();
  return {.setting = {.block = dynamics::geometry_of(scene.block),
                      .inertia = dynamics::inertia_ratio(scene.slide_inertia),
                      .impact_slip_rule = scene.impact_slip_rule,
                      .tolerance = condition.tolerance},
          .clock = clock,
          .coefficients = SceneCoefficients(scene, draws),
          .state = start.state,
          .schedule = {.first_strobe = {.period = 1, .time = first}, .strobes = periods}};
}

}  // namespace rocking::experiment
