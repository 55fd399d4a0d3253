#include "rocking/scene/defaults.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "rocking/dynamics/impact.hpp"
#include "rocking/scene/restitution.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {

FormulationOptions options_of(Formulation formulation) {
  using dynamics::ImpactSlipRule;
  using dynamics::SlideInertia;
  switch (formulation) {
    case Formulation::consistent: break;
    case Formulation::as_printed: return {SlideInertia::edge, true, ImpactSlipRule::signed_ratio};
    case Formulation::as_plotted: return {SlideInertia::edge, false, ImpactSlipRule::signed_ratio};
  }
  return {Scene{}.slide_inertia, false, Scene{}.impact_slip_rule};
}

double strobe_once_a_second(const dynamics::Block& block) {
  constexpr double two_pi = 0x1.921fb54442d18p+2;
  return std::clamp(two_pi / dynamics::geometry_of(block).frequency_parameter, rules::least_frequency_ratio,
                    rules::largest_frequency_ratio);
}

DefaultHorizon default_horizon(const Scene& scene) {
  if (!is_periodic(scene.excitation)) return {0, periods_until_rest(scene)};
  return {Horizon{}.transient_periods, Horizon{}.sampled_periods};
}

namespace {

/// abs(delta) of the mean block where the left and where the right edge lands.
std::array<double, 2> rate_ratios_of(const Scene& scene, const dynamics::Geometry& block) {
  const auto at = [&](double side) {
    const double e = mean_restitution(scene.restitution, block, side);
    return std::abs(dynamics::inelastic_rate_ratio(block.edge(side), e));
  };
  return {at(1.0), at(-1.0)};
}

}  // namespace

bool impacts_take_energy(const Scene& scene) {
  const dynamics::Geometry block = dynamics::geometry_of(mean_block(scene));
  const auto [left, right] = rate_ratios_of(scene, block);
  const bool has_base = block.edge(1.0).sine > 0.0;  // without one the block is refused anyway
  return !(left == 1.0 && right == 1.0 && has_base);
}

std::int64_t periods_until_rest(const Scene& scene) {
  constexpr double two_pi = 0x1.921fb54442d18p+2;
  constexpr double first_hop = 8.0, other_hops = 4.0, least_loss = 1e-3;  // derived in the header
  const dynamics::Geometry block = dynamics::geometry_of(mean_block(scene));
  const auto [left, right] = rate_ratios_of(scene, block);
  const double largest = std::max(left, right);
  const double coming_to_rest = first_hop + other_hops / std::max(1.0 - largest, least_loss);
  const double shaking = std::visit([&](const auto& kind) { return kind.end_of_shaking(block); }, scene.excitation);
  const double periods = std::ceil((shaking + coming_to_rest) * frequency_ratio_for(scene, block) / two_pi);
  return std::isfinite(periods) ? static_cast<std::int64_t>(periods) : 1;  // not finite: the block is refused anyway
}

}  // namespace rocking
