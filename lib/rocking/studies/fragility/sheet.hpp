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
  std::string curve_png;  ///< picture of the curve; empty if it could not be drawn
  std::string program;    ///< version and revision
  std::string command;    ///< that makes the sheet again
};

/// One page of A4 as HTML without scripts and external resources: the object to scale, the question, the hazard and the
/// records, the curve, the rate with its return period, the probabilities in 1, 50 and 475 years, options, what the answer
/// rests on, assumptions, and how to make it again. Equal input gives equal bytes.
[[nodiscard]] std::string sheet_text(const SheetContent& sheet);

}  // namespace rocking::analysis
