#pragma once

#include <string>

#include "rocking/output/mode_table.hpp"
#include "rocking/output/report.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// A run as text for a terminal: its title, the table of response modes with its legend, and a line each on
/// overturning, settling, precision that was not reached, sensitivity to the tolerance, and warnings.
[[nodiscard]] std::string run_table(const Experiment& experiment, const Report& report, const TableLook& look = {});

/// The largest Lyapunov exponents of the conditions whose classification needed some, as a table with a legend; empty
/// without any.
[[nodiscard]] std::string exponent_table(const Report& report);

}  // namespace rocking
