#pragma once

#include <vector>

#include <Eigen/Core>

#include "rocking/base/stop_request.hpp"
#include "rocking/stats/interval.hpp"

namespace rocking::stats {

/// How a probability varies over the unit cube, on the log-odds scale.
struct ProcessScales {
  Eigen::VectorXd lengths;  ///< distance over which it changes, by coordinate; positive
  double amplitude = 2.0;   ///< standard deviation of the smooth part [log-odds]
  double roughness = 0.05;  ///< that of a part without correlation between points [log-odds]
};

/// Log-odds of a probability at a point: mean, and standard deviation of what is not known.
struct LogOdds {
  double mean = 0.0;
  double deviation = 0.0;
};

/// A probability as a smooth function over the unit cube, from counts at some of its points.
///
/// A Gaussian process of the log-odds with a constant of large variance, a Matern covariance with nu = 5/2 and one
/// length for each coordinate, and an independent part for what is rough; binomial likelihood; Laplace's approximation.
/// The scales maximise the approximate marginal likelihood times a weak prior. Source: Rasmussen & Williams (2006),
/// Gaussian Processes for Machine Learning, sections 3.4, 4.2 and 5.5.
class BinomialProcess {
 public:
  /// `points`: a row each; `counts`: of the rows; points without trials are permitted. `start`: scales from which the
  /// search begins, absent lengths: the standard ones. Throws base::Stopped if it is asked to stop.
  [[nodiscard]] static BinomialProcess fit(const Eigen::MatrixXd& points, const std::vector<Proportion>& counts,
                                           const ProcessScales& start = {}, base::StopRequest stop = {});

  [[nodiscard]] double mean_at(const Eigen::VectorXd& point) const;
  [[nodiscard]] LogOdds at(const Eigen::VectorXd& point) const;
  [[nodiscard]] const ProcessScales& scales() const { return scales_; }

 private:
  BinomialProcess() = default;
  [[nodiscard]] Eigen::VectorXd covariances_with(const Eigen::VectorXd& point) const;

  Eigen::MatrixXd columns_;  ///< the points, counted in lengths
  ProcessScales scales_;
  Eigen::VectorXd weights_;  ///< of the covariances with the points, whose sum is the mean
  Eigen::VectorXd root_;     ///< square roots of the curvature of the likelihood
  Eigen::MatrixXd factor_;   ///< lower Cholesky factor of 1 + root K root
};

}  // namespace rocking::stats
