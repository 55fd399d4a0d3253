#pragma once

#include <string>

#include "rocking/look/text_table.hpp"
#include "rocking/studies/orbits/question.hpp"

namespace rocking {

/// Periodic orbits as text: how many stable ones coexist, and which response modes of runs are backed by an orbit; a row for
/// each orbit; the branches and their bifurcations. On one screen the stable orbits of each range of conditions, and of the
/// branches and bifurcations what fits there.
[[nodiscard]] std::string table_of(const OrbitStudy& study, Extent extent = Extent::all);

}  // namespace rocking
