#pragma once

#include <string>
#include <vector>

#include "rocking/output/write_facts.hpp"
#include "rocking/plan/plan.hpp"

namespace rocking {

/// The plan of a run in words: sizes, disk space and memory, time, what impacts leave of the tilt rate,
/// and what is on beside rocking.
[[nodiscard]] std::string plan_text(const Plan& plan);

/// What is checked of a block first, as a table with a row for each edge, or one where both are alike: its distance from the
/// centre of mass, R, psi and p about it, the base acceleration of uplift, Housner's rate ratio, and whether the block slides
/// before it rocks. Of the mean blocks of all conditions.
[[nodiscard]] std::string block_text(const Experiment& experiment);

/// The plan as facts, for JSON.
[[nodiscard]] std::vector<Fact> plan_facts(const Plan& plan);

}  // namespace rocking
