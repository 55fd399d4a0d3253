// Lattices and windows, and the points of a design.

#include "rocking/studies/infer/lattice.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "rocking/studies/infer/survey.hpp"

namespace infer_lattice {
namespace {

using namespace rocking;
using namespace rocking::infer;

Lattice whole(Eigen::Index axes) {
  return Lattice({.low = Eigen::VectorXd::Zero(axes), .high = Eigen::VectorXd::Ones(axes)});
}

TEST(InferLattice, HasItsPlacesInTheOrderThatItSays) {
  EXPECT_EQ(whole(1).size(), 401U);
  EXPECT_EQ(whole(2).size(), 81U * 81U);
  const Lattice lattice = whole(3);
  EXPECT_EQ(lattice.size(), 25U * 25U * 25U);
  const std::size_t index = (5 * 25 + 24) * 25 + 7;
  EXPECT_EQ(lattice.place(index, 0), 5U);
  EXPECT_EQ(lattice.place(index, 1), 24U);
  EXPECT_EQ(lattice.place(index, 2), 7U);
  EXPECT_EQ(lattice.point(index), Eigen::Vector3d(5.0 / 24.0, 1.0, 7.0 / 24.0));
}

TEST(InferLattice, EndsExactlyWhereItsWindowEnds) {
  for (int i = 0; i < 400; ++i) {
    const double low = i / 401.0;
    for (const double high : {low + 0.1, 1.0}) {
      const Lattice lattice({.low = Eigen::VectorXd::Constant(1, low), .high = Eigen::VectorXd::Constant(1, high)});
      EXPECT_EQ(lattice.coordinate(0, 0), low);
      EXPECT_EQ(lattice.coordinate(lattice.points_on_axis() - 1, 0), high);
    }
  }
}

TEST(InferLattice, OfAPartEndsExactlyOnTheRangeOfTheUnknown) {
  const std::vector<Unknown> unknowns{{.pointer = "/x", .from = 0.1, .to = 0.7}};
  const Scale scale(unknowns);
  EXPECT_EQ(scale.value(0, 0.0), 0.1);
  EXPECT_EQ(scale.value(0, 1.0), 0.7);
  EXPECT_NEAR(scale.point(scale.values(Eigen::VectorXd::Constant(1, 0.37)))[0], 0.37, 1e-15);
  EXPECT_EQ(scale.short_values(Eigen::VectorXd::Constant(1, 1.0 / 3.0)), (std::vector<double>{0.3}));
  EXPECT_EQ(scale.short_values(Eigen::VectorXd::Constant(1, 0.5555555555)), (std::vector<double>{0.433333}));
}

TEST(InferWindow, HasOnePlaceMoreOnEachSideButStaysInTheCube) {
  const Lattice lattice = whole(2);
  const Window window = window_around(lattice, [&](std::size_t i) {
    return lattice.place(i, 0) <= 2 && lattice.place(i, 1) >= 40 && lattice.place(i, 1) <= 50;
  });
  EXPECT_EQ(window.low, Eigen::Vector2d(0.0, 39.0 / 80.0));
  EXPECT_EQ(window.high, Eigen::Vector2d(3.0 / 80.0, 51.0 / 80.0));
  const Window one = window_around(lattice, [&](std::size_t i) { return i + 1 == lattice.size(); });
  EXPECT_EQ(one.low, Eigen::Vector2d(79.0 / 80.0, 79.0 / 80.0));
  EXPECT_EQ(one.high, Eigen::Vector2d(1.0, 1.0));
}

double least_distance(const std::vector<Eigen::VectorXd>& points) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, (points[i] - points[j]).norm());
  }
  return least;
}

TEST(InferDesign, BeginsWithDifferentPointsOfTheCube) {
  const std::vector<std::size_t> sizes{0, 12, 32, 56};
  for (std::size_t unknowns = 1; unknowns <= 3; ++unknowns) {
    const auto design = first_design(unknowns);
    EXPECT_EQ(design.size(), sizes[unknowns]);
    EXPECT_GT(least_distance(design), unknowns == 1 ? 0.03 : 0.05);
    for (const Eigen::VectorXd& point : design) {
      EXPECT_GE(point.minCoeff(), 0.0);
      EXPECT_LE(point.maxCoeff(), 1.0);
    }
  }
}

TEST(InferDesign, IsExtendedWhereTheLikelihoodIsHigh) {
  const Lattice lattice = whole(1);
  Eigen::VectorXd deviances(401);
  for (Eigen::Index i = 0; i < 401; ++i) {
    deviances[i] = std::pow((lattice.point(static_cast<std::size_t>(i))[0] - 0.3) / 0.02, 2);
  }
  auto design = first_design(1);
  const auto added = further_points(design, lattice, deviances);
  ASSERT_EQ(added.size(), 4U);
  for (const Eigen::VectorXd& point : added) EXPECT_NEAR(point[0], 0.3, 0.1);
  design.insert(design.end(), added.begin(), added.end());
  EXPECT_GT(least_distance(design), 0.002);
}

TEST(InferDesign, IsExtendedEvenlyWhereNothingCanBeTold) {
  const Lattice lattice = whole(1);
  std::vector<Eigen::VectorXd> design{Eigen::VectorXd::Zero(1), Eigen::VectorXd::Ones(1)};
  const auto added = further_points(design, lattice, Eigen::VectorXd::Zero(401));
  EXPECT_EQ(added[0][0], 0.5);
  EXPECT_EQ(added[1][0], 0.25);
  EXPECT_EQ(added[2][0], 0.75);
}

TEST(InferDesign, NeverHasMoreThanItsLargestNumberOfPoints) {
  const Lattice lattice = whole(1);
  std::vector<Eigen::VectorXd> design;
  for (int i = 0; i < 58; ++i) design.push_back(Eigen::VectorXd::Constant(1, i / 100.0));
  EXPECT_EQ(most_points(1), 60U);
  EXPECT_EQ(further_points(design, lattice, Eigen::VectorXd::Zero(401)).size(), 2U);
}

}  // namespace
}  // namespace infer_lattice
