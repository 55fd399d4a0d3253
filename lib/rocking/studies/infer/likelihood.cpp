#include "rocking/studies/infer/likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace rocking::infer {

Counts in_one_row(const std::vector<std::vector<std::uint64_t>>& counts) {
  Counts row(static_cast<Eigen::Index>(counts.size() * counts.front().size()));
  Eigen::Index place = 0;
  for (const auto& of_condition : counts) {
    for (const std::uint64_t count : of_condition) row[place++] = static_cast<double>(count);
  }
  return row;
}

Likelihood::Likelihood(const std::vector<ShareModel>& models, Lattice lattice, const base::ManyParts& how)
    : lattice_(std::move(lattice)), stop_(how.stop) {
  const auto groups = static_cast<Eigen::Index>(models.front().groups());
  log_shares_.resize(static_cast<Eigen::Index>(lattice_.size()), groups * static_cast<Eigen::Index>(models.size()));
  base::for_each_part({.threads = how.threads, .stop = how.stop}, lattice_.size(), [&](std::size_t i) {
    const Eigen::VectorXd point = lattice_.point(i);
    for (std::size_t m = 0; m < models.size(); ++m) {
      stop_.check();
      log_shares_.row(static_cast<Eigen::Index>(i)).segment(static_cast<Eigen::Index>(m) * groups, groups) =
          models[m].log_shares(point);
    }
  });
}

Eigen::MatrixXd Likelihood::logarithms_of_sets(const Eigen::MatrixXd& sets) const {
  constexpr Eigen::Index at_once = 32;
  Eigen::MatrixXd logarithms(log_shares_.rows(), sets.cols());
  for (Eigen::Index first = 0; first < sets.cols(); first += at_once) {
    stop_.check();
    const Eigen::Index number = std::min(at_once, sets.cols() - first);
    logarithms.middleCols(first, number).noalias() = log_shares_ * sets.middleCols(first, number);
  }
  return logarithms;
}

double log_coefficients(const std::vector<std::vector<std::uint64_t>>& counts) {
  const auto log_factorial = [](std::uint64_t n) {
    double sum = 0.0;
    for (std::uint64_t i = 2; i <= n; ++i) sum += std::log(static_cast<double>(i));
    return sum;
  };
  double sum = 0.0;
  for (const auto& of_condition : counts) {
    std::uint64_t all = 0;
    for (const std::uint64_t count : of_condition) {
      all += count;
      sum -= log_factorial(count);
    }
    sum += log_factorial(all);
  }
  return sum;
}

Eigen::VectorXd deviances(const Eigen::VectorXd& logarithms) {
  return 2.0 * (logarithms.maxCoeff() - logarithms.array()).matrix();
}

std::size_t best_point(const Lattice& lattice, const Eigen::VectorXd& logarithms) {
  constexpr double is_equal = 0.001;
  const double least = logarithms.maxCoeff() - is_equal;
  const auto axes = static_cast<Eigen::Index>(lattice.axes());
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(axes);
  double number = 0.0;
  for (Eigen::Index i = 0; i < logarithms.size(); ++i) {
    if (logarithms[i] < least) continue;
    mean += lattice.point(static_cast<std::size_t>(i));
    number += 1.0;
  }
  mean /= number;
  std::size_t best = 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < logarithms.size(); ++i) {
    if (logarithms[i] < least) continue;
    const double distance = (lattice.point(static_cast<std::size_t>(i)) - mean).squaredNorm();
    if (distance >= nearest) continue;
    nearest = distance;
    best = static_cast<std::size_t>(i);
  }
  return best;
}

}  // namespace rocking::infer
