#pragma once

#include <string>

#include "rocking/studies/orbits/orbit_study.hpp"

namespace rocking {

/// Periodic orbits as text: a row for each orbit; the branches and their bifurcations; which response modes of runs are
/// backed by an orbit.
[[nodiscard]] std::string table_of(const OrbitStudy& study);

}  // namespace rocking
