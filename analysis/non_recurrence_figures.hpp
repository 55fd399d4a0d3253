#pragma once

#include <optional>

#include "rocking/figures/figure.hpp"
#include "rocking/output/report.hpp"

/// Figures of non-recurrence: different responses under equal conditions. Absent if no condition has two realisations.
namespace rocking::analysis {

/// `non_recurrence`: the probability that two runs differ in response mode, with its interval, against the swept
/// parameter; a curve for each combination of the other parameters.
[[nodiscard]] std::optional<Figure> non_recurrence(const Report& report);

/// `divergence_quartiles`: median and quartiles over pairs of the divergence time of two runs [periods]. A quartile
/// beyond the horizon is not drawn.
[[nodiscard]] std::optional<Figure> divergence_quartiles(const Report& report);

}  // namespace rocking::analysis
