#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// Throws base::InputError with everything that is wrong with a condition: each number that its rule does not allow
/// (scene/rules.hpp), and each relation between values that does not hold (check_relations). Places are JSON
/// pointers into an experiment file; reasons and remedies are those that a file gets. A fluctuation of friction is
/// reported at `/fluctuation/static_friction` or `/fluctuation/kinetic_friction`.
///
/// Everything that runs a condition makes this check once for a condition or for an experiment. The check reads all
/// samples of a ground motion.
void check_condition(const Condition& condition);

/// Throws base::InputError if an experiment, which can only be one made in C++, has no conditions.
void check_has_conditions(const Experiment& experiment);

/// check_has_conditions, then check_condition of every condition. Reasons end with the number of the condition where
/// there are several, at most twenty problems are told, and a ground motion that conditions share is looked through once.
void check_experiment(const Experiment& experiment);

/// Throws base::InputError unless strobe points can tell the response of each condition: a base motion with a period must
/// repeat after a number of them. Demanded where responses are classified, and not of a trajectory.
void check_strobe(const Experiment& experiment);

/// Ground motions that were found to be sound, with the gravity that they are over.
using SoundGroundMotions = std::set<std::pair<const GroundMotion*, double>>;

/// Adds a problem for each number of a condition that its rule (scene/rules.hpp) does not allow, in the order of the
/// keys of an experiment file. What numbers demand of each other: check_relations. Looks through a ground motion only
/// where `sound` does not hold it.
void check_numbers(const Condition& condition, SoundGroundMotions& sound, Problems& problems);

/// Why no rigid body is like this: its centre of mass is not above its base, or its mass would have to lie beyond its
/// outline. Looks at the corners of the drawn numbers.
[[nodiscard]] std::optional<Refusal> refusal_of(const SceneBlock& block);

/// A quantity in a message.
[[nodiscard]] std::string text_of(const Quantity& quantity);

/// Adds a problem for each demand that values of a condition do not meet of each other: static friction not below
/// kinetic, no Painleve paradox at the means, a tilt short of overturned, a slip rate and fluctuating friction only
/// where sliding is possible, a fluctuating amplitude only where the excitation has periods, one half-width to sample
/// until, a relative one only of one mode, a run until the response is classified only where the excitation has periods and for
/// no less than the horizon; a physical amplitude or frequency only within the bounds of A_h and Omega_h for every
/// block that can be drawn, and a rate ratio within those of e.
///
/// A demand is left out where `problems` already tells of one of its values. Values are shown as JSON text.
void check_relations(const Condition& condition, Problems& problems);

/// Demands that a reader of files tells at the key where it meets them.
namespace relations {
[[nodiscard]] Refusal no_friction_to_fluctuate();
[[nodiscard]] Refusal no_period_to_fluctuate();
/// Of a vertical frequency, where strobe points are to tell the response.
[[nodiscard]] std::optional<Refusal> vertical_without_strobe(const Condition& condition);
[[nodiscard]] std::optional<Refusal> one_half_width(const Condition& condition);
[[nodiscard]] std::optional<Refusal> relative_half_width_of_every_mode(const Condition& condition);
}  // namespace relations

}  // namespace rocking
