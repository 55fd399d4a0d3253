#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "rocking/studies/infer/lattice.hpp"

namespace rocking::infer {

/// The corners of the unit cube and points of a Sobol sequence within: 12, 32 or 56 points for one, two or three
/// unknowns.
[[nodiscard]] std::vector<Eigen::VectorXd> first_design(std::size_t unknowns);

/// Points of a lattice to add to a design, where the likelihood is high and the design is thin: one after the other,
/// each with the largest product of the fourth root of the likelihood and the distance to the nearest point, where
/// distances are counted in the size of the lattice. No more than `most_points` are in the design then.
[[nodiscard]] std::vector<Eigen::VectorXd> further_points(const std::vector<Eigen::VectorXd>& design,
                                                          const Lattice& lattice, const Eigen::VectorXd& deviances);

/// Largest number of points of a design.
[[nodiscard]] std::size_t most_points(std::size_t unknowns);

}  // namespace rocking::infer
