#pragma once

#include <array>
#include <optional>

#include "rocking/realisation/poincare_map.hpp"

/// Linear algebra of a curve of fixed points H(z, q) = z, with z of three coordinates and one parameter q.
namespace rocking {

/// Theta, Theta', V and the parameter.
using Unknowns = std::array<double, 4>;

/// Derivatives of the map with respect to the state and the parameter.
struct MapDerivative {
  SectionMatrix by_state{};
  std::array<double, 3> by_parameter{};
};

[[nodiscard]] double dot(const Unknowns& a, const Unknowns& b);
/// a + share b.
[[nodiscard]] Unknowns plus(const Unknowns& a, double share, const Unknowns& b);
[[nodiscard]] double norm(const Unknowns& a);

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

/// The vector of norm 1 that belongs to the smallest singular value of I + M: the eigenvector for -1.
[[nodiscard]] std::array<double, 3> flip_direction(const SectionMatrix& matrix);

}  // namespace rocking
