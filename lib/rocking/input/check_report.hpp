#pragma once

#include <vector>

#include "rocking/input/object_reader.hpp"

namespace rocking {

/// Checks the experiment in a report of the right form: against what an experiment file may hold and the digest that the
/// report states, and that the report has one condition for each point of the sweep, with the parameters of that point.
[[nodiscard]] Problems problems_of_report(const Json& report);

}  // namespace rocking
