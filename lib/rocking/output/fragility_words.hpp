#pragma once

#include <string>
#include <string_view>

#include "rocking/scene/experiment.hpp"
#include "rocking/stats/fragility.hpp"
#include "rocking/studies/suite/stripes.hpp"
#include "rocking/text/json.hpp"

/// Words and JSON that the curves of one motion and of a suite share.
namespace rocking {

/// The word for an outcome in files.
[[nodiscard]] std::string_view word_of(stats::FragilityOutcome outcome);

/// `overturning`, or `a peak tilt above 0.5`.
[[nodiscard]] std::string words_of(const FragilityEvent& event);
/// Heading of the column of shares: `overturned`, or `tilt > 0.5`.
[[nodiscard]] std::string column_of(const FragilityEvent& event);
/// `"overturned"`, or `{"peak_tilt": 0.5}`.
[[nodiscard]] Json event_json(const FragilityEvent& event);

/// `[low, high]`; an infinite upper end is `null`.
[[nodiscard]] Json open_interval_json(const stats::Interval& interval);

/// `2.31 [2.20, 2.43]`; an infinite upper end is `unbounded`.
[[nodiscard]] std::string interval_in_words(const stats::Interval& interval);
[[nodiscard]] std::string bounded_in_words(const stats::Bounded& bounded);

/// The title of the run and the values of the other entries of its sweep, as a line; empty if there are none.
[[nodiscard]] std::string heading_of_curve(const Experiment& experiment, const std::vector<Parameter>& others);

}  // namespace rocking
