#pragma once

#include <optional>

#include "rocking/figures/figure.hpp"
#include "rocking/output/report.hpp"

namespace rocking::analysis {

/// Largest number of conditions that the figure shows: those in which most responses are unresolved at the fixed
/// horizon. The tables of `rocking report --format csv` have all of them.
inline constexpr std::size_t most_incidence_panels = 6;

/// Which response, and by when: the cumulative incidence of the most frequent response modes against time, with
/// pointwise and simultaneous bands, a panel for each condition. Absent unless the run has `until_classified`.
[[nodiscard]] std::optional<Figure> incidence_figure(const Report& report);

}  // namespace rocking::analysis
