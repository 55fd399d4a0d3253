#pragma once

#include "rocking/base/many_parts.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/studies/infer/lattice.hpp"
#include "rocking/studies/infer/share_model.hpp"

namespace rocking::infer {

/// Counts by condition and group, one after the other.
using Counts = Eigen::VectorXd;
[[nodiscard]] Counts in_one_row(const std::vector<std::vector<std::uint64_t>>& counts);

/// The multinomial likelihood of any counts at the points of a lattice.
class Likelihood {
 public:
  /// `models`: of the tested conditions. Throws base::Stopped if it is asked to stop. Of `how` the threads count.
  Likelihood(const std::vector<ShareModel>& models, Lattice lattice, const base::ManyParts& how = {});

  [[nodiscard]] const Lattice& lattice() const { return lattice_; }
  /// Log-likelihood without the multinomial coefficients, at each point.
  [[nodiscard]] Eigen::VectorXd logarithms(const Counts& counts) const { return log_shares_ * counts; }
  /// The same of several data sets, one in each column. Throws base::Stopped if it is asked to stop.
  [[nodiscard]] Eigen::MatrixXd logarithms_of_sets(const Eigen::MatrixXd& sets) const;

 private:
  Lattice lattice_;
  base::StopRequest stop_;
  Eigen::MatrixXd log_shares_;  ///< a row for each point; condition by condition, group by group
};

/// Logarithm of the multinomial coefficients of counted tests.
[[nodiscard]] double log_coefficients(const std::vector<std::vector<std::uint64_t>>& counts);

/// Twice the amount by which the logarithm is below its maximum.
[[nodiscard]] Eigen::VectorXd deviances(const Eigen::VectorXd& logarithms);

/// Where the maximum is. Of several points within 0.001 of it, the one nearest to their mean: where nothing can be told
/// that is the middle.
[[nodiscard]] std::size_t best_point(const Lattice& lattice, const Eigen::VectorXd& logarithms);

}  // namespace rocking::infer
