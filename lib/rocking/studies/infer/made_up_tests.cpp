#include "rocking/studies/infer/made_up_tests.hpp"

#include <cmath>

#include "rocking/random/binomial.hpp"
#include "rocking/random/draws.hpp"

namespace rocking::infer {
namespace {

/// Up to so many tests of a condition are made up one by one.
constexpr std::uint64_t most_one_by_one = 100;

/// The group of a test with the number `u` in [0, 1).
Eigen::Index group_at(const Eigen::VectorXd& shares, double u) {
  double sum = 0.0;
  for (Eigen::Index group = 0; group + 1 < shares.size(); ++group) {
    sum += shares[group];
    if (u < sum) return group;
  }
  return shares.size() - 1;
}

/// Group by group: of the tests that are left, a binomial number.
template <class Counts>
void add_together(const Eigen::VectorXd& shares, std::uint64_t tests, random::PhiloxEngine bits, Counts counts) {
  double left = 1.0;
  const Eigen::Index last = shares.size() - 1;
  for (Eigen::Index group = 0; group < last; ++group) {
    const std::uint64_t count = random::binomial(bits, tests, shares[group] < left ? shares[group] / left : 1.0);
    counts[group] = static_cast<double>(count);
    tests -= count;
    left -= shares[group];
  }
  counts[last] = static_cast<double>(tests);
}

}  // namespace

Eigen::MatrixXd made_up_tests(std::span<const ShareModel> models, const std::vector<std::uint64_t>& tests,
                              const Eigen::VectorXd& point, const MadeUpSets& asked, const base::ManyParts& how) {
  const std::size_t groups = models.front().groups();
  const auto all_groups = static_cast<Eigen::Index>(groups);
  Eigen::MatrixXd counts = Eigen::MatrixXd::Zero(all_groups * static_cast<Eigen::Index>(models.size()),
                                                 static_cast<Eigen::Index>(asked.sets));
  std::vector<UncertainShares> laws;
  for (const ShareModel& model : models) {
    how.stop.check();
    laws.push_back(model.uncertain_shares(point));
  }
  const double widening =
      asked.errors == ErrorsOfConditions::bounded ? std::sqrt(static_cast<double>(models.size())) : 1.0;
  base::for_each_part(how, asked.sets, [&](std::size_t set) {
    const random::Draws draws(asked.seed, asked.first + set);
    std::vector<double> of_shares(groups);
    std::uint64_t next = 0;
    for (std::size_t m = 0; m < models.size(); ++m) {
      draws.standard_normals(random::Source::inference_shares, m * groups, of_shares);
      for (double& number : of_shares) number *= widening;
      const Eigen::VectorXd shares = laws[m].moved(of_shares);
      auto of_condition =
          counts.col(static_cast<Eigen::Index>(set)).segment(static_cast<Eigen::Index>(m) * all_groups, all_groups);
      random::PhiloxEngine bits(draws, random::Source::inference_counts);
      if (tests[m] > most_one_by_one) {
        bits.seek(random::paired_index(m + 1, 0));
        add_together(shares, tests[m], bits, of_condition);
        continue;
      }
      for (std::uint64_t test = 0; test < tests[m]; ++test) {
        of_condition[group_at(shares, draws.uniform(random::Source::inference_counts, next++))] += 1.0;
      }
    }
  });
  return counts;
}

}  // namespace rocking::infer
