#pragma once

#include <vector>

#include "rocking/figures/figure.hpp"
#include "rocking/output/report.hpp"

namespace rocking::analysis {

/// `mode_bands`: the probabilities of the response modes, stacked to 1, against the swept parameter; a panel for each
/// combination of the other parameters, or, of more than six combinations, a strip of one panel. Modes beyond the ten most frequent are joined.
[[nodiscard]] Figure mode_bands(const Report& report);

/// `mode_probabilities`: the same probabilities as separate curves, each with its simultaneous interval as a ribbon.
/// Bars with intervals if nothing, or no number, is swept.
[[nodiscard]] Figure mode_probabilities(const Report& report);

/// Modes with their own colour, in the order of tables: the ten most frequent of those that occur, and
/// overturning if it occurs.
[[nodiscard]] std::vector<section::ResponseMode> shown_modes(const Report& report);

/// `200 realisations each` or `20 to 400 realisations each`.
[[nodiscard]] std::string realisations_in_words(const Report& report);

}  // namespace rocking::analysis
