#pragma once

#include <cstdint>

namespace rocking::dynamics {

/// Whether the equations give N <= 0, which the model does not exclude, and how often that began.
class LossOfContact {
 public:
  [[nodiscard]] bool is_off_ground() const { return off_ground_; }  ///< N <= 0
  [[nodiscard]] std::uint64_t losses() const { return losses_; }
  [[nodiscard]] double first() const { return first_; }  ///< tau of the first loss; meaningless without one

  void set(bool off_ground, double tau) {
    if (off_ground && !off_ground_ && losses_++ == 0) first_ = tau;
    off_ground_ = off_ground;
  }

 private:
  bool off_ground_ = false;
  std::uint64_t losses_ = 0;
  double first_ = 0.0;
};

}  // namespace rocking::dynamics
