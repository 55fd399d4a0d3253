#include "rocking/studies/orbits/fold_and_flip.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>

#include "rocking/realisation/fixed_point.hpp"

namespace rocking {
namespace {

// As in corrector.cpp, with three more corrections: the derivative of the test function is a difference, so that the
// error falls by a factor of about 1e-5 at a time and not by its square.
constexpr int most_corrections_of_critical = 15;
constexpr double enough_of_critical = 2e-15;
constexpr double may_be_rounding_of_critical = 1e-9;

/// Largest singular value that is left: the entries of M are known to about 1e-13 times the largest one, which is taken
/// as 100 at most.
constexpr double largest_singular_value = 1e-11;

/// A central difference over h has the error h^2/6 of the third derivative and 1e-16/h of rounding times the largest
/// entry of M: 2e-11 and 1e-11 for the first step. The others are for a change of contact within the first one.
constexpr std::array slope_steps{1e-5, 1e-7, 1e-9};

/// Rounding of the map and of its derivative, over the largest entry of the derivative. The tangent vectors pass each step
/// and each event by some ten products: a thousand roundings in all.
constexpr double rounding_of_image = 0x1p-52;
constexpr double rounding_of_derivative = 0x1p-43;

/// Orbits that branch off are nearly singular next to the bifurcation, which was found on them up to some 1e-4 away. Over
/// such a distance of the parameter their state changes by its root.
constexpr double near_share = 1e-3;
constexpr double near_orbit = 1e-2;

/// The equations (H - z, g) = 0 of an orbit with the critical multiplier.
class CriticalEquations {
 public:
  /// `image`: at the start, where the singular vectors that belong to the smallest singular value border the matrix.
  CriticalEquations(const MapFamily& family, CriticalMultiplier multiplier, const PoincareImage& image)
      : family_(&family), sign_(static_cast<double>(static_cast<int>(multiplier))) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(critical_matrix(image), Eigen::ComputeFullU | Eigen::ComputeFullV);
    left_ = svd.matrixU().col(2);
    right_ = svd.matrixV().col(2);
  }

  [[nodiscard]] Eigen::Vector4d value(const Unknowns& at, const PoincareImage& image) const {
    return {image.end().tilt - at[0], image.end().tilt_rate - at[1], image.end().slip_rate - at[2], test(image)};
  }

  [[nodiscard]] std::optional<Eigen::Matrix4d> derivative(const Unknowns& at, const PoincareImage& image) const {
    Eigen::Matrix4d found = Eigen::Matrix4d::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      const auto column = static_cast<int>(i);
      if (i < 3 && is_fixed(image, i)) {
        found(column, column) = -1.0;
        continue;
      }
      const auto along = slope(at, image, i);
      if (!along) return std::nullopt;
      found.col(column) = *along;
      if (i == 3) continue;
      for (std::size_t row = 0; row < 3; ++row) {  // exact, from the tangent flow
        found(static_cast<int>(row), column) = image.derivative[row][i] - (row == i ? 1.0 : 0.0);
      }
    }
    return found;
  }

  [[nodiscard]] double smallest_singular_value(const PoincareImage& image) const {
    return Eigen::JacobiSVD<Eigen::MatrixXd>(critical_matrix(image)).singularValues()[2];
  }

 private:
  /// M - sign I.
  [[nodiscard]] Eigen::Matrix3d critical_matrix(const PoincareImage& image) const {
    Eigen::Matrix3d matrix;
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 3; ++column) {
        matrix(row, column) = image.derivative[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
      }
    }
    return matrix - sign_ * Eigen::Matrix3d::Identity();
  }

  /// g: 0 where M - sign I is singular.
  [[nodiscard]] double test(const PoincareImage& image) const {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    matrix.topLeftCorner<3, 3>() = critical_matrix(image);
    matrix.topRightCorner<3, 1>() = left_;
    matrix.bottomLeftCorner<1, 3>() = right_.transpose();
    return matrix.partialPivLu().solve(Eigen::Vector4d(0.0, 0.0, 0.0, 1.0))[3];
  }

  /// Difference along one unknown, between motions with the same changes of contact.
  [[nodiscard]] std::optional<Eigen::Vector4d> slope(const Unknowns& at, const PoincareImage& image,
                                                     std::size_t unknown) const {
    const Eigen::Vector4d here = value(at, image);
    const auto beside = [&](double step) -> std::optional<Eigen::Vector4d> {
      Unknowns other = at;
      other[unknown] += step;
      const auto found = family_->image(other);
      if (!found || found->sequence != image.sequence) return std::nullopt;
      return value(other, *found);
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

  const MapFamily* family_;
  double sign_;
  Eigen::Vector3d left_, right_;
};

/// The best of Newton's points.
struct NewtonPoint {
  Unknowns at{};
  PoincareImage image;
  Eigen::Vector4d value;
  Eigen::Matrix4d derivative;

  [[nodiscard]] double size() const { return value.cwiseAbs().maxCoeff(); }
  [[nodiscard]] double residual() const { return value.head<3>().cwiseAbs().maxCoeff(); }
};

/// Newton's step; coordinates that the contact state fixes are 0: a slip rate of 1e-20 would be another contact state.
std::optional<Unknowns> next_of(const NewtonPoint& point) {
  const Eigen::Vector4d step = point.derivative.partialPivLu().solve(-point.value);
  if (!step.allFinite()) return std::nullopt;
  Unknowns next = point.at;
  for (std::size_t i = 0; i < 4; ++i) next[i] += step[static_cast<int>(i)];
  for (std::size_t i = 0; i < 3; ++i) {
    if (is_fixed(point.image, i)) next[i] = 0.0;
  }
  return next;
}

/// Of the parameter, by the residuals at a point and their rounding.
double error_of(const NewtonPoint& point) {
  const Eigen::Vector4d row = point.derivative.partialPivLu().inverse().row(3).transpose().cwiseAbs();
  const double largest = amplification(point.image.derivative);
  const double of_orbit = std::max(point.residual(), rounding_of_image * largest);
  const double of_test = std::max(std::abs(point.value[3]), rounding_of_derivative * largest);
  return of_orbit * row.head<3>().sum() + of_test * row[3];
}

std::optional<NewtonPoint> newton(const MapFamily& family, const CriticalEquations& equations, Unknowns at,
                                  base::StopRequest stop) {
  std::optional<NewtonPoint> best;
  for (int i = 0; i <= most_corrections_of_critical; ++i) {
    stop.check();
    auto image = family.image(at);
    if (!image || image->not_differentiable.any()) break;
    const Eigen::Vector4d value = equations.value(at, *image);
    if (!value.allFinite()) break;
    const double size = value.cwiseAbs().maxCoeff(), least = best ? best->size() : size;
    if (best && !(size < least) && (least < may_be_rounding_of_critical || size > 10.0 * least)) break;
    const auto derivative = equations.derivative(at, *image);
    if (!derivative) break;
    NewtonPoint point{.at = at, .image = std::move(*image), .value = value, .derivative = *derivative};
    const auto next = next_of(point);
    if (!best || size < least) best = std::move(point);
    if (!next || size < enough_of_critical) break;
    at = *next;
  }
  return best;
}

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

std::optional<CriticalPoint> critical_near(const MapFamily& family, CriticalMultiplier multiplier, const Unknowns& at,
                                           base::StopRequest stop) {
  const auto image = family.image(at);
  if (!image) return std::nullopt;
  const CriticalEquations equations(family, multiplier, *image);
  const auto found = newton(family, equations, at, stop);
  if (!found) return std::nullopt;
  const double largest = amplification(found->image.derivative);
  const bool is_critical = found->residual() <= largest_residual * largest &&
                           equations.smallest_singular_value(found->image) <= largest_singular_value * largest;
  const bool is_near = std::abs(found->at[3] - at[3]) <= near_share && norm(plus(found->at, -1.0, at)) <= near_orbit;
  if (!is_critical || !is_near) return std::nullopt;
  return CriticalPoint{.at = found->at, .error = error_of(*found)};
}

}  // namespace rocking
