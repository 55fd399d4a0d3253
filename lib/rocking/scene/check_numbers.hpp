#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>

#include "rocking/scene/experiment.hpp"
#include "rocking/scene/number_rule.hpp"
#include "rocking/scene/refusal.hpp"

namespace rocking {

/// Ground motions that were found to be sound, with the gravity that they are over.
using SoundGroundMotions = std::set<std::pair<const GroundMotion*, double>>;

/// Adds a problem for each number of a condition that its rule (scene/rules.hpp) does not allow, in the order of the
/// keys of an experiment file. What numbers demand of each other: check_relations. Looks through a ground motion only
/// where `sound` does not hold it.
void check_numbers(const Condition& condition, SoundGroundMotions& sound, Problems& problems);

/// A quantity in a message.
[[nodiscard]] std::string text_of(const Quantity& quantity);

}  // namespace rocking
