#pragma once

#include <functional>
#include <optional>

#include "rocking/realisation/poincare_map.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/orbits/bordered.hpp"
#include "rocking/studies/orbits/branch.hpp"
#include "rocking/studies/orbits/orbit.hpp"

namespace rocking {

/// A condition for each value of a parameter; absent where the value is not allowed.
using ConditionFamily = std::function<std::optional<Condition>(double value)>;

/// The map whose fixed points are the orbits of a family, over the parameter. Of symmetric orbits it is the mirrored map
/// over half the period (PoincareMap::mirrored_half), else that over the period. The last unknown q is the share of the
/// range.
class MapFamily {
 public:
  MapFamily(const ConditionFamily& conditions, const ParameterRange& range, const OrbitFamily& orbits)
      : conditions_(&conditions), range_(range), orbits_(orbits) {}

  /// Absent where the motion ends before, or the parameter is not allowed.
  [[nodiscard]] std::optional<PoincareImage> image(const Unknowns& at) const;

  /// The map over the whole period, whether or not the orbits are symmetric.
  [[nodiscard]] std::optional<PoincareImage> full_image(const Unknowns& at) const;

  /// The derivative by q: a central difference over 2e-5 of the range, between motions with the same changes of
  /// contact. Where one of them has others, or the parameter is not allowed there, it is one-sided; where both do, over
  /// a hundredth or a ten-thousandth of that. Its error is about 1e-10 of the third derivative and 1e-11 of the largest
  /// entry of the matrix. It slows Newton's method down but moves no result: the residual does not contain it, and test
  /// functions come from the tangent flow.
  [[nodiscard]] std::optional<std::array<double, 3>> by_parameter(const Unknowns& at, const PoincareImage& image) const;

  /// Half the difference between the orbit and what it would be equal to in the family from which it may branch off: its
  /// mirror image if n is odd, its own second half if n is even. Absent of symmetric orbits.
  [[nodiscard]] std::optional<section::StrobePoint> asymmetry(const Unknowns& at, const PoincareImage& image) const;

  [[nodiscard]] const OrbitFamily& orbits() const { return orbits_; }
  [[nodiscard]] const ParameterRange& range() const { return range_; }
  [[nodiscard]] const ConditionFamily& conditions() const { return *conditions_; }

 private:
  [[nodiscard]] std::optional<PoincareMap> map(double q) const;

  const ConditionFamily* conditions_;
  ParameterRange range_;
  OrbitFamily orbits_;
};

[[nodiscard]] inline section::StrobePoint state_of(const Unknowns& at) {
  return {.tilt = at[0], .tilt_rate = at[1], .slip_rate = at[2]};
}
[[nodiscard]] inline Unknowns unknowns_of(const section::StrobePoint& point, double q) {
  return {point.tilt, point.tilt_rate, point.slip_rate, q};
}

}  // namespace rocking
