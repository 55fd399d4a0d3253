#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "rocking/fields/converted_type.hpp"
#include "rocking/look/table.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/output/response_event_text.hpp"
#include "rocking/studies/curves/annual_rate.hpp"
#include "rocking/studies/curves/fragility_curve.hpp"
#include "rocking/studies/curves/stripes.hpp"

/// How curves and rates stand in documents, and what is said of them.
namespace rocking {

/// Of the key `unresolved` of a level.
inline constexpr std::string_view unresolved_sentence =
    "those without an answer, which ended before their horizon by a budget or by Painleve's paradox; the intervals "
    "cover that all of them have the event; absent: none";

/// `[low, high]`; an infinite upper end is null.
[[nodiscard]] const ValueType& open_interval_type();
/// Of an optional one.
[[nodiscard]] const ValueType& optional_open_interval_type();

[[nodiscard]] const StructType& fields_of(const CurveRun*);
[[nodiscard]] const StructType& fields_of(const CurveSubject*);
/// Of a curve without its subject, as each record of a suite has one.
[[nodiscard]] const StructType& fields_of(const FragilityCurve*);
[[nodiscard]] const StructType& fields_of(const RareLevel*);
[[nodiscard]] const StructType& fields_of(const SuiteCurve*);
[[nodiscard]] const StructType& fields_of(const AnnualRate*);
[[nodiscard]] const StructType& fields_of(const SuiteRate*);
[[nodiscard]] const StructType& fields_of(const RateComparison*);

template <>
struct TypeOf<RateSource> : OnlyType<NamedType<RateSource, rate_source_names>> {};

template <>
struct TypeOf<ResponseEvent> {
  static const ValueType& get();
};

template <>
struct TypeOf<stats::FragilityOutcome> : OnlyType<NamedType<stats::FragilityOutcome, stats::fragility_outcome_names>> {
};

template <>
struct TypeOf<stats::LackOfFit> {
  static const ValueType& get();
};

/// `2.31 [2.20, 2.43]`.
[[nodiscard]] look::Cell estimate_cell(double value, const std::optional<stats::Interval>& interval);
[[nodiscard]] std::string bounded_in_words(const stats::Bounded& bounded);

/// A return period in two digits, as a rate, and without a power of ten: `1900`, `0.25`.
[[nodiscard]] std::string years_in_words(double years);

/// Adds the column `unresolved` to the table of every `step`-th level if a level has realisations without an answer.
template <class Levels>
void add_unresolved(const Levels& levels, std::size_t step, look::Table& table) {
  if (std::ranges::none_of(levels, [](const auto& level) { return level.unresolved > 0; })) return;
  add_columns(table, {"unresolved"});
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    table.rows[row].push_back(look::whole(levels[row * step].unresolved));
  }
}

/// `lack of fit: deviance 3.2, p = 0.4 (499 bootstrap samples)`, as a line.
[[nodiscard]] std::string test_in_words(const stats::LackOfFit& test);

/// The rare estimates of a curve over the swept intensity `parameter`, as a table; empty if there are none.
[[nodiscard]] std::string rare_table(const std::vector<RareLevel>& levels, const std::string& parameter);

/// The title of the run and the values of the other entries of its sweep, as a line; empty if there are none.
[[nodiscard]] std::string heading_of_curve(const std::string& title, const std::vector<Parameter>& others);

/// A rate with its interval, `5.0e-4 [1.9e-4, 1.1e-3]`, or a quotient of two rates.
[[nodiscard]] std::string rate_in_words(double rate, const std::optional<stats::Interval>& interval);

/// A probability within some years, in per cent, in as many digits as the rate from which it follows.
[[nodiscard]] std::string in_years_text(double probability);

/// `PGA = 0.36 g`: a value of the swept intensity.
[[nodiscard]] std::string at_intensity(const CurveSubject& subject, const std::string& value);

/// `from PGA = 0.219 g on`: which intensities a rate counts; and why, `, the least that lifts the block`.
[[nodiscard]] std::string counted_from_in_words(const CurveSubject& subject);
[[nodiscard]] std::string why_counted_in_words(const CurveSubject& subject);

/// Whether an option has a name in place of its values.
[[nodiscard]] bool are_named(const std::vector<Parameter>& option);
/// `The block`, or of an option `With width 0.42 m the block`, `on a plinth: the block`.
[[nodiscard]] std::string block_of(const CurveSubject& subject);
/// `, tilt > 0.5 psi (6.2 degrees)`; empty of another event.
[[nodiscard]] std::string tilt_note(const CurveSubject& subject);
/// `mean annual rate 5.0e-4 [1.9e-4, 1.1e-3] (95 %)`.
[[nodiscard]] std::string rate_with_level(const AnnualRate& rate, double confidence);

/// `With width 0.35 m the block overturns about once in 2000 years: mean annual rate 5.0e-4 [1.9e-4, 1.1e-3] (95 %)`.
[[nodiscard]] std::string rate_sentence(const CurveSubject& subject, const AnnualRate& rate);
/// Of a suite with what its levels leave open, `; what the levels leave open, 12.3 % of the rate, raises it to at most
/// 9.0e-4: add 0.21,0.34`.
[[nodiscard]] std::string rate_sentence(const CurveSubject& subject, const SuiteRate& rate);

/// The probabilities within some years, and where the rate comes from, in lines.
[[nodiscard]] std::string rate_sources_in_words(const AnnualRate& rate, const CurveSubject& subject);

/// What the rate consists of; on one screen without its parts by range of intensity.
[[nodiscard]] std::string annual_rate_table(const AnnualRate& rate, const CurveSubject& subject, Extent extent);
[[nodiscard]] std::string annual_rate_table(const SuiteRate& rate, const CurveSubject& subject, Extent extent);

/// Lines that tell what the rate lacks: hazard at either end, and levels; empty if nothing.
[[nodiscard]] std::string annual_rate_warnings(const AnnualRate& rate);
[[nodiscard]] std::string annual_rate_warnings(const SuiteRate& rate);

/// What needs a look, a sentence each: a hazard curve that begins too late, and one, or an event, that is too frequent to be
/// believed.
[[nodiscard]] std::vector<std::string> hazard_doubts(const AnnualRate& rate);
/// The same, and a hazard curve that ends too early.
[[nodiscard]] std::vector<std::string> hazard_warnings(const AnnualRate& rate);

/// `1.2 % of the rate comes from beyond the last point of the hazard curve; without it: 4.9e-4 per year`.
[[nodiscard]] std::string extrapolated_hazard_in_words(const AnnualRate& rate);

/// How a hazard curve was read: `annual rates of pga_g at 10 points from 0.05 to 2`.
[[nodiscard]] std::string hazard_in_words(const HazardCurve& hazard);

/// What gives the probabilities of a rate: `law`, `isotonic shares`.
[[nodiscard]] std::string source_in_words(RateSource source);

/// The same of an estimate: `rejected law` where the rate is not by the law.
[[nodiscard]] std::string source_in_words(RateSource source, const SuiteRate& rate);

/// By how much the rates of a suite differ: `the larger is 22.0 % above the smaller`, `the larger is 4.2 times ..`.
[[nodiscard]] std::string disagreement_in_words(const SuiteRate& rate);
/// `12.3 % of the rate`, or `more than the whole rate`: what its levels leave undecided.
[[nodiscard]] std::string undecided_in_words(const SuiteRate& rate);

/// `0.21,0.34`: the levels to add, as `rocking resume --levels` takes them.
[[nodiscard]] std::string levels_in_words(const std::vector<double>& levels);
/// Those that a rate lacks, and which of them are for `rocking rare`.
[[nodiscard]] std::string added_levels_in_words(const SuiteRate& rate);

/// Whether a table lists each record.
enum class RecordTable : std::uint8_t { omitted, shown };

/// The words that replace a fit of one motion.
[[nodiscard]] std::string why_without_law(stats::FragilityOutcome outcome, const ResponseEvent& event);
/// `2.31 [2.20, 2.43]`; outside the levels `> 1.2 (extrapolated: 1.31 [1.24, 1.42])`.
[[nodiscard]] std::string median_in_words(const FragilityCurve& curve);
/// The curve of one motion as text.
[[nodiscard]] std::string curve_table(const FragilityCurve& curve, Extent extent);

/// The curve of a suite as text; on one screen of the measures of intensity only the most efficient.
[[nodiscard]] std::string suite_table(const SuiteCurve& curve, RecordTable records, Extent extent);

}  // namespace rocking
