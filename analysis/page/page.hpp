#pragma once

#include <string>
#include <vector>

#include "analysis/page/figure_section.hpp"
#include "analysis/run_report.hpp"

namespace rocking::analysis {

/// A report as one HTML page that needs nothing beside it and lets nothing in: its policy allows its own script and style,
/// known by their hashes, and pictures that it holds. The same report and pictures give the same bytes.
///
/// What a page leaves out it says: rows of tables beyond `most_rows`, charts beyond `most_charts`.
[[nodiscard]] std::string page_text(const RunReport& report, const std::vector<DrawnFigure>& figures);

}  // namespace rocking::analysis
