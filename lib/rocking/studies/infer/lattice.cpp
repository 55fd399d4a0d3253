#include "rocking/studies/infer/lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <boost/random/sobol.hpp>

namespace rocking::infer {

Lattice::Lattice(Window window) : window_(std::move(window)), strides_(axes()) {
  constexpr std::array<std::size_t, 4> on_axis{0, 401, 81, 25};
  points_on_axis_ = on_axis.at(axes());
  for (std::size_t axis = axes(); axis-- > 0;) {
    strides_[axis] = size_;
    size_ *= points_on_axis_;
  }
}

Eigen::VectorXd Lattice::point(std::size_t index) const {
  Eigen::VectorXd point(window_.low.size());
  for (Eigen::Index axis = 0; axis < point.size(); ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    point[axis] = coordinate(place(index, a), a);
  }
  return point;
}

double Lattice::coordinate(std::size_t place, std::size_t axis) const {
  const auto a = static_cast<Eigen::Index>(axis);
  const double part = static_cast<double>(place) / static_cast<double>(points_on_axis_ - 1);
  return std::lerp(window_.low[a], window_.high[a], part);
}

namespace {

struct Sizes {
  std::size_t of_sequence;  ///< points of the first design within the cube
  std::size_t added;        ///< at once
  std::size_t most;
};
constexpr std::array<Sizes, 4> sizes_of{{{}, {10, 4, 60}, {28, 8, 160}, {48, 12, 300}}};

double distance_to(const std::vector<Eigen::VectorXd>& design, const Eigen::VectorXd& point,
                   const Eigen::VectorXd& unit) {
  double least = std::numeric_limits<double>::infinity();
  for (const Eigen::VectorXd& other : design) {
    least = std::min(least, (other - point).cwiseQuotient(unit).norm());
  }
  return least;
}

}  // namespace

std::vector<Eigen::VectorXd> first_design(std::size_t unknowns) {
  const auto axes = static_cast<Eigen::Index>(unknowns);
  std::vector<Eigen::VectorXd> points;
  for (unsigned corner = 0; corner < (1U << unknowns); ++corner) {
    Eigen::VectorXd point(axes);
    for (Eigen::Index axis = 0; axis < axes; ++axis) point[axis] = (corner >> static_cast<unsigned>(axis)) & 1U;
    points.push_back(std::move(point));
  }
  boost::random::sobol sequence(unknowns);
  for (std::size_t i = 0; i < sizes_of.at(unknowns).of_sequence; ++i) {
    Eigen::VectorXd point(axes);
    for (Eigen::Index axis = 0; axis < axes; ++axis) {
      point[axis] = static_cast<double>(sequence()) / static_cast<double>(boost::random::sobol::max());
    }
    points.push_back(std::move(point));
  }
  return points;
}

std::vector<Eigen::VectorXd> further_points(const std::vector<Eigen::VectorXd>& design, const Lattice& lattice,
                                            const Eigen::VectorXd& deviances) {
  const Eigen::VectorXd unit = lattice.window().high - lattice.window().low;
  std::vector<double> distances;
  for (std::size_t i = 0; i < lattice.size(); ++i) distances.push_back(distance_to(design, lattice.point(i), unit));
  std::vector<Eigen::VectorXd> added;
  const auto [of_sequence, most_added, most] = sizes_of.at(lattice.axes());
  while (added.size() < most_added && design.size() + added.size() < most) {
    std::size_t best = 0;
    double largest = -1.0;
    for (std::size_t i = 0; i < lattice.size(); ++i) {
      const double value = std::exp(-0.125 * deviances[static_cast<Eigen::Index>(i)]) * distances[i];
      if (value <= largest) continue;
      largest = value;
      best = i;
    }
    added.push_back(lattice.point(best));
    for (std::size_t i = 0; i < lattice.size(); ++i) {
      distances[i] = std::min(distances[i], (lattice.point(i) - added.back()).cwiseQuotient(unit).norm());
    }
  }
  return added;
}

std::size_t most_points(std::size_t unknowns) { return sizes_of.at(unknowns).most; }

}  // namespace rocking::infer
