#pragma once

#include <optional>
#include <span>

#include "rocking/section/classification.hpp"
#include "rocking/section/thresholds.hpp"

namespace rocking::section {

/// Closed curves on which the strobe points of a quasi-periodic response lie.
struct ClosedCurves {
  int curves = 1;         ///< n: every n-th point lies on the same curve
  double rotation = 0.0;  ///< turns of a curve in n periods, modulo 1, in (0, 1/2]: the direction is not known
  double margin = 1.0;    ///< smallest factor by which the thresholds are cleared, at least 1
};

/// Finds the least number of closed curves on which the points advance as by a rotation. Absent where that is not certain:
/// the points are in no such order, too few lie on a curve, they return after some periods to within their scatter (a
/// long period), or their returns become closer or wider with time. Noise is permitted as far as returns can be told
/// from it. O(N^2) time. Derivation: lib/docs/methods-classification.md.
[[nodiscard]] std::optional<ClosedCurves> find_closed_curves(std::span<const StrobePoint> points, double resolution,
                                                             const Thresholds& thresholds = {});

/// Whether the points may turn out to lie on closed curves, if more of them are looked at.
[[nodiscard]] bool may_be_closed_curves(std::span<const StrobePoint> points, double resolution,
                                        const Thresholds& thresholds = {});

}  // namespace rocking::section
