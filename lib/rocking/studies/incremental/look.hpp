#pragma once

#include "rocking/fields/struct_type.hpp"
#include "rocking/figures/figure.hpp"
#include "rocking/studies/incremental/incremental.hpp"

/// How an incremental dynamic analysis looks.
namespace rocking {

[[nodiscard]] const StructType& fields_of(const ReportedAnalysis*);

/// `3 of 20 realisations that overturned at some level stood again at a stronger one`.
[[nodiscard]] std::string resurrections_in_words(const Resurrections& found);

/// As text.
[[nodiscard]] std::string incremental_table(const IncrementalAnalysis& analysis);

}  // namespace rocking

namespace rocking::analysis {

/// The figure `incremental`: for each incremental dynamic analysis a panel with the peak tilt against the intensity. Thin
/// lines are the medians of the records, thick ones the 16, 50 and 84 % quantiles of all; an overturned block is drawn at
/// a flat line above all tilts. Absent without one.
[[nodiscard]] std::optional<Figure> incremental_figure(const std::vector<ReportedAnalysis>& analyses);

}  // namespace rocking::analysis
