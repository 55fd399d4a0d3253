// Densities of priors, posterior laws, and what further tests are expected to gain.

#include "rocking/studies/infer/posterior.hpp"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "rocking/base/error.hpp"

namespace infer_posterior {
namespace {

using namespace rocking;
using namespace rocking::infer;

constexpr double impossible = -std::numeric_limits<double>::infinity();

TEST(InferPrior, HasTheLogarithmOfTheDensityUpToAConstant) {
  const auto ratio = [](const Quantity& law, double value, double other) {
    return std::exp(log_density(law, value) - log_density(law, other));
  };
  EXPECT_NEAR(ratio(Normal{.mean = 2.0, .sigma = 0.5}, 3.0, 2.0), std::exp(-2.0), 1e-12);
  EXPECT_EQ(log_density(Normal{.mean = 2.0, .sigma = 0.5, .between = Reach{1.5, 2.5}}, 2.6), impossible);
  EXPECT_EQ(ratio(Uniform{.low = 1.0, .high = 3.0}, 1.2, 2.9), 1.0);
  EXPECT_EQ(log_density(Uniform{.low = 1.0, .high = 3.0}, 3.1), impossible);
  const Triangular triangular{.low = 0.0, .mode = 1.0, .high = 3.0};
  EXPECT_NEAR(ratio(triangular, 0.25, 1.0), 0.25, 1e-12);
  EXPECT_NEAR(ratio(triangular, 2.0, 1.0), 0.5, 1e-12);
  EXPECT_EQ(log_density(triangular, -0.1), impossible);
  // ln x is normal with variance ln(1 + 0.25) and mean ln 2 - variance/2.
  const double variance = std::log(1.25);
  const double middle = std::log(2.0) - 0.5 * variance;
  const auto density = [&](double x) { return std::exp(-0.5 * std::pow(std::log(x) - middle, 2) / variance) / x; };
  EXPECT_NEAR(ratio(Lognormal{.mean = 2.0, .sigma = 1.0}, 3.0, 1.0), density(3.0) / density(1.0), 1e-12);
  EXPECT_EQ(log_density(Lognormal{.mean = 2.0, .sigma = 1.0}, 0.0), impossible);
}

TEST(InferPrior, IsRefusedWithoutADensityOrBesideTheRange) {
  EXPECT_THROW(static_cast<void>(log_density(Quantity(1.0), 1.0)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(log_density(Values{.values = {1.0, 2.0}}, 1.0)), std::invalid_argument);
  const auto complaint_about = [](const Quantity& prior) {
    try {
      static_cast<void>(
          reach_of_priors({{.pointer = "/y"}, {.pointer = "/x", .from = 0.0, .to = 1.0, .prior = prior}}));
    } catch (const base::InputError& error) {
      return error.problems().front().place + ' ' + error.problems().front().reason;
    }
    return std::string();
  };
  const char* const refused = "/unknown/1/prior has no weight between 0 and 1, the range of the unknown";
  EXPECT_EQ(complaint_about(Uniform{.low = 1.5, .high = 2.0}), refused);
  EXPECT_EQ(complaint_about(Normal{.mean = 9.0, .sigma = 0.01}), refused);
  EXPECT_EQ(complaint_about(Normal{.mean = 0.5, .sigma = 0.0}), refused) << "its density is that of one value";
  EXPECT_EQ(complaint_about(Lognormal{.mean = 0.5, .sigma = 0.0}), refused);
  EXPECT_EQ(complaint_about(Normal{.mean = 0.5, .sigma = 1e-6}), "");
}

Eigen::MatrixXd grid(Eigen::Index axes) {
  Eigen::MatrixXd points(1 << axes, axes);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (Eigen::Index axis = 0; axis < axes; ++axis) points(i, axis) = static_cast<double>((i >> axis) & 1);
  }
  return points;
}

/// Shares that are the same everywhere.
std::vector<ShareModel> flat(Eigen::Index axes) {
  return {ShareModel(grid(axes), std::vector<std::vector<std::uint64_t>>(1U << axes, {500, 500}), nullptr)};
}

UnknownPosterior of_first(const std::vector<Unknown>& unknowns) {
  const auto models = flat(static_cast<Eigen::Index>(unknowns.size()));
  const Counts counts = Eigen::Vector2d(3.0, 2.0);
  return summary(posterior_of(models, counts, unknowns, survey(models, counts)), unknowns, 0, 0.95);
}

TEST(InferPosterior, IsThePriorWhereNothingCanBeTold) {
  const auto uniform =
      of_first({{.pointer = "/x", .from = 2.0, .to = 3.0, .prior = Quantity(Uniform{2.0, 3.0})}, {.pointer = "/y"}});
  EXPECT_NEAR(uniform.mean, 2.5, 1e-3);
  EXPECT_NEAR(uniform.interval.low, 2.025, 1e-3);
  EXPECT_NEAR(uniform.interval.high, 2.975, 1e-3);
  const auto normal = of_first({{.pointer = "/x", .from = 0.0, .to = 10.0, .prior = Quantity(Normal{4.0, 0.5})}});
  EXPECT_NEAR(normal.median, 4.0, 0.002);
  EXPECT_NEAR(normal.interval.low, 4.0 - 1.96 * 0.5, 0.005);
  EXPECT_NEAR(normal.interval.high, 4.0 + 1.96 * 0.5, 0.005);
}

TEST(InferPosterior, FollowsAPriorThatIsNarrowerThanTheLatticeOfTheRange) {
  const auto narrow = of_first(
      {{.pointer = "/x", .from = 0.0, .to = 1.0, .prior = Quantity(Normal{0.31234, 1e-4})}, {.pointer = "/y"}});
  EXPECT_NEAR(narrow.mean, 0.31234, 1e-6);
  EXPECT_NEAR(narrow.interval.high - narrow.interval.low, 2.0 * 1.96e-4, 1e-5);
  const auto thin = of_first(
      {{.pointer = "/x", .from = 0.0, .to = 1.0, .prior = Quantity(Uniform{0.3001, 0.3002})}, {.pointer = "/y"}});
  EXPECT_NEAR(thin.interval.low, 0.3001025, 1e-6);
  EXPECT_NEAR(thin.interval.high, 0.3001975, 1e-6);
}

/// All points of [0, 1] weigh the same.
Posterior even() {
  const Lattice lattice({.low = Eigen::VectorXd::Zero(1), .high = Eigen::VectorXd::Ones(1)});
  return {.lattice = lattice, .weights = Eigen::VectorXd::Constant(401, 1.0 / 401.0)};
}

ShareModel candidate(const std::vector<std::uint64_t>& first) {
  std::vector<std::vector<std::uint64_t>> counts;
  for (const std::uint64_t count : first) counts.push_back({count, 1000 - count});
  return ShareModel(Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(first.size()), 0.0, 1.0), counts, nullptr);
}

TEST(CandidateGain, IsNoneWhereTheSharesAreTheSame) {
  const CandidateGain gain = gain_of(candidate(std::vector<std::uint64_t>(6, 300)), 5, even(), 1);
  EXPECT_NEAR(gain.region, 1.0, 1e-3);
  EXPECT_NEAR(gain.deviations.at(0), 1.0, 1e-3);
}

TEST(CandidateGain, OfATestThatTellsTheHalfIsAHalf) {
  const CandidateGain gain = gain_of(candidate({0, 0, 0, 0, 0, 1000, 1000, 1000, 1000, 1000}), 1, even(), 1);
  EXPECT_NEAR(gain.region, 0.53, 0.06);
  EXPECT_NEAR(gain.deviations.at(0), 0.53, 0.06);
}

TEST(CandidateGain, IsThatOfTheSumOverAllOutcomes) {
  const ShareModel smooth = candidate({100, 180, 300, 500, 700, 820, 900});
  const Posterior before = even();
  Eigen::VectorXd first(401);
  for (std::size_t i = 0; i < 401; ++i) {
    first[static_cast<Eigen::Index>(i)] = std::exp(smooth.log_shares(before.lattice.point(i))[0]);
  }
  const auto entropy = [](const Eigen::VectorXd& w) { return -(w.array() * (w.array() + 1e-300).log()).sum(); };
  double expected = 0.0;
  const std::vector<double> ways{1.0, 3.0, 3.0, 1.0};
  for (int outcome = 0; outcome <= 3; ++outcome) {
    const Eigen::VectorXd joint =
        before.weights.array() * first.array().pow(outcome) * (1.0 - first.array()).pow(3 - outcome);
    expected += ways[static_cast<std::size_t>(outcome)] * joint.sum() * entropy(joint / joint.sum());
  }
  EXPECT_NEAR(gain_of(smooth, 3, before, 1).region, std::exp(expected - entropy(before.weights)), 0.05);
}

TEST(CandidateGain, GrowsWithTheTests) {
  const ShareModel smooth = candidate({100, 180, 300, 500, 700, 820, 900});
  EXPECT_LT(gain_of(smooth, 40, even(), 1).region, 0.7 * gain_of(smooth, 5, even(), 1).region);
}

}  // namespace
}  // namespace infer_posterior
