#pragma once

#include <string>

#include "rocking/studies/run_fragility.hpp"

namespace rocking {

/// The rate and its disaggregation as lines.
[[nodiscard]] std::string annual_rate_table(const AnnualRate& rate, const CurveSubject& subject);

}  // namespace rocking
