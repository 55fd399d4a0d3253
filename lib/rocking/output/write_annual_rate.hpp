#pragma once

#include <optional>
#include <string>

#include "rocking/studies/annual_rate.hpp"
#include "rocking/text/json.hpp"

namespace rocking {

/// `annual_rate` of a curve; `null` where there is none.
[[nodiscard]] Json annual_rate_json(const std::optional<AnnualRate>& rate);

/// The rate and its disaggregation as lines. `parameter`: the pointer to the intensity; `least_uplift`: of the curve.
[[nodiscard]] std::string annual_rate_table(const AnnualRate& rate, const FragilityEvent& event,
                                            const std::string& parameter, std::optional<double> least_uplift);

}  // namespace rocking
