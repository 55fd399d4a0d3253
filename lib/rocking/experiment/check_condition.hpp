#pragma once

#include "rocking/experiment/experiment.hpp"

namespace rocking::experiment {

/// Throws base::InputError with the place of every number that no motion can be computed with: one that is not finite, a
/// length, a frequency or a tolerance that is not positive, or so near to 0 that what follows from it is no normal double.
/// The reader of experiment files is stricter; this is for conditions that were filled in by hand.
void check_condition(const Condition& condition);

}  // namespace rocking::experiment
