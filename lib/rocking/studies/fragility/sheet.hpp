#pragma once

#include "rocking/output/report.hpp"
#include "rocking/studies/fragility/study.hpp"

namespace rocking::analysis {

/// What a sheet tells. The suites are about one event and have a rate; the first is the object as it stands.
struct SheetContent {
  const Report& run;
  std::vector<ReportedSuite> suites;
  std::vector<ReportedComparison> comparisons;
  const HazardCurve& hazard;
  std::vector<double> periods;  ///< of the spectral acceleration [s]; empty: none
  std::optional<Survival> survival;
  std::string headline;   ///< of these suites: headline()
  std::string curve_png;  ///< picture of the curve; empty if it could not be drawn
  std::string program;    ///< version and revision
  SheetNotes notes;
};

/// One page of A4 as HTML without scripts and external resources: the answer in a sentence, the options to scale, the
/// curves, the rates with return periods, the probabilities in 1, 50 and 475 years and factors, the question, the hazard
/// and the records, what the answer rests on, assumptions, lines for project, date and signature, and how to make it again.
/// Equal input gives equal bytes.
[[nodiscard]] std::string sheet_text(const SheetContent& sheet);

}  // namespace rocking::analysis
