#include "rocking/stats/mixed_probit.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

#include "rocking/base/error.hpp"

namespace rocking::stats {

std::vector<QuadratureNode> gauss_hermite(std::size_t nodes) {
  ROCKING_EXPECT(nodes >= 1);
  const auto size = static_cast<Eigen::Index>(nodes);
  Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(size, size);
  for (Eigen::Index i = 1; i < size; ++i) {
    jacobi(i, i - 1) = jacobi(i - 1, i) = std::sqrt(0.5 * static_cast<double>(i));
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(jacobi);
  std::vector<QuadratureNode> rule;
  for (Eigen::Index i = 0; i < size; ++i) {
    const double first = solved.eigenvectors()(0, i);
    rule.push_back({.x = solved.eigenvalues()(i), .weight = std::sqrt(std::numbers::pi) * first * first});
  }
  return rule;
}

}  // namespace rocking::stats
