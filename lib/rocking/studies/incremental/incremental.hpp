#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rocking/studies/curves/fragility_curve.hpp"

namespace rocking {

/// Quantiles of the peak tilt: 16, 50 and 84 %, about a standard deviation around the median of a lognormal number.
inline constexpr std::array<double, 3> peak_tilt_shares{0.16, 0.5, 0.84};

/// Quantiles of the peak tilt at one intensity, abs(Theta) [-]. An overturned block, and a realisation without an answer,
/// counts as beyond every tilt: absent where the quantile is one.
struct PeakTiltLevel {
  double intensity = 0.0;
  std::size_t trials = 0;
  std::size_t overturned = 0;
  std::array<std::optional<double>, peak_tilt_shares.size()> quantiles;
};

/// Trials that stand at an intensity and overturn at a weaker one (Vamvatsikos & Cornell 2002, Earthquake Engng Struct.
/// Dyn. 31, 491-514: structural resurrection). A trial is one realisation under one motion at all its levels.
struct Resurrections {
  std::size_t trials = 0;  ///< that stand again
  std::size_t of = 0;      ///< trials that overturn at some level
};

/// Peak tilt against intensity under one motion.
struct PeakTiltCurve {
  std::string record;  ///< empty: the experiment has one motion only
  std::vector<PeakTiltLevel> levels;
  Resurrections resurrections;
};

/// An incremental dynamic analysis.
struct IncrementalAnalysis {
  std::string parameter;
  std::vector<Parameter> others;
  std::vector<PeakTiltCurve> records;
  std::vector<PeakTiltLevel> all;  ///< of all records together, each trial of each record counted once
  Resurrections resurrections;     ///< sum over the records
};

/// Needs the peak tilts. Quantile q of n ordered numbers is number ceil(q n), counted from 1.
[[nodiscard]] IncrementalAnalysis incremental_analysis(const StripeGroup& group);

/// The incremental dynamic analysis of a run.
struct ReportedAnalysis {
  CurveRun run;
  IncrementalAnalysis analysis;
};

}  // namespace rocking
