#pragma once

#include "analysis/figure.hpp"
#include "rocking/report/json.hpp"

namespace rocking::analysis {

/// `normal_histogram`: what `rocking check-normal --json` printed, as counts and the curve of the law, as in Fig. 2 of Jeong
/// and Yang (2012). Throws base::InputError where it is no such file.
[[nodiscard]] Figure normal_histogram(const report::Json& output);

}  // namespace rocking::analysis
