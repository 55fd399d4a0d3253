#pragma once

#include <cstddef>
#include <vector>

namespace rocking::stats {

/// A node and its weight in the integral of exp(-x^2) f(x) over all x.
struct QuadratureNode {
  double x = 0.0;
  double weight = 0.0;
};

/// The rule with `nodes` >= 1 nodes that is exact for polynomials f of degree 2 nodes - 1, by growing x.
///
/// Nodes are the eigenvalues of the Jacobi matrix of the Hermite polynomials; weights are sqrt(pi) times the squares of
/// the first components of its eigenvectors. Source: Golub & Welsch (1969), Math. Comp. 23, 221-230.
[[nodiscard]] std::vector<QuadratureNode> gauss_hermite(std::size_t nodes);

}  // namespace rocking::stats
