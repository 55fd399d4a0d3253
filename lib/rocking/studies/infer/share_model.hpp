#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "rocking/stats/binomial_process.hpp"

namespace rocking::infer {

/// The shares of the groups of response modes under one condition, as functions of the unknowns.
///
/// Groups are taken one after the other, from the most frequent one on: each has a probability among those that are
/// left (stats::BinomialProcess). The last one takes what is left.
class ShareModel {
 public:
  /// `points`: a row each, in the unit cube; `counts`: of the rows by group. `former`: a model of fewer points, from
  /// whose scales the search begins; may be null.
  ShareModel(const Eigen::MatrixXd& points, const std::vector<std::vector<std::uint64_t>>& counts,
             const ShareModel* former);

  /// Logarithms of the shares by group.
  [[nodiscard]] Eigen::VectorXd log_shares(const Eigen::VectorXd& point) const;

  /// Shares that the realisations may stand for as well: `numbers` from N(0, 1), one for each group, move them by their
  /// error.
  ///
  /// All points have the same random numbers, and therefore similar errors: an error is at least that of one point. It
  /// is normal on the scale of the arc sine of the root of a share.
  [[nodiscard]] Eigen::VectorXd uncertain_shares(const Eigen::VectorXd& point, std::span<const double> numbers) const;

  [[nodiscard]] std::size_t groups() const { return order_.size(); }
  [[nodiscard]] std::size_t unknowns() const { return unknowns_; }
  /// Of a point.
  [[nodiscard]] double realisations() const { return realisations_; }

 private:
  std::vector<std::size_t> order_;                 ///< groups, the most frequent first
  std::vector<stats::BinomialProcess> processes_;  ///< of all but the last of them
  std::size_t unknowns_;
  double realisations_ = 0.0;
};

}  // namespace rocking::infer
