#pragma once

#include <variant>

#include "rocking/base/digest.hpp"
#include "rocking/fields/document.hpp"
#include "rocking/fields/struct_type.hpp"
#include "rocking/studies/curves/look.hpp"
#include "rocking/studies/fragility/fragility.hpp"
#include "rocking/studies/incremental/look.hpp"
#include "rocking/study/study.hpp"

namespace rocking {

/// The curve of one motion.
struct ReportedCurve {
  CurveRun run;
  FragilityCurve curve;
  std::optional<AnnualRate> rate;  ///< absent without a hazard curve
};

/// The curve of a suite of ground motions.
struct ReportedSuite {
  CurveRun run;
  SuiteCurve curve;
  std::optional<SuiteRate> rate;  ///< absent without a hazard curve
};

/// The rate of a curve; null: there is none.
[[nodiscard]] inline const AnnualRate* rate_of(const ReportedCurve& curve) {
  return curve.rate ? &*curve.rate : nullptr;
}
[[nodiscard]] inline const AnnualRate* rate_of(const ReportedSuite& curve) {
  return curve.rate ? &curve.rate->chosen : nullptr;
}

/// A comparison of rates of a run.
struct ReportedComparison {
  CurveRun run;
  RateComparison comparison;
};

/// A surface of a run.
struct ReportedSurface {
  CurveRun run;
  FragilitySurface surface;
};

/// Probabilities of overturning against the intensity, of several runs.
struct FragilityReport {
  std::vector<std::variant<ReportedCurve, ReportedSuite>> curves;
  std::vector<ReportedAnalysis> incremental;
  std::vector<ReportedComparison> comparisons;
  std::vector<ReportedSurface> surfaces = {};
  std::optional<Survival> survival = std::nullopt;  ///< of the blocks of all runs
};

[[nodiscard]] FragilityReport fragility_report(const std::vector<RunFragility>& runs);

/// The name of a run and the separator, where the curves are those of runs with different titles.
[[nodiscard]] std::string name_before(std::string_view separator, const FragilityReport& report, const CurveRun& run);

/// The answer: of each run and event a line with rate and interval of the first option, and the rates of the others as
/// multiples of it. Without a hazard curve of a suite the shares at the ends of the sweep, of one motion the median. Terminal,
/// page and sheet tell it.
[[nodiscard]] std::string headline(const FragilityReport& report);

[[nodiscard]] const StructType& fields_of(const FragilityReport*);

/// `fragility.json`, and the output of `rocking fragility --json`.
[[nodiscard]] const DocumentOf<FragilityReport>& fragility_document();

/// The curves as text: of each the rate, the fitted function, and its tables. On one screen of many curves a row for each.
[[nodiscard]] std::string fragility_table(const FragilityReport& report, RecordTable records = RecordTable::omitted,
                                          Extent extent = Extent::all);

/// The levels of all curves, and what is fitted to each.
[[nodiscard]] std::vector<StudyTable> fragility_tables(const FragilityReport& report);

/// A question, with the files that it is read from, and how the answer is shown.
struct RunsQuestion {
  FragilityQuestion question;
  std::vector<std::string> hazards;  ///< files; the first is that of the rates
  std::vector<HazardCurve> branches = {};
  std::optional<double> survived;  ///< [years]
  std::optional<std::string> imt;
  std::vector<double> site;  ///< longitude and latitude [degrees]; empty: not asked for
  std::optional<std::string> statistic;
  std::optional<std::string> rare;  ///< folder of rare.json, or the file
  std::optional<std::string> joint_hazard;
  std::optional<std::string> sheet;
  std::optional<std::string> project;
  std::optional<std::string> date;
  std::optional<std::string> export_file;
  std::optional<std::string> export_as;
  bool suggest = false;
  bool per_record = false;
};

[[nodiscard]] const StructType& fields_of(const FragilityQuestion*);
[[nodiscard]] const StructType& fields_of(const RunsQuestion*);

[[nodiscard]] const StructType& fields_of(const Survival*);
[[nodiscard]] const StructType& fields_of(const ReportedSuite*);
[[nodiscard]] const StructType& fields_of(const ReportedSurface*);

/// Whether the blocks still stand: how likely, by block and by hazard curve.
[[nodiscard]] std::string survival_table(const Survival& survival);
/// The first line of it.
[[nodiscard]] std::string survival_in_words(const Survival& survival);

/// The surface over two measures: what matters, its coefficients, and its rate.
[[nodiscard]] std::string surface_table(const std::string& title, const FragilitySurface& surface);

/// Formats of other programs: NRML 0.5 of OpenQuake, the fragility table of pelicun, or CSV.
enum class ExportFormat : std::uint8_t { nrml, pelicun, csv };
/// Their names, in their order.
inline constexpr std::array<std::string_view, 3> export_format_names{"nrml", "pelicun", "csv"};

/// Fragility functions for another program, and what it cannot be told of them.
struct ExportedFragility {
  std::string text;
  std::vector<std::string> notices;
};

/// A function for each run and each combination of values of the rest of its sweep, with a limit state for each event:
/// the lognormal law, or where there is none the shares of the levels that do not decrease (lib/docs/fragility.md).
/// Throws UnfitQuestion where a format has no such measure of intensity, or where a curve has neither law nor such shares.
[[nodiscard]] ExportedFragility exported(const std::vector<RunFragility>& runs, ExportFormat format);

[[nodiscard]] const Study& fragility_study();

}  // namespace rocking
