#pragma once

#include <memory>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/scene/number_rule.hpp"

namespace rocking {

/// Samples of a ground motion are those of another one if they differ by at most this share of its peak: above what is
/// lost by rounding, or by another value of g, and far below any two records of an earthquake.
inline constexpr double same_series_tolerance = 2e-3;

/// Reports the records of a suite that are vertical components (record_component.hpp), and those that are a former one
/// once more: in another format, under another name, in other units. A factor between two series is that of two units,
/// and counts only where one of the two units was assumed. `motions`: of the records, without null.
void check_suite(const std::vector<std::shared_ptr<const GroundMotion>>& motions, Problems& problems);

}  // namespace rocking
