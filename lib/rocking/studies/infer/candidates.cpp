#include "rocking/studies/infer/posterior.hpp"

#include "rocking/random/draws.hpp"
#include "rocking/studies/infer/made_up_tests.hpp"

namespace rocking::infer {
namespace {

constexpr std::uint64_t candidate_sets = std::uint64_t{1} << 40U;

double entropy(const Eigen::VectorXd& weights) {
  double sum = 0.0;
  for (const double weight : weights) {
    if (weight > 0.0) sum -= weight * std::log(weight);
  }
  return sum;
}

/// Of each coordinate; a row of `points` for each weight.
Eigen::VectorXd deviations(const Eigen::MatrixXd& points, const Eigen::VectorXd& weights) {
  const Eigen::RowVectorXd mean = weights.transpose() * points;
  return ((points.rowwise() - mean).cwiseAbs2().transpose() * weights).cwiseSqrt();
}

/// Points of a lattice that have nearly all the weight.
struct Support {
  Eigen::MatrixXd points;
  Eigen::MatrixXd log_shares;
  Eigen::VectorXd weights;
};

Support support_of(const ShareModel& candidate, const Lattice& lattice, const Eigen::VectorXd& all_weights,
                   base::StopRequest stop) {
  const double least = 1e-6 * all_weights.maxCoeff();
  const Eigen::Index n = (all_weights.array() >= least).count();
  Support support{.points = Eigen::MatrixXd(n, static_cast<Eigen::Index>(lattice.axes())),
                  .log_shares = Eigen::MatrixXd(n, static_cast<Eigen::Index>(candidate.groups())),
                  .weights = Eigen::VectorXd(n)};
  Eigen::Index row = 0;
  for (Eigen::Index i = 0; i < all_weights.size(); ++i) {
    if (all_weights[i] < least) continue;
    stop.check();
    const Eigen::VectorXd point = lattice.point(static_cast<std::size_t>(i));
    support.points.row(row) = point.transpose();
    support.log_shares.row(row) = candidate.log_shares(point).transpose();
    support.weights[row++] = all_weights[i];
  }
  support.weights /= support.weights.sum();
  return support;
}

/// The place at which the sum of the weights exceeds `u`.
Eigen::Index place_at(const Eigen::VectorXd& weights, double u) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i + 1 < weights.size(); ++i) {
    sum += weights[i];
    if (u < sum) return i;
  }
  return weights.size() - 1;
}

}  // namespace

CandidateGain gain_of(const ShareModel& candidate, std::uint64_t tests, const Posterior& posterior, std::uint64_t seed,
                      const base::ManyParts& how) {
  constexpr std::size_t truths = sets_of_candidate;
  const Support support = support_of(candidate, posterior.lattice, posterior.weights, how.stop);
  const Eigen::VectorXd present = deviations(support.points, support.weights);
  double entropies = 0.0;
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(present.size());
  for (std::size_t truth = 0; truth < truths; ++truth) {
    const std::uint64_t set = candidate_sets + truth;
    const double u = random::Draws(seed, set).uniform(random::Source::inference_counts, tests);
    const Eigen::VectorXd point = support.points.row(place_at(support.weights, u)).transpose();
    const Eigen::VectorXd counts = made_up_tests({&candidate, 1}, {tests}, point, {seed, set, 1}, how);
    Eigen::VectorXd logarithms = support.log_shares * counts;
    logarithms.array() -= logarithms.maxCoeff();
    Eigen::VectorXd after = support.weights.cwiseProduct(logarithms.array().exp().matrix());
    after /= after.sum();
    entropies += entropy(after);
    expected += deviations(support.points, after);
  }
  CandidateGain gain{.region = std::exp(entropies / truths - entropy(support.weights)), .deviations = {}};
  for (Eigen::Index axis = 0; axis < present.size(); ++axis) {
    gain.deviations.push_back(present[axis] > 0.0 ? expected[axis] / truths / present[axis] : 1.0);
  }
  return gain;
}

}  // namespace rocking::infer
