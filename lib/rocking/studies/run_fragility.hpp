#pragma once

#include <optional>
#include <vector>

#include "rocking/scene/experiment.hpp"
#include "rocking/scene/hazard.hpp"
#include "rocking/studies/annual_rate.hpp"
#include "rocking/studies/fragility_curve.hpp"
#include "rocking/studies/suite/incremental.hpp"
#include "rocking/studies/suite/stripes.hpp"
#include "rocking/studies/suite/suite_curve.hpp"

namespace rocking {

struct RunOptions;

/// The curve of one motion; with the annual rate where a hazard curve is given.
struct ShownCurve {
  FragilityCurve curve;
  std::optional<AnnualRate> rate = std::nullopt;
};

/// The curve of a suite; with the annual rate, or its absence without a law, where a hazard curve is given.
struct ShownSuite {
  SuiteCurve curve;
  std::optional<std::optional<AnnualRate>> rate = std::nullopt;
};

/// The curves of a run.
struct RunFragility {
  Experiment experiment;
  std::vector<ShownCurve> curves = {};
  std::vector<ShownSuite> suites = {};
  std::vector<IncrementalAnalysis> incremental = {};
};

/// What is asked of a run beside the probability of overturning.
struct FragilityQuestion {
  std::vector<double> peak_tilts = {};     ///< also the probability that abs(Theta) exceeds each; > 0
  std::optional<HazardCurve> hazard = {};  ///< gives the mean annual rates
  bool incremental = false;                ///< also the peak tilt against intensity for each record
};

/// The curves of a run from its stripes: for each group, for each event. Throws base::InputError if the hazard curve is one
/// of another intensity, and base::Stopped if it is asked to stop. Uses `threads`, `stop_requested` and `on_progress` of
/// the options; progress counts parts of about equal work, most of them bootstrap samples.
[[nodiscard]] RunFragility run_fragility(const Experiment& experiment, const std::vector<StripeGroup>& groups,
                                         const FragilityQuestion& question, const RunOptions& options);

}  // namespace rocking
