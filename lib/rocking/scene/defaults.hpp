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

/// Whether an impact of any edge takes energy from a block that does not slide: at a rate ratio of 1 none does.
[[nodiscard]] bool impacts_take_energy(const Scene& scene);

/// Default number of strobe periods of a run under a base motion that ends: until it ends and the block has come to
/// rest.
///
/// A slender block whose energy is u^2 of that at its balance takes the time 2 artanh(u), in units of 1/p, from one
/// impact to the next; each impact changes u to delta u. From just below balance, u = 0.999, the first hop takes 7.6.
/// All others together take at most (pi^2/4)/(1 - delta), its limit for delta to 1. The function uses
/// 8 + 4/(1 - abs(delta)) with delta = 1 - (3/2)(1 + e) sin^2(psi) and the mean of e, of
/// unlike edges the larger abs(delta). The 4 in place of 2.47 leaves room
/// for impacts that lose less than the mean, down to 0.62 of the loss. A loss below 1e-3 counts as 1e-3, at most 4008 in
/// all: with e = 0 that of a block more slender than 39 to 1. Source: Housner (1963), BSSA 53(2) 403-417, Eqs. 5 and 10
/// (half period and decay), summed.
[[nodiscard]] std::int64_t periods_until_rest(const Scene& scene);

}  // namespace rocking
