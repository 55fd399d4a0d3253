#pragma once

#include "rocking/scene/experiment.hpp"

namespace rocking {

/// Throws base::InputError with everything that is wrong with a condition: each number that its rule does not allow
/// (scene/rules.hpp), and each relation between values that does not hold (scene/relations.hpp). Places are JSON
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

}  // namespace rocking
