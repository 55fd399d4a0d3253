#include "rocking/studies/infer/made_up_tests.hpp"

#include <cmath>

#include "rocking/random/draws.hpp"

namespace rocking::infer {
namespace {

/// The group of a test with the number `u` in [0, 1).
Eigen::Index group_at(const Eigen::VectorXd& shares, double u) {
  double sum = 0.0;
  for (Eigen::Index group = 0; group + 1 < shares.size(); ++group) {
    sum += shares[group];
    if (u < sum) return group;
  }
  return shares.size() - 1;
}

}  // namespace

Eigen::MatrixXd made_up_tests(std::span<const ShareModel> models, const std::vector<std::uint64_t>& tests,
                              const Eigen::VectorXd& point, std::uint64_t seed, std::uint64_t first, std::size_t sets) {
  const std::size_t groups = models.front().groups();
  const auto all_groups = static_cast<Eigen::Index>(groups);
  Eigen::MatrixXd counts =
      Eigen::MatrixXd::Zero(all_groups * static_cast<Eigen::Index>(models.size()), static_cast<Eigen::Index>(sets));
  std::vector<double> numbers(groups);
  const double widening = std::sqrt(static_cast<double>(models.size()));
  for (std::size_t set = 0; set < sets; ++set) {
    const random::Draws draws(seed, first + set);
    std::uint64_t next = 0;
    for (std::size_t m = 0; m < models.size(); ++m) {
      draws.standard_normals(random::Source::inference_shares, m * groups, numbers);
      for (double& number : numbers) number *= widening;
      const Eigen::VectorXd shares = models[m].uncertain_shares(point, numbers);
      for (std::uint64_t test = 0; test < tests[m]; ++test) {
        const double u = draws.uniform(random::Source::inference_counts, next++);
        const Eigen::Index row = static_cast<Eigen::Index>(m) * all_groups + group_at(shares, u);
        counts(row, static_cast<Eigen::Index>(set)) += 1.0;
      }
    }
  }
  return counts;
}

}  // namespace rocking::infer
