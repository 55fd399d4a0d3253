// A probability as a smooth function of a point: against an independent computation by inverse matrices, and where
// counts are extreme.

#include "rocking/stats/binomial_process.hpp"

#include <cmath>

#include <Eigen/LU>
#include <gtest/gtest.h>

namespace binomial_process {
namespace {

using rocking::stats::BinomialProcess;
using rocking::stats::LogOdds;
using rocking::stats::ProcessScales;
using rocking::stats::Proportion;

Eigen::MatrixXd places(int n) { return Eigen::VectorXd::LinSpaced(n, 0.0, 1.0); }

Eigen::VectorXd place(double x) { return Eigen::VectorXd::Constant(1, x); }

double share(double log_odds) { return 1.0 / (1.0 + std::exp(-log_odds)); }

double smooth_part(const ProcessScales& scales, double from, double to) {
  const double r = std::sqrt(5.0) * std::abs(from - to) / scales.lengths[0];
  return 100.0 + std::pow(scales.amplitude, 2) * (1.0 + r + r * r / 3.0) * std::exp(-r);
}

/// Rasmussen & Williams, equations 3.17 to 3.32 with K^-1 written out.
struct Reference {
  Eigen::VectorXd x;
  Eigen::VectorXd successes;
  Eigen::VectorXd trials;
  ProcessScales scales;
  Eigen::MatrixXd k = {};
  Eigen::VectorXd f = {};
  Eigen::VectorXd w = {};

  void solve() {
    const Eigen::Index n = x.size();
    k.resize(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) {
        k(i, j) = smooth_part(scales, x[i], x[j]) + (i == j ? std::pow(scales.roughness, 2) : 0.0);
      }
    }
    f = Eigen::VectorXd::Zero(n);
    for (int step = 0; step < 200; ++step) {
      const Eigen::VectorXd p = f.unaryExpr(&share);
      w = trials.array() * p.array() * (1.0 - p.array());
      Eigen::MatrixXd curvature = k.inverse();
      const Eigen::VectorXd slope = successes - trials.cwiseProduct(p) - curvature * f;
      curvature += w.asDiagonal();
      Eigen::VectorXd move = curvature.inverse() * slope;
      move *= std::min(1.0, 1.0 / move.cwiseAbs().maxCoeff());
      f += move;
    }
  }

  [[nodiscard]] LogOdds at(double point) const {
    Eigen::VectorXd between(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) between[i] = smooth_part(scales, point, x[i]);
    Eigen::MatrixXd spread = k;
    spread.diagonal() += w.cwiseInverse();
    const double all = smooth_part(scales, 0.0, 0.0) + std::pow(scales.roughness, 2);
    return {.mean = between.dot(k.inverse() * f),
            .deviation = std::sqrt(all - between.dot(spread.inverse() * between))};
  }

  [[nodiscard]] double log_evidence() const {
    double sum = -0.5 * f.dot(k.inverse() * f);
    for (Eigen::Index i = 0; i < x.size(); ++i) sum += successes[i] * f[i] - trials[i] * std::log1p(std::exp(f[i]));
    return sum - 0.5 * std::log((Eigen::MatrixXd::Identity(x.size(), x.size()) + k * w.asDiagonal()).determinant());
  }
};

double log_prior(const ProcessScales& scales) {
  return -0.5 * (std::pow(std::log(scales.lengths[0] / 0.5), 2) + std::pow(std::log(scales.amplitude / 2.0), 2) +
                 std::pow(std::log(scales.roughness / 0.05) / 1.5, 2));
}

const std::vector<Proportion> rising{{3, 60}, {9, 60}, {14, 60}, {31, 60}, {50, 60}};

Reference reference(const ProcessScales& scales) {
  Reference reference{.x = places(5), .successes = Eigen::VectorXd(5), .trials = Eigen::VectorXd(5), .scales = scales};
  for (Eigen::Index i = 0; i < 5; ++i) {
    reference.successes[i] = static_cast<double>(rising[static_cast<std::size_t>(i)].successes);
    reference.trials[i] = static_cast<double>(rising[static_cast<std::size_t>(i)].trials);
  }
  reference.solve();
  return reference;
}

TEST(BinomialProcess, HasTheModeAndTheErrorOfAnIndependentComputation) {
  const BinomialProcess process = BinomialProcess::fit(places(5), rising);
  const Reference expected = reference(process.scales());
  for (const double x : {0.0, 0.1, 0.5, 0.77, 1.0}) {
    EXPECT_NEAR(process.at(place(x)).mean, expected.at(x).mean, 1e-6) << x;
    EXPECT_NEAR(process.mean_at(place(x)), expected.at(x).mean, 1e-6) << x;
    EXPECT_NEAR(process.at(place(x)).deviation, expected.at(x).deviation, 1e-6) << x;
  }
}

TEST(BinomialProcess, HasTheScalesOfTheLargestEvidence) {
  const ProcessScales scales = BinomialProcess::fit(places(5), rising).scales();
  const double found = reference(scales).log_evidence() + log_prior(scales);
  for (const double factor : {std::exp(-0.8), std::exp(-0.2), std::exp(0.2), std::exp(0.8)}) {
    for (int which = 0; which < 3; ++which) {
      ProcessScales other = scales;
      (which == 0 ? other.lengths[0] : which == 1 ? other.amplitude : other.roughness) *= factor;
      EXPECT_LT(reference(other).log_evidence() + log_prior(other), found + 0.0101) << which << ' ' << factor;
    }
  }
}

TEST(BinomialProcess, GoesThroughTheSharesOfManyTrials) {
  const std::vector<double> shares{0.9, 0.5, 0.2, 0.3, 0.7, 0.99};
  std::vector<Proportion> counts;
  for (const double p : shares) counts.push_back({static_cast<std::uint64_t>(std::lround(1e7 * p)), 10000000});
  const BinomialProcess process = BinomialProcess::fit(places(6), counts);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    EXPECT_NEAR(share(process.mean_at(place(0.2 * static_cast<double>(i)))), shares[i], 0.01) << i;
  }
}

TEST(BinomialProcess, OfEqualSharesIsFlat) {
  const BinomialProcess process = BinomialProcess::fit(places(7), std::vector<Proportion>(7, {120, 400}));
  for (const double x : {0.0, 0.08, 0.5, 1.0}) EXPECT_NEAR(share(process.mean_at(place(x))), 0.3, 0.001) << x;
  EXPECT_LT(process.at(place(0.08)).deviation, 0.1);
}

TEST(BinomialProcess, KnowsLittleFarFromItsPoints) {
  const BinomialProcess process = BinomialProcess::fit(places(5), rising);
  EXPECT_GT(process.at(place(3.0)).deviation, 3.0 * process.at(place(0.5)).deviation);
  EXPECT_TRUE(std::isfinite(process.at(place(100.0)).mean));
}

TEST(BinomialProcess, OfCountsThatAreNoneOrAllIsFiniteAndFarOut) {
  const BinomialProcess none = BinomialProcess::fit(places(6), std::vector<Proportion>(6, {0, 500}));
  const BinomialProcess all = BinomialProcess::fit(places(6), std::vector<Proportion>(6, {500, 500}));
  for (const double x : {0.0, 0.3, 1.0}) {
    EXPECT_LT(share(none.mean_at(place(x))), 1.0 / 3000.0);
    EXPECT_GT(share(none.mean_at(place(x))), 1e-7);
    EXPECT_NEAR(all.mean_at(place(x)), -none.mean_at(place(x)), 1e-6);
  }
  const BinomialProcess step = BinomialProcess::fit(places(4), {{0, 500}, {0, 500}, {500, 500}, {500, 500}});
  EXPECT_LT(share(step.mean_at(place(0.0))), 0.01);
  EXPECT_GT(share(step.mean_at(place(1.0))), 0.99);
}

TEST(BinomialProcess, TakesPointsWithoutTrialsAndPointsThatAreTheSame) {
  Eigen::MatrixXd points(4, 1);
  points << 0.0, 0.5, 0.5, 1.0;
  const BinomialProcess process = BinomialProcess::fit(points, {{20, 100}, {50, 100}, {50, 100}, {0, 0}});
  EXPECT_NEAR(share(process.mean_at(place(0.5))), 0.5, 0.03);
  EXPECT_GT(process.at(place(1.0)).deviation, process.at(place(0.5)).deviation);
  const BinomialProcess empty = BinomialProcess::fit(points, std::vector<Proportion>(4));
  EXPECT_NEAR(empty.mean_at(place(0.3)), 0.0, 1e-9);
}

TEST(BinomialProcess, FindsTheCoordinateThatMatters) {
  Eigen::MatrixXd points(9, 2);
  std::vector<Proportion> counts;
  for (int i = 0; i < 9; ++i) {
    points.row(i) << 0.5 * (i % 3), 0.5 * (i / 3);
    counts.push_back({static_cast<std::uint64_t>(20 + 80 * (i % 3)), 200});
  }
  const BinomialProcess process = BinomialProcess::fit(points, counts);
  EXPECT_GT(process.scales().lengths[1], process.scales().lengths[0]);
  EXPECT_NEAR(process.mean_at(Eigen::Vector2d(1.0, 0.25)), process.mean_at(Eigen::Vector2d(1.0, 0.75)), 0.05);
}

}  // namespace
}  // namespace binomial_process
