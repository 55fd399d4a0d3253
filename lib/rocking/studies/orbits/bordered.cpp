#include "rocking/studies/orbits/bordered.hpp"

#include <cmath>
#include <cstddef>
#include <limits>

#include <Eigen/Dense>

namespace rocking {
namespace {

Eigen::Matrix3d eigen(const SectionMatrix& matrix) {
  Eigen::Matrix3d result;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      result(row, column) = matrix[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    }
  }
  return result;
}

/// (M - I, H_q).
Eigen::Matrix<double, 3, 4> curve_matrix(const MapDerivative& derivative) {
  Eigen::Matrix<double, 3, 4> matrix;
  matrix.leftCols<3>() = eigen(derivative.by_state) - Eigen::Matrix3d::Identity();
  for (int row = 0; row < 3; ++row) matrix(row, 3) = derivative.by_parameter[static_cast<std::size_t>(row)];
  return matrix;
}

Eigen::Matrix4d bordered_matrix(const MapDerivative& derivative, const Unknowns& border) {
  Eigen::Matrix4d matrix;
  matrix.topRows<3>() = curve_matrix(derivative);
  matrix.row(3) = Eigen::Vector4d(border.data()).transpose();
  return matrix;
}

}  // namespace

double dot(const Unknowns& a, const Unknowns& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 4; ++i) sum += a[i] * b[i];
  return sum;
}

Unknowns plus(const Unknowns& a, double share, const Unknowns& b) {
  Unknowns sum = a;
  for (std::size_t i = 0; i < 4; ++i) sum[i] += share * b[i];
  return sum;
}

double norm(const Unknowns& a) { return std::sqrt(dot(a, a)); }

std::optional<Unknowns> solve_bordered(const MapDerivative& derivative, const Unknowns& border, const Unknowns& right) {
  const Eigen::Vector4d solution =
      bordered_matrix(derivative, border).partialPivLu().solve(Eigen::Vector4d(right.data()));
  if (!solution.allFinite()) return std::nullopt;
  return Unknowns{solution[0], solution[1], solution[2], solution[3]};
}

double condition_of(const MapDerivative& derivative, const Unknowns& border) {
  const Eigen::Matrix4d inverse = bordered_matrix(derivative, border).inverse();
  const double condition = inverse.leftCols<3>().cwiseAbs().rowwise().sum().norm();
  return std::isfinite(condition) ? condition : std::numeric_limits<double>::infinity();
}

Unknowns direction_of(const MapDerivative& derivative) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(curve_matrix(derivative), Eigen::ComputeFullV);
  const Eigen::VectorXd last = svd.matrixV().col(3);
  return {last[0], last[1], last[2], last[3]};
}

double flip_determinant(const SectionMatrix& matrix) {
  return (Eigen::Matrix3d::Identity() + eigen(matrix)).determinant();
}

std::array<double, 3> flip_direction(const SectionMatrix& matrix) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(Eigen::Matrix3d::Identity() + eigen(matrix), Eigen::ComputeFullV);
  const Eigen::VectorXd last = svd.matrixV().col(2);
  return {last[0], last[1], last[2]};
}

}  // namespace rocking
