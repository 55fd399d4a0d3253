#pragma once

#include <string>
#include <vector>

#include "analysis/page/animation.hpp"
#include "analysis/page/figure_section.hpp"
#include "rocking/output/report.hpp"

namespace rocking::analysis {

/// Realisations that a page animates.
struct ShownAnimations {
  std::string explanation;  ///< which ones they are, as plain text
  std::vector<Animation> motions;
};

/// A report as one HTML page without external resources. Its content-security policy allows only its own script and
/// style, given by their hashes, and embedded pictures. Equal reports and pictures give equal bytes.
///
/// The page says what it omits: rows of tables beyond `most_rows`, charts beyond `most_charts`.
[[nodiscard]] std::string page_text(const Report& report, const std::vector<DrawnFigure>& figures,
                                    const ShownAnimations& motions = {});

}  // namespace rocking::analysis
