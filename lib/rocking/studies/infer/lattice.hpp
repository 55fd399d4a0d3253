#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace rocking::infer {

/// A part of the unit cube.
struct Window {
  Eigen::VectorXd low;
  Eigen::VectorXd high;
};

/// A grid of equally spaced points over a window, its ends included; the last coordinate varies fastest.
class Lattice {
 public:
  /// Of as many points on each axis as one to three coordinates allow.
  explicit Lattice(Window window);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::size_t axes() const { return static_cast<std::size_t>(window_.low.size()); }
  [[nodiscard]] std::size_t points_on_axis() const { return points_on_axis_; }
  [[nodiscard]] Eigen::VectorXd point(std::size_t index) const;
  /// Place of a point on an axis.
  [[nodiscard]] std::size_t place(std::size_t index, std::size_t axis) const {
    return index / strides_[axis] % points_on_axis_;
  }
  /// At the first and the last place exactly those of the window.
  [[nodiscard]] double coordinate(std::size_t place, std::size_t axis) const;
  [[nodiscard]] const Window& window() const { return window_; }

 private:
  Window window_;
  std::size_t points_on_axis_;
  std::vector<std::size_t> strides_;
  std::size_t size_ = 1;
};

/// The smallest window with all points of a lattice for which `keep` holds, and one more on each side.
template <class Keep>
[[nodiscard]] Window window_around(const Lattice& lattice, Keep&& keep) {
  const auto axes = static_cast<Eigen::Index>(lattice.axes());
  std::vector<std::size_t> first(lattice.axes(), lattice.points_on_axis() - 1);
  std::vector<std::size_t> last(lattice.axes(), 0);
  for (std::size_t i = 0; i < lattice.size(); ++i) {
    if (!keep(i)) continue;
    for (std::size_t axis = 0; axis < lattice.axes(); ++axis) {
      const std::size_t place = lattice.place(i, axis);
      if (place < first[axis]) first[axis] = place;
      if (place > last[axis]) last[axis] = place;
    }
  }
  Window window{.low = Eigen::VectorXd(axes), .high = Eigen::VectorXd(axes)};
  for (Eigen::Index axis = 0; axis < axes; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    window.low[axis] = lattice.coordinate(first[a] > 0 ? first[a] - 1 : 0, a);
    window.high[axis] = lattice.coordinate(last[a] + 1 < lattice.points_on_axis() ? last[a] + 1 : last[a], a);
  }
  return window;
}

/// The corners of the unit cube and points of a Sobol sequence within: 12, 32 or 56 points for one, two or three
/// unknowns.
[[nodiscard]] std::vector<Eigen::VectorXd> first_design(std::size_t unknowns);

/// Points of a lattice to add to a design, where the likelihood is high and the design is thin: one after the other,
/// each with the largest product of the fourth root of the likelihood and the distance to the nearest point, where
/// distances are counted in the size of the lattice. No more than `most_points` are in the design then.
[[nodiscard]] std::vector<Eigen::VectorXd> further_points(const std::vector<Eigen::VectorXd>& design,
                                                          const Lattice& lattice, const Eigen::VectorXd& deviances);

/// Largest number of points of a design.
[[nodiscard]] std::size_t most_points(std::size_t unknowns);

}  // namespace rocking::infer
