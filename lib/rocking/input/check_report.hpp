#pragma once

#include <vector>

#include "rocking/input/object_reader.hpp"

namespace rocking {

/// Checks a report that was read from a file before anything of it is used: against its schema, the experiment in it
/// against that of experiments, and what the parts of a report demand of each other. These demands are: the digest of
/// the experiment; one condition for each point of the sweep, with the parameters of that point; counts that add up to
/// the number of realisations; intervals whose ends are in order; and no case that counts more realisations than there
/// are.
[[nodiscard]] Problems problems_of_report(const Json& report);

}  // namespace rocking
