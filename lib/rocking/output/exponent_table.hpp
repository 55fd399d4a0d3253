#pragma once

#include <string>

#include "rocking/output/report.hpp"

namespace rocking {

/// The largest Lyapunov exponents of the conditions whose classification needed some, as a table with a legend; empty
/// without any.
[[nodiscard]] std::string exponent_table(const Report& report);

}  // namespace rocking
