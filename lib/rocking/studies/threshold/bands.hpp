#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "rocking/ensemble/run.hpp"
#include "rocking/studies/threshold/question.hpp"

namespace rocking {

/// How the motion of a case ends at a value; called by several threads.
using PointAt = std::function<ThresholdPoint(std::size_t place, double value)>;

/// The bands of `count` cases in the range of the question, the same for every number of threads. Uses `threads`,
/// `on_progress` and `stop_requested` of the options.
[[nodiscard]] std::vector<ThresholdBands> bands_of(std::size_t count, const ThresholdQuestion& question,
                                                   const PointAt& point_at, const RunOptions& options);

/// The values at which a range is scanned.
[[nodiscard]] std::vector<double> scanned_values(const ThresholdQuestion& question);

}  // namespace rocking
