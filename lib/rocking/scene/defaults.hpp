#pragma once

#include <cstdint>

#include "rocking/dynamics/contact.hpp"
#include "rocking/scene/experiment.hpp"

/// Defaults that follow from other values of a condition. The others are the member initialisers of
/// scene/experiment.hpp.
namespace rocking {

/// A reading of the paper's equations, in the order of their names in files: `consistent`, `as-printed`, `as-plotted`.
enum class Formulation : std::uint8_t { consistent, as_printed, as_plotted };

/// What is left open where a formulation is given alone.
struct FormulationOptions {
  dynamics::SlideInertia slide_inertia;
  bool is_jy25;  ///< the restitution is Housner's ratio of the rates, dynamics::inelastic_rate_ratio
  dynamics::ImpactSlipRule impact_slip_rule;
};

/// Source: Jeong & Yang (2012) Eqs. 7, 25 and 26; lib/docs/model.md, section 8.
[[nodiscard]] FormulationOptions options_of(Formulation formulation);

/// Omega at which a strobe period under a ground motion is one second, 2 pi/p, as far as the bounds of the ratio allow
/// [-].
[[nodiscard]] double strobe_once_a_second(const dynamics::Block& block);

/// May be longer than a condition allows.
struct DefaultHorizon {
  std::int64_t transient_periods;
  std::int64_t sampled_periods;
};

/// That of `Horizon` where the excitation is periodic; else no transient, and as many periods as it takes until the
/// block has come to rest (periods_until_rest).
[[nodiscard]] DefaultHorizon default_horizon(const Scene& scene);

}  // namespace rocking
