#pragma once

#include <cstdint>

namespace rocking::dynamics {

/// Whether the equations give N <= 0, which the model does not exclude, and how often that began.
class LossOfContact {
 public:
  [[nodiscard]] bool is_off_ground() const { return off_ground_; }  ///< N <= 0
  [[nodiscard]] std::uint64_t losses() const { return losses_; }
  [[nodiscard]] double first() const { return first_; }  ///< tau of the first loss; meaningless without one
  /// Losses since the block was last seen with abs(Theta) <= 1. If it overturns, they belong to its final fall.
  [[nodiscard]] std::uint64_t since_balance() const { return since_balance_; }

  /// `beyond_balance`: abs(Theta) > 1 now.
  void set(bool off_ground, double tau, bool beyond_balance) {
    if (off_ground && !off_ground_) {
      if (losses_++ == 0) first_ = tau;
      since_balance_ = beyond_balance ? since_balance_ + 1 : 0;
    }
    off_ground_ = off_ground;
  }

  /// abs(Theta) <= 1 again.
  void return_within_balance() { since_balance_ = 0; }

 private:
  bool off_ground_ = false;
  std::uint64_t losses_ = 0;
  std::uint64_t since_balance_ = 0;
  double first_ = 0.0;
};

}  // namespace rocking::dynamics
