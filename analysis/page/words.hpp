#pragma once

#include <cstdint>
#include <string>

#include "analysis/run_report.hpp"

/// Numbers and names as a page says them. None of the texts needs escaping, but for names of conditions.
namespace rocking::analysis {

/// `98.5`: in per cent, to a tenth.
[[nodiscard]] std::string per_cent(double probability);

/// `98.5 % [94.4, 99.8]`.
[[nodiscard]] std::string per_cent(double probability, const stats::Interval& interval);

/// `1 condition`, `38 conditions`.
[[nodiscard]] std::string counted(std::uint64_t number, const std::string& noun);

/// What a response mode is, for who meets it for the first time: `rocks once in three periods`.
[[nodiscard]] std::string meaning_of(const section::ResponseMode& mode);

/// Of all conditions together.
[[nodiscard]] std::uint64_t realisations_of(const RunReport& report);

/// `friction 0.35/0.3, base amplitude 4.5`, or `the only condition`.
[[nodiscard]] std::string condition_name(const RunReport& report, std::size_t condition);

}  // namespace rocking::analysis
