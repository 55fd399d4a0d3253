#include "rocking/studies/infer/lattice.hpp"

#include <array>
#include <cmath>
#include <utility>

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

}  // namespace rocking::infer
