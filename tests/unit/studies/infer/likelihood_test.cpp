// The shares of a model, the likelihood of counts, and data sets that are made up from the shares.

#include "rocking/studies/infer/likelihood.hpp"

#include <atomic>
#include <cmath>

#include <gtest/gtest.h>

#include "rocking/base/stop_request.hpp"
#include "rocking/studies/infer/made_up_tests.hpp"
#include "support/made_up_campaign.hpp"

namespace infer_likelihood {
namespace {

using namespace rocking;
using namespace rocking::infer;
using support::SplitMix;

Eigen::VectorXd at(double x) { return Eigen::VectorXd::Constant(1, x); }

/// `counts` at equally spaced points of one unknown.
ShareModel model(const std::vector<std::vector<std::uint64_t>>& counts, const ShareModel* former = nullptr) {
  return ShareModel(Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(counts.size()), 0.0, 1.0), counts, former);
}

ShareModel flat(const std::vector<std::uint64_t>& counts) {
  return model(std::vector<std::vector<std::uint64_t>>(5, counts));
}

TEST(InferShares, FollowTheSharesOfASmoothSimulator) {
  SplitMix random(1);
  const std::vector<double> numbers = support::uniform_numbers(random, 20000);
  std::vector<std::vector<std::uint64_t>> counts;
  const auto shares_at = [](double x) { return support::made_up_shares({x}, 1, support::Dependence::sharp); };
  for (int i = 0; i <= 8; ++i) counts.push_back(support::groups_of(shares_at(i / 8.0), numbers));
  const ShareModel first = model(counts);
  for (const ShareModel& found : {first, model(counts, &first)}) {
    for (const double x : {0.0, 0.07, 0.44, 0.5, 0.93, 1.0}) {
      const Eigen::VectorXd shares = found.log_shares(at(x)).array().exp();
      EXPECT_NEAR(shares.sum(), 1.0, 1e-12);
      for (Eigen::Index g = 0; g < 3; ++g) EXPECT_NEAR(shares[g], shares_at(x)[static_cast<std::size_t>(g)], 0.02);
    }
  }
}

TEST(InferShares, OfAGroupThatNeverOccursAreSmallAndFinite) {
  const Eigen::VectorXd shares = flat({0, 200, 0}).log_shares(at(0.4)).array().exp();
  EXPECT_GT(shares[0], 1e-9);
  EXPECT_LT(shares[0] + shares[2], 1e-3);
  const Eigen::VectorXd of_one = flat({200}).log_shares(at(0.4));
  EXPECT_EQ(of_one.size(), 1);
  EXPECT_EQ(of_one[0], 0.0);
}

TEST(InferShares, AreMovedByTheirErrorAndStayShares) {
  const ShareModel shares = flat({60, 30, 10});
  const std::vector<double> none(3, 0.0);
  EXPECT_TRUE(
      shares.uncertain_shares(at(0.3)).moved(none).isApprox(shares.log_shares(at(0.3)).array().exp().matrix(), 1e-9));
  for (const double number : {-8.0, -1.0, 1.0, 8.0}) {
    const Eigen::VectorXd moved = shares.uncertain_shares(at(0.3)).moved(std::vector<double>(3, number));
    EXPECT_NEAR(moved.sum(), 1.0, 1e-12);
    EXPECT_GE(moved.minCoeff(), 0.0);
  }
  const double up = shares.uncertain_shares(at(0.3)).moved(std::vector{1.0, 0.0, 0.0})[0];
  EXPECT_NEAR(up - 0.6, std::sqrt(0.6 * 0.4 / 100.0), 0.003);
}

TEST(InferLikelihood, IsMultinomial) {
  const Counts row = in_one_row({{2, 1, 0}, {0, 0, 3}});
  EXPECT_EQ(row, (Eigen::VectorXd(6) << 2, 1, 0, 0, 0, 3).finished());
  EXPECT_NEAR(log_coefficients({{2, 1, 0}, {0, 0, 3}, {0, 0, 0}}), std::log(3.0), 1e-12);
  const std::vector<ShareModel> models{flat({60, 30, 10}), flat({20, 50, 30})};
  const Likelihood likelihood(models, Lattice({.low = at(0.0), .high = at(1.0)}));
  const double expected =
      std::log(0.6) * 2 + std::log(0.3) + std::log(0.3) * 3;  // counts of groups that are nowhere do not count
  EXPECT_NEAR(likelihood.logarithms(row)[123], expected, 0.02);
  Eigen::MatrixXd sets(6, 2);
  sets << row, 2.0 * row;
  EXPECT_NEAR(likelihood.logarithms_of_sets(sets)(123, 1), 2.0 * likelihood.logarithms(row)[123], 1e-12);
}

TEST(InferBestPoint, IsTheMiddleWhereNothingCanBeTold) {
  const Lattice lattice({.low = Eigen::VectorXd::Zero(2), .high = Eigen::VectorXd::Ones(2)});
  Eigen::VectorXd logarithms = Eigen::VectorXd::Constant(81 * 81, -5.0);
  EXPECT_EQ(lattice.point(best_point(lattice, logarithms)), Eigen::Vector2d(0.5, 0.5));
  logarithms[100] = -4.9;
  EXPECT_EQ(best_point(lattice, logarithms), 100U);
  EXPECT_NEAR(deviances(logarithms)[99], 0.2, 1e-12);
  EXPECT_EQ(deviances(logarithms)[100], 0.0);
}

TEST(MadeUpTests, HaveTheTotalsAndTheSharesOfTheirConditions) {
  const std::vector<ShareModel> models{flat({600000, 300000, 100000}), flat({0, 500000, 500000})};
  const Eigen::MatrixXd sets = made_up_tests(models, {10, 7}, at(0.2), {3, 0, 600});
  ASSERT_EQ(sets.rows(), 6);
  for (Eigen::Index set = 0; set < sets.cols(); ++set) {
    EXPECT_EQ(sets.col(set).head(3).sum(), 10.0);
    EXPECT_EQ(sets.col(set).tail(3).sum(), 7.0);
  }
  const Eigen::VectorXd means = sets.rowwise().mean();
  EXPECT_NEAR(means[0], 6.0, 0.45);
  EXPECT_NEAR(means[2], 1.0, 0.28);
  EXPECT_EQ(means[3], 0.0);
  EXPECT_NEAR(means[4], 3.5, 0.4);
  const double variance = (sets.row(0).array() - means[0]).square().mean();
  EXPECT_NEAR(variance, 10.0 * 0.6 * 0.4, 0.8);
}

TEST(MadeUpTests, OfConditionsAreIndependent) {
  const ShareModel shares = flat({500000, 500000});
  const Eigen::MatrixXd sets = made_up_tests(std::vector{shares, shares}, {10, 10}, at(0.2), {3, 0, 400});
  const double product = ((sets.row(0).array() - 5.0) * (sets.row(2).array() - 5.0)).mean();
  EXPECT_NEAR(product, 0.0, 0.8);  // the same tests: 2.5
}

TEST(MadeUpTests, HaveTheErrorOfTheRealisationsInThem) {
  const std::vector<ShareModel> models{flat({30, 20})};
  const Eigen::MatrixXd shares = made_up_tests(models, {1000}, at(0.5), {3, 0, 300}) / 1000.0;
  const double variance = (shares.row(0).array() - shares.row(0).mean()).square().mean();
  EXPECT_NEAR(variance, 0.6 * 0.4 * (1.0 / 50 + 1.0 / 1000), 0.0015);
  // Errors of four conditions may be alike.
  const Eigen::MatrixXd of_four =
      made_up_tests(std::vector(4, models[0]), {1000, 0, 0, 0}, at(0.5), {3, 0, 300}) / 1000.0;
  const double widened = (of_four.row(0).array() - of_four.row(0).mean()).square().mean();
  EXPECT_NEAR(widened, 0.6 * 0.4 * (4.0 / 50 + 1.0 / 1000), 0.006);
}

TEST(MadeUpTests, OfAMillionHaveTheirTotalsAndShares) {
  const std::vector<ShareModel> models{flat({600000, 300000, 100000}), flat({0, 500000, 500000})};
  const Eigen::MatrixXd sets = made_up_tests(models, {1000000, 101}, at(0.2), {3, 0, 50});
  for (Eigen::Index set = 0; set < sets.cols(); ++set) {
    EXPECT_EQ(sets.col(set).head(3).sum(), 1e6);
    EXPECT_EQ(sets.col(set).tail(3).sum(), 101.0);
    // The variance of a share is that of the tests and, widened for two conditions, that of the realisations.
    EXPECT_NEAR(sets(0, set), 6e5, 6.0 * std::sqrt(3e6 * 0.6 * 0.4));
    EXPECT_NEAR(sets(2, set), 1e5, 6.0 * std::sqrt(3e6 * 0.1 * 0.9));
  }
  EXPECT_NE(sets(0, 0), sets(0, 1));
}

TEST(MadeUpTests, StopWhenTheyAreAskedTo) {
  const std::vector<ShareModel> models{flat({30, 20})};
  std::atomic<bool> stop = false;
  int sets = 0;
  const auto count = [&] { stop = ++sets == 3; };
  EXPECT_THROW(static_cast<void>(made_up_tests(models, {1000}, at(0.5), {3, 0, 300},
                                               {.stop = base::StopRequest(&stop), .on_part = count})),
               base::Stopped);
  EXPECT_EQ(sets, 3);
}

TEST(InferLikelihood, StopsWhenItIsAskedTo) {
  const std::vector<ShareModel> models{flat({30, 20})};
  const std::vector<std::vector<std::uint64_t>> counts(5, {30, 20});
  std::atomic<bool> stop = false;
  const base::StopRequest asked(&stop);
  const Likelihood likelihood(models, Lattice({.low = at(0.0), .high = at(1.0)}), {.stop = asked});
  stop = true;
  EXPECT_THROW(static_cast<void>(likelihood.logarithms_of_sets(Eigen::MatrixXd::Zero(2, 5))), base::Stopped);
  EXPECT_THROW(Likelihood(models, likelihood.lattice(), {.stop = asked}), base::Stopped);
  EXPECT_THROW(ShareModel(Eigen::VectorXd::LinSpaced(5, 0.0, 1.0), counts, nullptr, asked), base::Stopped);
}

TEST(MadeUpTests, DependOnTheNumberOfTheirSet) {
  const std::vector<ShareModel> models{flat({30, 20, 50})};
  const Eigen::MatrixXd all = made_up_tests(models, {20}, at(0.5), {3, 0, 6});
  EXPECT_EQ(made_up_tests(models, {20}, at(0.5), {3, 4, 2}), all.rightCols(2));
  EXPECT_NE(all.col(0), all.col(1));
  EXPECT_NE(made_up_tests(models, {20}, at(0.5), {4, 0, 6}), all);
  EXPECT_EQ(made_up_tests(models, {0}, at(0.5), {3, 0, 2}), Eigen::MatrixXd::Zero(3, 2));
}

}  // namespace
}  // namespace infer_likelihood
