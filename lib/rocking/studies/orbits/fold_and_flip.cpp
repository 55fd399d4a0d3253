#include "rocking/studies/orbits/fold_and_flip.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include "rocking/realisation/fixed_point.hpp"

namespace rocking {
namespace {

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Curve = Eigen::Matrix<double, 4, 5>;  ///< derivative of (H - z, g)

// As in corrector.cpp, with three more corrections: the derivative of the test function is a difference, so that the
// error falls by a factor of about 1e-5 at a time and not by its square.
constexpr int most_corrections_in_plane = 15;
constexpr double enough_in_plane = 2e-15;
constexpr double may_be_rounding_in_plane = 1e-9;

/// A central difference over h has the error h^2/6 of the third derivative and 1e-16/h of rounding times the largest
/// entry of M: 2e-11 and 1e-11 for the first step. The others are for a change of contact within the first one.
constexpr std::array slope_steps{1e-5, 1e-7, 1e-9};

/// Rounding of the map and of its derivative, over the largest entry of the derivative. The tangent vectors pass each step
/// and each event by some ten products: a thousand roundings in all.
constexpr double rounding_of_image = 0x1p-52;
constexpr double rounding_of_derivative = 0x1p-43;

/// M - sign I.
Eigen::Matrix3d critical_matrix(const CriticalFamily& family, const PoincareImage& image) {
  Eigen::Matrix3d matrix;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      matrix(row, column) = image.derivative[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
    }
  }
  return matrix - static_cast<double>(static_cast<int>(family.multiplier)) * Eigen::Matrix3d::Identity();
}

/// The last entry of the solution of the bordered system; 0 where M - sign I is singular.
double test_of(const CriticalFamily& family, const CriticalBorder& border, const PoincareImage& image) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  matrix.topLeftCorner<3, 3>() = critical_matrix(family, image);
  matrix.topRightCorner<3, 1>() = Eigen::Vector3d(border.left.data());
  matrix.bottomLeftCorner<1, 3>() = Eigen::Vector3d(border.right.data()).transpose();
  return matrix.partialPivLu().solve(Eigen::Vector4d(0.0, 0.0, 0.0, 1.0))[3];
}

double smallest_singular_value(const CriticalFamily& family, const PoincareImage& image) {
  return Eigen::JacobiSVD<Eigen::MatrixXd>(critical_matrix(family, image)).singularValues()[2];
}

/// H - z and g.
Eigen::Vector4d value_of(const PlaneUnknowns& at, const PoincareImage& image, double test) {
  return {image.end().tilt - at[0], image.end().tilt_rate - at[1], image.end().slip_rate - at[2], test};
}

/// Difference of (H - z, g) along one unknown, between motions with the same changes of contact.
std::optional<Eigen::Vector4d> slope(const CriticalFamily& family, const CriticalBorder& border,
                                     const PlaneUnknowns& at, const PoincareImage& image, std::size_t unknown) {
  const Eigen::Vector4d here = value_of(at, image, test_of(family, border, image));
  const auto beside = [&](double step) -> std::optional<Eigen::Vector4d> {
    PlaneUnknowns other = at;
    other[unknown] += step;
    const auto found = image_of(family, other);
    if (!found || found->sequence != image.sequence) return std::nullopt;
    return value_of(other, *found, test_of(family, border, *found));
  };
  for (const double step : slope_steps) {
    const auto above = beside(step);
    const auto below = beside(-step);
    if (above && below) return (*above - *below) / (2.0 * step);
    if (above) return (*above - here) / step;
    if (below) return (here - *below) / step;
  }
  return std::nullopt;
}

std::optional<Curve> derivative_of(const CriticalFamily& family, const CriticalBorder& border, const PlaneUnknowns& at,
                                   const PoincareImage& image) {
  Curve curve = Curve::Zero();
  for (std::size_t i = 0; i < 5; ++i) {
    const auto column = static_cast<int>(i);
    if (i < 3 && is_fixed(image, i)) {
      curve(column, column) = -1.0;
      continue;
    }
    const auto found = slope(family, border, at, image, i);
    if (!found) return std::nullopt;
    curve.col(column) = *found;
    if (i >= 3) continue;
    for (std::size_t row = 0; row < 3; ++row) {  // exact, from the tangent flow
      curve(static_cast<int>(row), column) = image.derivative[row][i] - (row == i ? 1.0 : 0.0);
    }
  }
  return curve;
}

Eigen::Matrix<double, 5, 5> matrix_of(const Curve& derivative, const PlaneSection& section) {
  Eigen::Matrix<double, 5, 5> matrix;
  matrix.topRows<4>() = derivative;
  matrix.row(4) = Vector5(section.normal.data()).transpose();
  return matrix;
}

/// Of the first parameter, by the residuals at a point and their rounding.
double error_of(const Curve& derivative, const PlaneSection& section, const CriticalPoint& point, double test) {
  const Vector5 row = matrix_of(derivative, section).inverse().row(3).transpose().cwiseAbs();
  const double largest = amplification(point.image.derivative);
  const double of_orbit = std::max(point.residual, rounding_of_image * largest);
  const double of_test = std::max(std::abs(test), rounding_of_derivative * largest);
  return of_orbit * row.head<3>().sum() + of_test * row[3];
}

std::optional<PlaneUnknowns> next_of(const Curve& derivative, const PlaneSection& section, const PlaneUnknowns& at,
                                     const Eigen::Vector4d& value) {
  Vector5 right;
  right.head<4>() = -value;
  right[4] = -dot(section.normal, plus(at, -1.0, section.through));
  const Vector5 step = matrix_of(derivative, section).partialPivLu().solve(right);
  if (!step.allFinite()) return std::nullopt;
  PlaneUnknowns next = at;
  for (std::size_t i = 0; i < 5; ++i) next[i] += step[static_cast<int>(i)];
  return next;
}

/// The null vector of the derivative, of norm 1, with a positive product with the normal. Its entries along coordinates
/// that the contact state fixes are 0: a slip rate of 1e-20 would be another contact state.
PlaneUnknowns tangent_of(const Curve& derivative, const PlaneSection& section, const PoincareImage& image) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(derivative, Eigen::ComputeFullV);
  const Eigen::VectorXd last = svd.matrixV().col(4);
  PlaneUnknowns tangent{last[0], last[1], last[2], last[3], last[4]};
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_fixed(image, i)) tangent[i] = 0.0;
  }
  return dot(tangent, section.normal) < 0.0 ? plus({}, -1.0, tangent) : tangent;
}

}  // namespace

std::optional<PoincareImage> image_of(const CriticalFamily& family, const PlaneUnknowns& at) {
  if (!std::isfinite(at[4])) return std::nullopt;
  const ConditionFamily line = [&](double first) { return (*family.conditions)(first, family.ranges[1].value(at[4])); };
  return MapFamily(line, family.ranges[0], family.orbits).image({at[0], at[1], at[2], at[3]});
}

/// The singular vectors of M - sign I that belong to its smallest singular value.
static CriticalBorder border_of(const CriticalFamily& family, const PoincareImage& image) {
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(critical_matrix(family, image),
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::VectorXd left = svd.matrixU().col(2);
  const Eigen::VectorXd right = svd.matrixV().col(2);
  return {.left = {left[0], left[1], left[2]}, .right = {right[0], right[1], right[2]}};
}

std::optional<CriticalPoint> correct(const CriticalFamily& family, const CriticalBorder& border,
                                     const PlaneSection& section, base::StopRequest stop) {
  std::optional<CriticalPoint> best;
  std::optional<Curve> derivative_at_best;
  double size_of_best = 0.0;
  double test_of_best = 0.0;
  PlaneUnknowns at = section.through;
  for (int i = 0; i <= most_corrections_in_plane; ++i) {
    stop.check();
    auto image = image_of(family, at);
    if (!image || image->not_differentiable.any()) break;
    const Eigen::Vector4d value = value_of(at, *image, test_of(family, border, *image));
    if (!value.allFinite()) break;
    const double size = value.cwiseAbs().maxCoeff();
    if (best && !(size < size_of_best) && (size_of_best < may_be_rounding_in_plane || size > 10.0 * size_of_best))
      break;
    const auto derivative = derivative_of(family, border, at, *image);
    if (!derivative) break;
    auto next = next_of(*derivative, section, at, value);
    if (next) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (is_fixed(*image, k)) (*next)[k] = 0.0;
      }
    }
    if (!best || size < size_of_best) {
      best = CriticalPoint{
          .at = at, .image = std::move(*image), .residual = value.head<3>().cwiseAbs().maxCoeff(), .steps = i};
      derivative_at_best = derivative;
      size_of_best = size;
      test_of_best = value[3];
    }
    if (!next || size < enough_in_plane) break;
    at = *next;
  }
  if (!best || !(best->residual <= largest_residual * amplification(best->image.derivative))) return std::nullopt;
  best->test = smallest_singular_value(family, best->image);
  if (!(best->test <= largest_test * amplification(best->image.derivative))) return std::nullopt;
  best->error = error_of(*derivative_at_best, section, *best, test_of_best);
  best->border = border_of(family, best->image);
  best->tangent = tangent_of(*derivative_at_best, section, best->image);
  return best;
}

namespace {

/// Orbits that branch off are nearly singular next to the bifurcation, which was found on them up to some 1e-4 away. Over
/// such a distance of the parameter their state changes by its root.
constexpr double near_share = 1e-3;
constexpr double near_orbit = 1e-2;

}  // namespace

std::vector<CriticalOrbits> critical_orbits(BifurcationKind kind, const OrbitFamily& of_branch) {
  const int period = of_branch.period;
  switch (kind) {
    case BifurcationKind::fold: return {{of_branch, CriticalMultiplier::plus_one}};
    case BifurcationKind::symmetry_breaking:
      return {{{.period = period, .is_symmetric = true}, CriticalMultiplier::minus_one}};
    case BifurcationKind::period_doubling: {
      std::vector<CriticalOrbits> found{{{.period = period, .is_symmetric = false}, CriticalMultiplier::minus_one}};
      if (period % 2 == 0) {
        found.push_back({{.period = period / 2, .is_symmetric = false}, CriticalMultiplier::minus_one});
      }
      return found;
    }
    case BifurcationKind::neimark_sacker:
    case BifurcationKind::grazing:
    case BifurcationKind::contact_change: break;
  }
  return {};
}

std::optional<CriticalPoint> critical_near(const CriticalFamily& family, const PlaneUnknowns& at,
                                           base::StopRequest stop) {
  const auto image = image_of(family, at);
  if (!image) return std::nullopt;
  auto found = correct(family, border_of(family, *image), {.normal = {0.0, 0.0, 0.0, 0.0, 1.0}, .through = at}, stop);
  if (!found || std::abs(found->at[3] - at[3]) > near_share) return std::nullopt;
  if (norm(plus(found->at, -1.0, at)) > near_orbit) return std::nullopt;
  return found;
}

}  // namespace rocking
