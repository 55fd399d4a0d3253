#pragma once

#include <string>
#include <vector>

#include "rocking/output/write_facts.hpp"
#include "rocking/plan/plan.hpp"

namespace rocking {

/// The plan of a run in words: sizes, disk space and memory, time, what impacts leave of the tilt rate,
/// and what is on beside rocking.
[[nodiscard]] std::string plan_text(const Plan& plan);

/// The same as facts, for JSON.
[[nodiscard]] std::vector<Fact> plan_facts(const Plan& plan);

}  // namespace rocking
