#pragma once

#include <vector>

#include "rocking/input/sweep.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/text/json.hpp"

namespace rocking {

/// Replaces values of an experiment file by those of the command line.
void apply(const Overrides& overrides, Json& document);

/// Adds the levels of the command line to the swept intensity, each before the first larger value, so that a rising list
/// remains one. A flag of what the sweep sets is a problem.
void apply(const Overrides& overrides, std::vector<SweepAxis>& axes, Problems& problems);

/// Tells a user of the flag that is wrong, not of the key that it replaced.
void name_flags(const Overrides& overrides, Problems& problems);

}  // namespace rocking
