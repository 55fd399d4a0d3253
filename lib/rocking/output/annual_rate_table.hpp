#pragma once

#include <string>
#include <vector>

#include "rocking/studies/run_fragility.hpp"

namespace rocking {

/// The rate and its disaggregation as lines.
[[nodiscard]] std::string annual_rate_table(const AnnualRate& rate, const CurveSubject& subject);
[[nodiscard]] std::string annual_rate_table(const SuiteRate& rate, const CurveSubject& subject);

/// What gives the probabilities of a rate: `law`, `isotonic shares`.
[[nodiscard]] std::string source_in_words(RateSource source);

/// `0.21,0.34`: the levels to add, as `rocking resume --levels` takes them.
[[nodiscard]] std::string levels_in_words(const std::vector<double>& levels);

}  // namespace rocking
