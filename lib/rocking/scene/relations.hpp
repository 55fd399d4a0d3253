#pragma once

#include <optional>

#include "rocking/scene/experiment.hpp"
#include "rocking/scene/number_rule.hpp"

namespace rocking {

/// Adds a problem for each demand that values of a condition do not meet of each other: static friction not below
/// kinetic, no Painleve paradox at the means, a tilt short of overturned, a slip rate and fluctuating friction only
/// where sliding is possible, a fluctuating amplitude only where the excitation has periods, a label check only of a
/// fixed number of realisations and of no more periods than a realisation may have, one half-width to sample until, a
/// relative one only of one mode, a run until the response is classified only where the excitation has periods and for
/// no less than the horizon; a physical amplitude or frequency only within the bounds of A_h and Omega_h for every
/// block that can be drawn, and a rate ratio within those of e.
///
/// A demand is left out where `problems` already tells of one of its values. Values are shown as JSON text.
void check_relations(const Condition& condition, Problems& problems);

/// Demands that a reader of files tells at the key where it meets them.
namespace relations {
[[nodiscard]] Refusal no_friction_to_fluctuate();
[[nodiscard]] Refusal no_period_to_fluctuate();
[[nodiscard]] std::optional<Refusal> one_half_width(const Condition& condition);
[[nodiscard]] std::optional<Refusal> relative_half_width_of_every_mode(const Condition& condition);
}  // namespace relations

}  // namespace rocking
