#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "rocking/base/many_parts.hpp"
#include "rocking/stats/fragility.hpp"

/// Probit regression of a suite on two regressors: P(event at u, v) = Phi(c0 + c1 u + c2 v + c3 u v).
namespace rocking::stats {

/// Counts of the trials under a record at one point.
struct SurfaceCounts {
  double u = 0.0;
  double v = 0.0;
  double happened = 0.0;  ///< trials with the event
  double did_not = 0.0;   ///< trials without it
  std::size_t record = 0;
};

struct ProbitSurface {
  SurfaceCoefficients coefficients{};  ///< of maximum likelihood; c3 = 0 without interaction
  double log_likelihood = 0.0;
  std::vector<SurfaceCoefficients> samples;               ///< the same in the bootstrap samples with a maximum
  bool has_interaction = false;                           ///< c3 is taken: p <= 0.05
  std::optional<SurfaceTest> interaction = std::nullopt;  ///< of c3; absent: with it the likelihood has no maximum
  SurfaceTest second = {};                                ///< of c2, without interaction
};

/// `samples`: weights of the records in each bootstrap sample. Absent where the likelihood has no maximum without
/// interaction: a line parts the points with the event from those without it, or the points do not tell the terms apart.
/// A sample of a model is a part.
[[nodiscard]] std::optional<ProbitSurface> probit_surface(const std::vector<SurfaceCounts>& counts,
                                                          const std::vector<std::vector<double>>& samples,
                                                          const base::ManyParts& how = {});

}  // namespace rocking::stats
