#pragma once

#include <string>
#include <vector>

#include "analysis/page/figure_section.hpp"
#include "analysis/run_report.hpp"

namespace rocking::analysis {

/// A report as one HTML page without external resources. Its content-security policy allows only its own script and
/// style, given by their hashes, and embedded pictures. Equal reports and pictures give equal bytes.
///
/// The page says what it omits: rows of tables beyond `most_rows`, charts beyond `most_charts`.
[[nodiscard]] std::string page_text(const RunReport& report, const std::vector<DrawnFigure>& figures);

}  // namespace rocking::analysis
