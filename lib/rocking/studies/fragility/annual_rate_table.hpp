#pragma once

#include <string>
#include <vector>

#include "rocking/look/text_table.hpp"
#include "rocking/studies/fragility/run_fragility.hpp"

namespace rocking {

/// The rate in a line, `mean annual rate of overturning: 5.0e-4 [..], once in 2000 years`, and where it comes from.
[[nodiscard]] std::string annual_rate_in_words(const AnnualRate& rate, const FragilityEvent& event);

/// How far the rare estimates give its probabilities, as a line; empty without any.
[[nodiscard]] std::string rare_use_in_words(const AnnualRate& rate);

/// What the rate consists of; on one screen without its parts by range of intensity.
[[nodiscard]] std::string annual_rate_table(const AnnualRate& rate, const CurveSubject& subject, Extent extent);
[[nodiscard]] std::string annual_rate_table(const SuiteRate& rate, const CurveSubject& subject, Extent extent);

/// Lines that tell what the rate lacks: hazard at either end, and levels; empty if nothing.
[[nodiscard]] std::string annual_rate_warnings(const AnnualRate& rate);
[[nodiscard]] std::string annual_rate_warnings(const SuiteRate& rate);

/// `1.2 % of the rate comes from beyond the last point of the hazard curve; without it: 4.9e-4 per year`.
[[nodiscard]] std::string extrapolated_hazard_in_words(const AnnualRate& rate);

/// How a hazard curve was read: `annual rates of pga_g at 10 points from 0.05 to 2`.
[[nodiscard]] std::string hazard_in_words(const HazardCurve& hazard);

/// What gives the probabilities of a rate: `law`, `isotonic shares`.
[[nodiscard]] std::string source_in_words(RateSource source);
/// The same of an estimate: `rejected law` where the rate is not by the law.
[[nodiscard]] std::string source_in_words(RateSource source, const SuiteRate& rate);

/// By how much the rates of a suite differ: `the largest is 22.0 % above the smallest`, `the largest is 4.2 times ..`.
[[nodiscard]] std::string disagreement_in_words(const SuiteRate& rate);
/// `12.3 % of the rate`, or `more than the whole rate`: what its levels leave undecided.
[[nodiscard]] std::string undecided_in_words(const SuiteRate& rate);

/// `0.21,0.34`: the levels to add, as `rocking resume --levels` takes them.
[[nodiscard]] std::string levels_in_words(const std::vector<double>& levels);
/// Those that a rate lacks, and which of them are for `rocking rare`.
[[nodiscard]] std::string added_levels_in_words(const SuiteRate& rate);

}  // namespace rocking
