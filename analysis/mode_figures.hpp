#pragma once

#include <vector>

#include "analysis/figure.hpp"
#include "analysis/run_report.hpp"

namespace rocking::analysis {

/// `mode_bands`: the probabilities of the response modes stacked to 1, against the swept parameter; a panel for each set of
/// the other parameters' values. Modes beyond the ten most frequent are joined.
[[nodiscard]] Figure mode_bands(const RunReport& report);

/// `mode_probabilities`: the same probabilities side by side, each with its simultaneous interval as a ribbon; bars with
/// intervals where nothing, or no number, is swept.
[[nodiscard]] Figure mode_probabilities(const RunReport& report);

/// Modes worth a colour of their own, in the order of tables: those that occur, of many the ten most frequent.
[[nodiscard]] std::vector<section::ResponseMode> shown_modes(const RunReport& report);

/// `200 realisations each` or `20 to 400 realisations each`.
[[nodiscard]] std::string spoken_realisations(const RunReport& report);

}  // namespace rocking::analysis
