#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "rocking/ensemble/run.hpp"
#include "rocking/studies/threshold/question.hpp"

namespace rocking {

/// How the motion of a case ends at a value; called by several threads.
using PointAt = std::function<ThresholdPoint(std::size_t place, double value)>;

/// Whether the event happens in a realisation; called by several threads.
using Trials = std::function<bool(std::uint64_t realisation)>;
/// Those of a case at a value.
using TrialsAt = std::function<Trials(std::size_t place, double value)>;

/// The bands of `count` cases in the range of the question, the same for every number of threads. Uses `threads`,
/// `on_progress` and `stop_requested` of the options. The question has its range, steps and accuracy.
[[nodiscard]] std::vector<ThresholdBands> bands_of(std::size_t count, const ThresholdQuestion& question,
                                                   const PointAt& point_at, const RunOptions& options);

/// Those in which the event has more than the probability of the question. Uses the same options.
[[nodiscard]] std::vector<ThresholdBands> bands_by_probability(std::size_t count, const ThresholdQuestion& question,
                                                               const TrialsAt& trials_at, const RunOptions& options);

/// The bands between edges, and to the ends of a scan.
[[nodiscard]] ThresholdBands with_bands(const std::vector<ThresholdPoint>& scan, std::vector<ThresholdEdge> edges);

/// The values at which a range is scanned.
[[nodiscard]] std::vector<double> scanned_values(const ThresholdQuestion& question);

}  // namespace rocking
