#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "rocking/stats/binomial_process.hpp"

namespace rocking::infer {

/// Shares of groups that may be in error.
struct UncertainShares {
  /// A group among those that are left after the groups before it.
  struct OfGroup {
    std::size_t group = 0;
    double angle = 0.0;  ///< arc sine of the root of its share
    double error = 0.0;  ///< standard deviation of the angle, by the model
  };
  std::vector<OfGroup> groups;  ///< all but the last
  std::size_t last = 0;
  double realisations = 0.0;  ///< of a point

  /// Shares that the realisations may stand for as well: `numbers` from N(0, 1), one for each group, move them by their
  /// error.
  [[nodiscard]] Eigen::VectorXd moved(std::span<const double> numbers) const;
};

/// The shares of the groups of response modes under one condition, as functions of the unknowns.
///
/// Groups are taken one after the other, from the most frequent one on: each has a probability among those that are
/// left (stats::BinomialProcess). The last one takes what is left.
class ShareModel {
 public:
  /// `points`: a row each, in the unit cube; `counts`: of the rows by group. `former`: a model of fewer points, from
  /// whose scales the search begins; may be null. Throws base::Stopped if it is asked to stop.
  ShareModel(const Eigen::MatrixXd& points, const std::vector<std::vector<std::uint64_t>>& counts,
             const ShareModel* former, base::StopRequest stop = {});

  /// Logarithms of the shares by group.
  [[nodiscard]] Eigen::VectorXd log_shares(const Eigen::VectorXd& point) const;

  /// The shares at a point with their errors.
  ///
  /// All points have the same random numbers, and therefore similar errors: an error is at least that of one point. It
  /// is normal on the scale of the arc sine of the root of a share.
  [[nodiscard]] UncertainShares uncertain_shares(const Eigen::VectorXd& point) const;

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
