#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/store.hpp"
#include "rocking/stats/fragility.hpp"

namespace rocking::experiment {

/// Overturning against the intensity of the shaking: conditions that differ in nothing else.
struct FragilityCurve {
  std::string parameter;                      ///< JSON pointer to the intensity
  std::vector<Parameter> others;              ///< the rest of the sweep
  double confidence = 0.95;                   ///< that the experiment asks for
  std::vector<stats::IntensityLevel> levels;  ///< by growing intensity
  stats::FragilityFit fit;
};

/// What an experiment sweeps that is an intensity: `/excitation/amplitude`, `/excitation/scale`; empty where it is neither.
[[nodiscard]] std::string_view intensity_of(const Experiment& experiment);

/// A curve for each point of the grid of the other entries. An intensity of 0 has no logarithm and is left out. The experiment
/// sweeps an intensity and asks for so many realisations, not for as many as a rule wants. Throws InputError where the run is
/// not finished.
[[nodiscard]] std::vector<FragilityCurve> fragility(const Experiment& experiment, const Store& store);

}  // namespace rocking::experiment
