#pragma once

#include <string>

#include "rocking/section/response_mode.hpp"

namespace rocking::analysis {

/// Inline SVG: a schematic time history of a response mode, tilt above base acceleration. For (m,n): m rocks in n
/// periods, repeated. Empty for `unresolved`, which has no typical form.
[[nodiscard]] std::string mode_drawing(const section::ResponseMode& mode);

}  // namespace rocking::analysis
