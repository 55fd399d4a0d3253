#pragma once

#include "analysis/figure.hpp"
#include "rocking/text/json.hpp"

namespace rocking::analysis {

/// The figure `normal_histogram` of the output of `rocking check-normal --json`: counts and the curve of the law, as in
/// Fig. 2 of Jeong and Yang (2012). Throws base::InputError if `output` is no such output.
[[nodiscard]] Figure normal_histogram(const Json& output);

}  // namespace rocking::analysis
