#pragma once

#include <string>
#include <vector>

#include "analysis/page/figure_section.hpp"
#include "analysis/page/motion.hpp"
#include "analysis/run_report.hpp"

namespace rocking::analysis {

/// Realisations that a page animates.
struct ShownMotions {
  std::string explanation;  ///< which ones they are, as plain text
  std::vector<AnimatedMotion> motions;
};

/// A report as one HTML page without external resources. Its content-security policy allows only its own script and
/// style, given by their hashes, and embedded pictures. Equal reports and pictures give equal bytes.
///
/// The page says what it omits: rows of tables beyond `most_rows`, charts beyond `most_charts`.
[[nodiscard]] std::string page_text(const RunReport& report, const std::vector<DrawnFigure>& figures,
                                    const ShownMotions& motions = {});

}  // namespace rocking::analysis
