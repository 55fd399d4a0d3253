#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rocking/scene/experiment.hpp"

namespace rocking {

/// The only entry of a sweep, where its values are numbers.
struct SweptNumber {
  std::string pointer;         ///< JSON pointer
  std::vector<double> values;  ///< by condition
};

/// Absent if an experiment sweeps nothing, more than one entry, or one with other values.
[[nodiscard]] std::optional<SweptNumber> only_swept_number(const Experiment& experiment);

/// The experiment's condition at any value of its only swept number; absent where the value is not allowed.
[[nodiscard]] std::function<std::optional<Condition>(double value)> condition_family(const Experiment& experiment,
                                                                                     const std::string& pointer);

}  // namespace rocking
