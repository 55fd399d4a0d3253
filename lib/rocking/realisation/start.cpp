#include "rocking/realisation/start.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <variant>

namespace rocking {
namespace {

/// What a condition fixes for a realisation with this block.
dynamics::Setting setting_of(const Condition& condition, const dynamics::Geometry& block) {
  return {.block = block,
          .inertia = dynamics::inertia_ratio(condition.scene.slide_inertia),
          .impact_slip_rule = condition.scene.impact_slip_rule,
          .tolerance = condition.tolerance};
}

using random::Source;

class QuantityReader {
 public:
  explicit QuantityReader(const random::BranchedDraws& draws) : draws_(&draws) {}

  [[nodiscard]] double value(const Quantity& quantity, Source source) {
    if (const auto* number = std::get_if<double>(&quantity)) return *number;
    ++count_;
    if (const auto* law = std::get_if<Uniform>(&quantity)) {
      return law->low + (law->high - law->low) * draws_->uniform(source, 0);
    }
    const auto& law = std::get<Normal>(quantity);
    return law.mean + law.sigma * draws_->standard_normal(source, 0);
  }

  /// A drawn length is truncated to its bounds; a number is taken as it is.
  [[nodiscard]] double length(const Quantity& length, Source source) {
    const double wanted = value(length, source);
    if (!is_drawn(length)) return wanted;
    const double truncated = std::clamp(wanted, least_length, largest_length);
    if (truncated != wanted) ++clamps_.length_at_bound;
    return truncated;
  }

  [[nodiscard]] std::uint64_t count() const { return count_; }
  [[nodiscard]] const Clamps& clamps() const { return clamps_; }

 private:
  const random::BranchedDraws* draws_;
  std::uint64_t count_ = 0;
  Clamps clamps_;
};

/// The equivalent angle in [0, 2 pi) [rad].
double wrapped(double angle) {
  constexpr double two_pi = 0x1.921fb54442d18p+2;
  const double turns = std::floor(angle / two_pi);
  const double rest = std::fma(-turns, two_pi, angle);
  return rest < two_pi && rest >= 0.0 ? rest : 0.0;
}

dynamics::Excitation excitation_of(const Harmonic&, const Beginning&) { return dynamics::HarmonicExcitation{}; }

dynamics::Excitation excitation_of(const Recorded& recorded, const Beginning& beginning) {
  const GroundMotion& motion = *recorded.ground_motion;
  const auto knots = std::make_shared<const dynamics::NormalisedGroundMotion>(
      motion.samples, beginning.setting.block.frequency_parameter, beginning.clock);
  if (motion.has_vertical) return dynamics::RecordedExcitation<true>(knots, recorded.scale);
  return dynamics::RecordedExcitation<false>(knots, recorded.scale);
}

dynamics::Excitation excitation_of(const Pulse& pulse, const Beginning& beginning) {
  return dynamics::PulseExcitation(pulse.shape, beginning.clock);
}

}  // namespace

Start start_of(const Scene& scene, const random::BranchedDraws& draws) {
  QuantityReader reader(draws);
  Start start{};
  start.block = {.width = reader.length(scene.block.width, Source::block_width),
                 .height = reader.length(scene.block.height, Source::block_height),
                 .gravity = scene.block.gravity};
  start.geometry = dynamics::geometry_of(start.block);
  const double psi = start.geometry.shape_angle;
  start.phase = wrapped(reader.value(start_phase(scene.excitation), Source::phase));
  start.state.tilt = psi * reader.value(scene.initial.tilt, Source::tilt);
  start.state.tilt_rate = psi * reader.value(scene.initial.tilt_rate, Source::tilt_rate);
  start.state.slip_rate = reader.value(scene.initial.slip_rate, Source::slip_rate);
  start.draws = reader.count();
  start.clamps = reader.clamps();
  return start;
}

Beginning begin_realisation(const Condition& condition, const random::BranchedDraws& draws, const Start& start,
                            Strobe strobe, std::int64_t periods) {
  const Scene& scene = condition.scene;
  const dynamics::Clock clock(frequency_ratio_for(scene, start.geometry), start.phase);
  const double first = strobe == Strobe::poincare ? 0.0 : clock.start();
  return {.setting = setting_of(condition, start.geometry),
          .clock = clock,
          .coefficients = SceneCoefficients(scene, draws, start.geometry),
          .state = start.state,
          .schedule = {.first_strobe = {.period = 1, .time = first}, .strobes = periods},
          .draws = start.draws,
          .clamps = start.clamps};
}

dynamics::Excitation excitation_of(const Scene& scene, const Beginning& beginning) {
  return std::visit([&](const auto& kind) { return excitation_of(kind, beginning); }, scene.excitation);
}

}  // namespace rocking
