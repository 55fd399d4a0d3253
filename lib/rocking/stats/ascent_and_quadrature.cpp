#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>

#include "rocking/base/error.hpp"
#include "rocking/stats/mixed_probit.hpp"

namespace rocking::stats {
namespace {

constexpr int most_newton_steps = 60;
constexpr double promised_at_maximum = 1e-10;

Eigen::VectorXd ascending_step(const LocalShape& shape) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(shape.hessian);
  const double largest = solved.eigenvalues().cwiseAbs().maxCoeff();
  const Eigen::VectorXd bent = solved.eigenvalues().cwiseAbs().cwiseMax(1e-12 * largest + 1e-300);
  return solved.eigenvectors() * (solved.eigenvectors().transpose() * shape.gradient).cwiseQuotient(bent);
}

}  // namespace

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

Ascent climb(const SmoothFunction& function, const Eigen::VectorXd& start) {
  return climb(function, start, function(start));
}

Ascent climb(const SmoothFunction& function, const Eigen::VectorXd& start, LocalShape at_start) {
  Ascent here{.at = start, .shape = std::move(at_start)};
  for (int step = 0; step < most_newton_steps; ++step) {
    if (!std::isfinite(here.shape.value)) return here;
    const Eigen::VectorXd direction = ascending_step(here.shape);
    const double promised = direction.dot(here.shape.gradient);
    const double least = promised_at_maximum * (1.0 + std::abs(here.shape.value));
    if (!(promised > least)) {
      here.has_converged = true;
      return here;
    }
    double length = 1.0;
    LocalShape there = function(here.at + direction);
    while (!(there.value >= here.shape.value + 1e-4 * length * promised) && length > 1e-4) {
      length *= 0.5;
      there = function(here.at + length * direction);
    }
    if (!(there.value >= here.shape.value)) {  // rounding hides what is left to gain
      here.has_converged = promised <= 1e-6;
      return here;
    }
    here.at += length * direction;
    here.shape = std::move(there);
  }
  return here;
}

}  // namespace rocking::stats
