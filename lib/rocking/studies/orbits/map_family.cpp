#include "rocking/studies/orbits/map_family.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "rocking/realisation/fixed_point.hpp"

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

double amplification(const SectionMatrix& matrix) {
  double largest = 1.0;
  for (const auto& row : matrix) {
    for (const double entry : row) largest = std::max(largest, std::abs(entry));
  }
  return largest;
}

bool is_fixed(const PoincareImage& image, std::size_t coordinate) {
  const std::array<double, 3> end{image.end().tilt, image.end().tilt_rate, image.end().slip_rate};
  const auto& row = image.derivative[coordinate];
  return end[coordinate] == 0.0 && row[0] == 0.0 && row[1] == 0.0 && row[2] == 0.0;
}

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

std::optional<double> pair_growth(const SectionMatrix& matrix) {
  const Eigen::Vector3cd values = eigen(matrix).eigenvalues();
  const auto of_pair = std::find_if(values.begin(), values.end(), [](const auto& one) { return one.imag() != 0.0; });
  if (of_pair == values.end()) return std::nullopt;
  return std::norm(*of_pair) - 1.0;
}

std::array<double, 3> flip_direction(const SectionMatrix& matrix) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(Eigen::Matrix3d::Identity() + eigen(matrix), Eigen::ComputeFullV);
  const Eigen::VectorXd last = svd.matrixV().col(2);
  return {last[0], last[1], last[2]};
}

namespace {

constexpr double largest_tilt = 3.0;  // no block has pi/2 below psi/2

std::array<double, 3> difference(const section::StrobePoint& a, const section::StrobePoint& b, double over) {
  return {(a.tilt - b.tilt) / over, (a.tilt_rate - b.tilt_rate) / over, (a.slip_rate - b.slip_rate) / over};
}

constexpr std::array difference_steps{1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10};

/// Second difference over the first one, up to which a central difference is taken: its relative error is about the
/// square. Next to a grazing the map goes like a root of the distance, and a long step has a large error.
constexpr double little_bend = 1e-3;

double bend_of(const section::StrobePoint& above, const section::StrobePoint& here, const section::StrobePoint& below) {
  const auto second = [](double a, double b, double c) { return std::abs(a - b + (c - b)); };
  const double bend =
      std::max({second(above.tilt, here.tilt, below.tilt), second(above.tilt_rate, here.tilt_rate, below.tilt_rate),
                second(above.slip_rate, here.slip_rate, below.slip_rate)});
  const double first = distance(above, below);
  return first > 0.0 ? bend / first : 0.0;
}

}  // namespace

std::optional<PoincareMap> MapFamily::map(double q) const {
  if (!std::isfinite(q)) return std::nullopt;
  const auto condition = (*conditions_)(range_.value(q));
  if (!condition) return std::nullopt;
  return PoincareMap(*condition);
}

std::optional<PoincareImage> MapFamily::image(const Unknowns& at) const {
  if (!orbits_.is_symmetric) return full_image(at);
  if (!(std::abs(at[0]) < largest_tilt)) return std::nullopt;
  const auto map = this->map(at[3]);
  return map ? map->mirrored_half(state_of(at), orbits_.period) : std::nullopt;
}

std::optional<PoincareImage> MapFamily::full_image(const Unknowns& at) const {
  if (!(std::abs(at[0]) < largest_tilt) || !std::isfinite(at[1]) || !std::isfinite(at[2])) return std::nullopt;
  const auto map = this->map(at[3]);
  return map ? map->image(state_of(at), orbits_.period) : std::nullopt;
}

std::optional<std::array<double, 3>> MapFamily::by_parameter(const Unknowns& at, const PoincareImage& image) const {
  const auto beside = [&](double step) {
    auto other = this->image({at[0], at[1], at[2], at[3] + step});
    if (other && other->sequence != image.sequence) other.reset();
    return other;
  };
  std::optional<std::array<double, 3>> found;
  double least_bend = std::numeric_limits<double>::infinity();
  for (const double step : difference_steps) {
    const auto above = beside(step);
    const auto below = beside(-step);
    if (above && below) {
      const double bend = bend_of(above->end(), image.end(), below->end());
      if (bend < least_bend) found = difference(above->end(), below->end(), 2.0 * step), least_bend = bend;
      if (bend <= little_bend) return found;
    } else if (!found || least_bend == std::numeric_limits<double>::infinity()) {
      if (above) found = difference(above->end(), image.end(), step);
      if (below) found = difference(image.end(), below->end(), step);
    }
  }
  return found;
}

std::optional<section::StrobePoint> MapFamily::asymmetry(const Unknowns& at, const PoincareImage& image) const {
  if (orbits_.is_symmetric) return std::nullopt;
  section::StrobePoint other;
  if (orbits_.period % 2 == 0) {
    other = image.states[static_cast<std::size_t>(orbits_.period / 2 - 1)].point;
  } else {
    const auto map = this->map(at[3]);
    const auto half = map ? map->mirrored_half(state_of(at), orbits_.period) : std::nullopt;
    if (!half) return std::nullopt;
    other = half->end();
  }
  return section::StrobePoint{.tilt = 0.5 * (at[0] - other.tilt),
                              .tilt_rate = 0.5 * (at[1] - other.tilt_rate),
                              .slip_rate = 0.5 * (at[2] - other.slip_rate)};
}

}  // namespace rocking
