#pragma once

#include <cstdint>

#include "rocking/api/trajectory.hpp"

namespace rocking {

/// Throws base::InputError if the experiment has no such condition, or a number is out of range.
void check_request(const Experiment& experiment, const TrajectoryRequest& request);

/// Excitation periods of a checked request.
[[nodiscard]] std::int64_t periods_of(const Experiment& experiment, const TrajectoryRequest& request);

}  // namespace rocking
