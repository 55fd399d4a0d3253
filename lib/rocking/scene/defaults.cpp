#include "rocking/scene/defaults.hpp"

#include <algorithm>

#include "rocking/scene/periods_until_rest.hpp"
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

}  // namespace rocking
