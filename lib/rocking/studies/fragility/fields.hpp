#pragma once

#include "rocking/studies/fragility/study.hpp"

/// How the parts of a fragility report stand in documents.
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
[[nodiscard]] const StructType& fields_of(const AnnualRate*);
[[nodiscard]] const StructType& fields_of(const SuiteRate*);
[[nodiscard]] const StructType& fields_of(const RateComparison*);
[[nodiscard]] const StructType& fields_of(const Survival*);
[[nodiscard]] const StructType& fields_of(const ReportedSuite*);
[[nodiscard]] const StructType& fields_of(const ReportedAnalysis*);
[[nodiscard]] const StructType& fields_of(const ReportedSurface*);

template <>
struct TypeOf<ResponseEvent> {
  static const ValueType& get();
};

template <>
struct TypeOf<stats::FragilityOutcome> {
  static const ValueType& get();
};

template <>
struct TypeOf<stats::LackOfFit> {
  static const ValueType& get();
};

}  // namespace rocking
