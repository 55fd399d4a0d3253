#pragma once

#include "rocking/fields/value_type.hpp"
#include "rocking/studies/orbits/result.hpp"

namespace rocking {

/// Reports what contradicts itself: a place that leads to nothing, an orbit whose points are not as many as its period,
/// branches over a number that the conditions do not have.
void check_orbits_report(const OrbitsReport& report, const ReadingPlace& place);

}  // namespace rocking
