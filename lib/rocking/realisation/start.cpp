#include "rocking/realisation/start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "rocking/dynamics/impact.hpp"
#include "rocking/scene/drawn_quantities.hpp"

namespace rocking {
namespace {

using random::Source;

/// What a condition fixes for a realisation with this block.
dynamics::Setting setting_of(const Condition& condition, const dynamics::Geometry& block) {
  return {.block = block,
          .inertia = dynamics::slip_inertia(block, condition.scene.slide_inertia),
          .impact_slip_rule = condition.scene.impact_slip_rule,
          .tolerance = condition.tolerance,
          .ends_at_balance = condition.horizon.until == MotionEnd::balance};
}

/// A drawn number limited to [least, largest]; a number that is not drawn was checked.
void limit(Quantity& drawn, double least, double largest, std::uint64_t& clamps) {
  const double wanted = std::get<double>(drawn);
  const double limited = std::clamp(wanted, least, largest);
  if (limited != wanted) ++clamps;
  drawn = limited;
}

/// Limits what a law without bounds may give. What depends on the block comes after it.
void limit_drawn(Scene& scene, Source source, Quantity& drawn, Clamps& clamps) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  switch (source) {
    case Source::block_width:
    case Source::block_height:
    case Source::left_edge:
    case Source::right_edge:
    case Source::centre_height:
    case Source::radius_of_gyration: return limit(drawn, least_length, largest_length, clamps.length_at_bound);
    case Source::mean_static_friction: return limit(drawn, 0.0, infinity, clamps.static_at_zero);
    case Source::mean_kinetic_friction: return limit(drawn, 0.0, infinity, clamps.kinetic_at_zero);
    case Source::excitation_size:
    case Source::vertical_size: return limit(drawn, 0.0, infinity, clamps.amplitude_at_zero);
    case Source::mean_restitution:
    case Source::mean_right_restitution: {
      const Reach bounds = bounds_of(scene, source, dynamics::geometry_of(mean_of(scene.block)));
      return limit(drawn, bounds.least, bounds.largest, clamps.restitution);
    }
    default: return;
  }
}

/// The scene with a number in the place of each law.
Scene scene_of(const Scene& asked, const random::BranchedDraws& draws, std::uint64_t& count, Clamps& clamps) {
  Scene scene = asked;
  for_each_quantity(scene, [&](const QuantityPlace& what, Quantity& quantity) {
    if (!is_drawn(quantity)) return;
    ++count;
    const bool uniform = drawn_from(quantity) == BasicDraw::uniform;
    quantity = value_at(quantity, uniform ? draws.uniform(what.source, 0) : draws.standard_normal(what.source, 0));
    limit_drawn(scene, what.source, quantity, clamps);
  });
  return scene;
}

/// The equivalent angle in [0, 2 pi) [rad].
double wrapped(double angle) {
  constexpr double two_pi = 0x1.921fb54442d18p+2;
  const double turns = std::floor(angle / two_pi);
  const double rest = std::fma(-turns, two_pi, angle);
  return rest < two_pi && rest >= 0.0 ? rest : 0.0;
}

DrawnShaking shaking_of_start(const Start& start) {
  DrawnShaking drawn{.size = size_of(start.scene.excitation)};
  if (const auto* harmonic = std::get_if<Harmonic>(&start.scene.excitation)) {
    drawn.vertical = harmonic->vertical_sine(start.geometry, start.scene.block.gravity);
    drawn.vertical.phase = wrapped(drawn.vertical.phase);
  }
  if (const auto* recorded = std::get_if<Recorded>(&start.scene.excitation)) drawn.building = recorded->building;
  return drawn;
}

/// Of numbers without laws.
dynamics::State state_of(const InitialState& initial, const dynamics::Geometry& block) {
  const double tilt = mean_of(initial.tilt), tilt_rate = mean_of(initial.tilt_rate);
  const double slip = mean_of(initial.slip), slip_rate = mean_of(initial.slip_rate);
  const double psi = block.tilt_unit(tilt, tilt_rate);
  const double p = block.frequency_parameter, radius = block.half_diagonal;
  const InitialUnits& units = initial.units;
  return {.tilt = tilt_unit(units.tilt, psi) * tilt,
          .tilt_rate = units.tilt_rate == StateUnit::si ? tilt_rate / p : psi * tilt_rate,
          .slip = units.slip == StateUnit::si ? slip / radius : slip,
          .slip_rate = units.slip_rate == StateUnit::si ? slip_rate / (p * radius) : slip_rate};
}

}  // namespace

Start start_of(const Scene& asked, const random::BranchedDraws& draws) {
  Start start{};
  start.scene = scene_of(asked, draws, start.draws, start.clamps);
  const Scene& scene = start.scene;
  start.block = mean_of(scene.block);
  start.geometry = dynamics::geometry_of(start.block);
  start.phase = wrapped(mean_of(start_phase(scene.excitation)));
  start.state = state_of(scene.initial, start.geometry);
  return start;
}

Beginning begin_realisation(const Condition& condition, const random::BranchedDraws& draws, const Start& start,
                            Strobe strobe, std::int64_t periods) {
  const dynamics::Geometry mean = dynamics::geometry_of(mean_block(condition.scene));
  const double frequency_ratio = std::visit(
      [&](const auto& kind) { return kind.frequency_ratio_for(start.geometry, mean); }, start.scene.excitation);
  const dynamics::Clock clock(frequency_ratio, start.phase);
  const double first = strobe == Strobe::poincare ? 0.0 : clock.start();
  return {.setting = setting_of(condition, start.geometry),
          .clock = clock,
          .coefficients = SceneCoefficients(start.scene, draws, start.geometry),
          .state = start.state,
          .shaking = shaking_of_start(start),
          .schedule = {.first_strobe = {.period = 1, .time = first}, .strobes = periods},
          .draws = start.draws,
          .clamps = start.clamps};
}

dynamics::Excitation excitation_of(const Scene& scene, const Beginning& beginning) {
  return std::visit(
      [&](const auto& kind) -> dynamics::Excitation {
        return kind.motion(beginning.setting.block, beginning.clock, beginning.shaking);
      },
      scene.excitation);
}

}  // namespace rocking
