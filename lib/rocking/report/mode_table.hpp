#pragma once

#include <string>

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/result.hpp"

namespace rocking::report {

/// The response modes of every condition as text for a terminal, at most 120 columns wide: a row a condition, a column for
/// each swept parameter and each mode that occurs, with the estimate and its simultaneous interval, all in per cent.
/// Modes that do not fit are added up in a last column, so that each row still accounts for every realisation.
[[nodiscard]] std::string mode_table(const experiment::Experiment& experiment,
                                     const experiment::ExperimentResult& result);

/// What a condition is called in a table: `0.35/0.3` for friction, the value for anything else.
[[nodiscard]] std::string short_value(const experiment::Parameter& parameter);

}  // namespace rocking::report
