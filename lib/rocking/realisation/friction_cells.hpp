#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace rocking {

/// The cells of the base along the slip X of one block, each with its own friction, and the one in which the block is.
/// Cell i lies between X = (i - 1/2) and (i + 1/2) lengths: a block starts in the middle of cell 0. Lengths are over R.
class FrictionCells {
 public:
  explicit FrictionCells(double length) : length_(length) {}

  /// Returns whether that is another cell.
  bool move_to(double slip) { return enter(static_cast<std::int64_t>(std::floor(slip / length_ + 0.5))); }
  /// The neighbour in this direction (1 or -1).
  void enter_next(double direction) { enter(cell_ + static_cast<std::int64_t>(direction)); }

  /// X at the end of the cell, in this direction.
  [[nodiscard]] double end(double direction) const { return (static_cast<double>(cell_) + 0.5 * direction) * length_; }

  /// Index of the draws of the cell: 0, 1, 2, 3, 4, ... of the cells 0, -1, 1, -2, 2, ...
  [[nodiscard]] std::uint64_t index() const {
    const auto number = static_cast<std::uint64_t>(cell_ < 0 ? -(cell_ + 1) : cell_);
    return 2 * number + (cell_ < 0 ? 1 : 0);
  }
  /// No cell up to now has this index or a larger one.
  [[nodiscard]] std::uint64_t first_unused() const { return first_unused_; }

 private:
  bool enter(std::int64_t cell) {
    const bool is_other = cell != cell_;
    cell_ = cell;
    first_unused_ = std::max(first_unused_, index() + 1);
    return is_other;
  }

  double length_;
  std::int64_t cell_ = 0;
  std::uint64_t first_unused_ = 1;
};

}  // namespace rocking
