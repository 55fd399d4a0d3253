#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rocking/figures/figure.hpp"
#include "rocking/output/report.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/store/store.hpp"
#include "rocking/text/json.hpp"

namespace rocking::analysis {

/// All figures for which a report has the numbers, in reading order; divergence times only of a periodic excitation, whose
/// periods they count. With the store of its realisations, also those
/// that need more than the report. One condition has no figures that show numbers along a sweep.
[[nodiscard]] std::vector<Figure> run_figures(const Report& report, const Store* store = nullptr);

/// `divergence_times`: the share of pairs of runs that have diverged by each period, a curve for each condition with
/// pairs. Of more than seven conditions, the seven are shown in which two runs differ most often in response mode. It
/// needs the realisations, which a report does not contain. Absent if no pair has diverged.
[[nodiscard]] std::optional<Figure> divergence_times(const Report& report, const Store& store);

/// Largest number of conditions that the figure shows: those in which most responses are unresolved at the fixed
/// horizon. The tables of `rocking report --format csv` have all of them.
inline constexpr std::size_t most_incidence_panels = 6;

/// Which response, and by when: the cumulative incidence of the most frequent response modes against time, with
/// pointwise and simultaneous bands, a panel for each condition. Absent unless the run has `until_classified`.
[[nodiscard]] std::optional<Figure> incidence_figure(const Report& report);

// Figures of non-recurrence: different responses under equal conditions. Absent if no condition has two realisations.

/// `non_recurrence`: the probability that two runs differ in response mode, with its interval, against the swept
/// parameter; a curve for each combination of the other parameters.
[[nodiscard]] std::optional<Figure> non_recurrence(const Report& report);

/// `divergence_quartiles`: median and quartiles over pairs of the divergence time of two runs [periods]. A quartile
/// beyond the horizon is not drawn.
[[nodiscard]] std::optional<Figure> divergence_quartiles(const Report& report);

/// The figure `scene`: the mean block of the first condition to scale, tilted about its left edge, with weight, normal
/// force, friction force and base motion; half diagonal R, shape angle ψ and tilt θ. The tilt is exaggerated so that it
/// is visible.
[[nodiscard]] Figure scene_sketch(const Report& report);

/// The numbers of a condition in words: `B = 1 m, H = 4 m; ψ = 0.245 rad, R = 2.06 m, p = 1.89 rad/s; A_h
/// 4.2 = 1.03 g, Ω_h 10 = 3.01 Hz; ...`.
[[nodiscard]] std::string scene_in_words(const Report& report, const ReportedCondition& condition);

// How far the block tilts and slips, as quantiles over the realisations of each condition.

/// `peak_tilt` and, where the block can slide, `peak_slip` and `final_slip`: median with its interval, and the outer
/// quantiles, against the swept parameter. Empty for reports without them.
[[nodiscard]] std::vector<Figure> quantile_figures(const Report& report);

/// The same numbers of one condition, with a row for each quantity; of one realisation its values.
[[nodiscard]] Table quantiles_of_condition(const Report& report, const ReportedCondition& condition);

/// `mode_bands`: the probabilities of the response modes, stacked to 1, against the swept parameter; a panel for each
/// combination of the other parameters, or, of more than six combinations, a strip of one panel. Modes beyond the ten
/// most frequent are joined.
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
