#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "rocking/studies/orbits/orbits.hpp"
#include "support/excitation.hpp"

/// Branches of the block without sliding under a harmonic base motion, over its amplitude.
namespace rocking::support {

inline BranchQuestion amplitudes(std::vector<double> values, const ParameterRange& range) {
  return {.conditions = [](double value) { return std::optional(shaken(value)); },
          .values = std::move(values),
          .range = range,
          .most_points = 1000,
          .most_branches = 20};
}

inline std::vector<OrbitsOfCondition> orbits_at(const std::vector<double>& amplitudes, int longest) {
  std::vector<OrbitsOfCondition> found;
  for (const double amplitude : amplitudes) found.push_back(orbits_of(shaken(amplitude), longest));
  return found;
}

/// The first bifurcation of a kind; null: none.
inline const Bifurcation* find(const BranchStudy& study, BifurcationKind kind) {
  const auto found = std::ranges::find(study.bifurcations, kind, &Bifurcation::kind);
  return found == study.bifurcations.end() ? nullptr : &*found;
}

}  // namespace rocking::support
