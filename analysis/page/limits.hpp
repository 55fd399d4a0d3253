#pragma once

#include <string>

namespace rocking::analysis {

/// HTML: what the model leaves out, and what this means for the results, with literature. Independent of a report.
[[nodiscard]] std::string limits_html();

}  // namespace rocking::analysis
