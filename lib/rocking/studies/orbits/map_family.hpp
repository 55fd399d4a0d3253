#pragma once

#include <cmath>
#include <functional>

#include "rocking/realisation/poincare_map.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/orbits/orbit.hpp"

/// Linear algebra of a curve of fixed points H(z, q) = z, with z of three coordinates and one parameter q.
namespace rocking {

/// Theta, Theta', V and the parameter.
using Unknowns = std::array<double, 4>;

/// Derivatives of the map with respect to the state and the parameter.
struct MapDerivative {
  SectionMatrix by_state{};
  std::array<double, 3> by_parameter{};
};

template <std::size_t size>
[[nodiscard]] double dot(const std::array<double, size>& a, const std::array<double, size>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < size; ++i) sum += a[i] * b[i];
  return sum;
}
/// a + share b.
template <std::size_t size>
[[nodiscard]] std::array<double, size> plus(const std::array<double, size>& a, double share,
                                            const std::array<double, size>& b) {
  std::array<double, size> sum = a;
  for (std::size_t i = 0; i < size; ++i) sum[i] += share * b[i];
  return sum;
}
template <std::size_t size>
[[nodiscard]] double norm(const std::array<double, size>& a) {
  return std::sqrt(dot(a, a));
}

/// Largest entry of a derivative, at least 1: rounding of the image is about 2^-53 times it.
[[nodiscard]] double amplification(const SectionMatrix& matrix);

/// Whether the contact state fixes a coordinate: the image has it exactly, whatever the state was.
[[nodiscard]] bool is_fixed(const PoincareImage& image, std::size_t coordinate);

/// The solution of (M - I) z + H_q q = right, border . (z, q) = right[3]; absent where it is not finite.
[[nodiscard]] std::optional<Unknowns> solve_bordered(const MapDerivative& derivative, const Unknowns& border,
                                                     const Unknowns& right);

/// Largest distance between the solutions for two right-hand sides that differ by at most 1 in each of the first three
/// entries; infinite where the system is singular.
[[nodiscard]] double condition_of(const MapDerivative& derivative, const Unknowns& border);

/// Direction of the curve, of norm 1: the null vector of (M - I, H_q) that belongs to the smallest singular value.
[[nodiscard]] Unknowns direction_of(const MapDerivative& derivative);

/// det(I + M), 0 where -1 is an eigenvalue.
[[nodiscard]] double flip_determinant(const SectionMatrix& matrix);

/// abs(mu)^2 - 1 of the complex pair of eigenvalues, 0 where it is on the unit circle; absent where all are real.
[[nodiscard]] std::optional<double> pair_growth(const SectionMatrix& matrix);

/// The vector of norm 1 that belongs to the smallest singular value of I + M: the eigenvector for -1.
[[nodiscard]] std::array<double, 3> flip_direction(const SectionMatrix& matrix);

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
