// Profiles, intervals, and the limits that made-up data sets give them.

#include "rocking/studies/infer/profile.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "rocking/studies/infer/made_up_tests.hpp"

namespace infer_profile {
namespace {

using namespace rocking;
using namespace rocking::infer;

Lattice between(double low, double high, Eigen::Index axes = 1) {
  return Lattice({.low = Eigen::VectorXd::Constant(axes, low), .high = Eigen::VectorXd::Constant(axes, high)});
}

Eigen::VectorXd on(const Lattice& lattice, const std::function<double(const Eigen::VectorXd&)>& value) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(lattice.size()));
  for (std::size_t i = 0; i < lattice.size(); ++i) values[static_cast<Eigen::Index>(i)] = value(lattice.point(i));
  return values;
}

stats::Interval interval(const Lattice& lattice, double middle, double deviation) {
  const Eigen::VectorXd parabola =
      on(lattice, [&](const Eigen::VectorXd& x) { return std::pow((x[0] - middle) / deviation, 2); });
  return interval_below(lattice, 0, profile_on(lattice, 0, parabola), Eigen::VectorXd::Constant(401, 4.0));
}

TEST(InferProfile, OfATiltedParabolaIsThatOfItsLeastValues) {
  const Lattice lattice = between(0.0, 1.0, 2);
  // The least over y of (x - 0.5)^2 + 4 (y - x)^2 is (x - 0.5)^2; the least over x is 0.8 (y - 0.5)^2.
  const Eigen::VectorXd deviances =
      on(lattice, [](const Eigen::VectorXd& p) { return std::pow(p[0] - 0.5, 2) + 4.0 * std::pow(p[1] - p[0], 2); });
  const Eigen::VectorXd of_x = profile_on(lattice, 0, deviances);
  const Eigen::VectorXd of_y = profile_on(lattice, 1, deviances);
  for (Eigen::Index i = 0; i <= 80; ++i) {
    const double squares = std::pow(static_cast<double>(i) / 80.0 - 0.5, 2);
    EXPECT_NEAR(of_x[i], squares, 1e-12);
    EXPECT_NEAR(of_y[i], 0.8 * squares, 0.0004);
  }
}

TEST(InferInterval, OfAParabolaIsItsRoots) {
  const stats::Interval inside = interval(between(0.0, 1.0), 0.4, 0.1);
  EXPECT_NEAR(inside.low, 0.2, 1e-4);
  EXPECT_NEAR(inside.high, 0.6, 1e-4);
  const stats::Interval of_part = interval(between(0.1, 0.8), 0.4, 0.1);
  EXPECT_NEAR(of_part.low, 0.2, 1e-4);
  EXPECT_NEAR(of_part.high, 0.6, 1e-4);
}

TEST(InferInterval, EndsExactlyOnABound) {
  const stats::Interval low = interval(between(0.0, 1.0), 0.1, 0.1);
  EXPECT_EQ(low.low, 0.0);
  EXPECT_NEAR(low.high, 0.3, 1e-4);
  EXPECT_EQ(interval(between(0.7, 1.0), 0.95, 0.1).high, 1.0);
  EXPECT_EQ(interval(between(0.0, 1.0), 0.5, 10.0).low, 0.0);
  EXPECT_EQ(interval(between(0.0, 1.0), 0.5, 10.0).high, 1.0);
}

TEST(InferInterval, ContainsBothPartsOfTwo) {
  const Lattice lattice = between(0.0, 1.0);
  const Eigen::VectorXd two = on(lattice, [](const Eigen::VectorXd& x) {
    return std::min(std::pow((x[0] - 0.2) / 0.05, 2), std::pow((x[0] - 0.8) / 0.05, 2));
  });
  const stats::Interval inside = interval_below(lattice, 0, two, Eigen::VectorXd::Constant(401, 1.0));
  EXPECT_NEAR(inside.low, 0.15, 1e-3);
  EXPECT_NEAR(inside.high, 0.85, 1e-3);
}

/// Two groups; the log-odds of the first rise from -2 to 2.
ShareModel rising(std::uint64_t realisations) {
  Eigen::MatrixXd points(9, 1);
  std::vector<std::vector<std::uint64_t>> counts;
  for (int i = 0; i < 9; ++i) {
    points(i, 0) = i / 8.0;
    const double share = 1.0 / (1.0 + std::exp(2.0 - i / 2.0));
    const auto first = static_cast<std::uint64_t>(std::lround(share * static_cast<double>(realisations)));
    counts.push_back({first, realisations - first});
  }
  return ShareModel(points, counts, nullptr);
}

TEST(InferLimits, AreThoseOfChiSquareWithinAndOfABoundOnTheBounds) {
  const std::vector<ShareModel> models{rising(1000000)};
  const Likelihood likelihood(models, between(0.0, 1.0));
  const std::uint64_t tests = 400;
  const Eigen::VectorXd deviances_of = deviances(likelihood.logarithms(Eigen::Vector2d(200.0, 200.0)));
  const Eigen::VectorXd limits = profile_limits(
      likelihood, 0, deviances_of,
      [&](const Eigen::VectorXd& point) {
        return made_up_tests(models, {tests}, point, {5, 0, 399});
      },
      0.95);
  EXPECT_NEAR(limits.segment(100, 201).mean(), 3.84, 1.3);
  EXPECT_NEAR(limits[0], 2.71, 1.0);
  EXPECT_NEAR(limits[400], 2.71, 1.0);
  EXPECT_GE(limits.minCoeff(), 2.705);
  EXPECT_NEAR(limits[5], limits[0] + 0.25 * (limits[20] - limits[0]), 1e-12);
}

TEST(InferLimits, AreWiderWithFewRealisations) {
  const std::vector<ShareModel> models{rising(100)};
  const Likelihood likelihood(models, between(0.0, 1.0));
  const Eigen::VectorXd middle = Eigen::VectorXd::Constant(1, 0.5);
  const auto limit = [&](std::uint64_t tests) {
    const Eigen::MatrixXd sets = made_up_tests(models, {tests}, middle, {5, 0, 399});
    return region_limit(likelihood.logarithms_of_sets(sets), 200, 0.95);
  };
  EXPECT_LT(limit(10), 6.5);
  EXPECT_NEAR(limit(400), 3.84 * (1.0 + 400.0 / 100.0), 7.0);
}

TEST(InferLimits, ExistAtAnyConfidence) {
  const Eigen::MatrixXd logarithms = Eigen::MatrixXd::Zero(401, 20);
  EXPECT_EQ(region_limit(logarithms, 7, 0.2), 0.0);
  EXPECT_NEAR(region_limit(logarithms, 7, 0.95), 2.7055, 1e-4);
}

}  // namespace
}  // namespace infer_profile
