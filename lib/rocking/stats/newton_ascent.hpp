#pragma once

#include <functional>

#include <Eigen/Core>

namespace rocking::stats {

/// A function of a few parameters at one point.
struct LocalShape {
  double value = 0.0;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd hessian;
};

using SmoothFunction = std::function<LocalShape(const Eigen::VectorXd&)>;

struct Ascent {
  Eigen::VectorXd at;
  LocalShape shape;
  bool has_converged = false;
};

/// A local maximum of a smooth function of at most a few parameters, by Newton's method.
///
/// Eigenvalues of the Hessian that are not negative are replaced by minus their absolute values, so that every step
/// ascends; a step is halved until the function increases by a ten-thousandth of what its slope promises (Nocedal &
/// Wright 2006, Numerical Optimization, sections 3.1 and 3.4). Converged: the next step promises an increase below
/// 1e-10 times (1 + abs(value)).
[[nodiscard]] Ascent climb(const SmoothFunction& function, const Eigen::VectorXd& start);
/// The same with the function at the start, if it is known.
[[nodiscard]] Ascent climb(const SmoothFunction& function, const Eigen::VectorXd& start, LocalShape at_start);

}  // namespace rocking::stats
