#pragma once

#include <array>
#include <cstddef>

namespace rocking::peer {

/// theta, w, X, V.
using Vector = std::array<double, 4>;

/// Number of functions whose fall through 0 ends a smooth piece of motion.
inline constexpr std::size_t guard_count = 8;
using Guards = std::array<double, guard_count>;

/// Equations of a smooth piece of motion. Times are measured from its start.
class Equations {
 public:
  virtual ~Equations() = default;
  [[nodiscard]] virtual Vector rates(double time, const Vector& state) const = 0;
  [[nodiscard]] virtual Guards guards(double time, const Vector& state) const = 0;
};

struct Stretch {
  double duration;
  Vector state;
  std::array<bool, guard_count> fired;
};

/// Tolerances of an integrator for the error of a step.
struct FlowAccuracy {
  double relative;
  double absolute;
  double longest_step;  ///< guards are tested once a step: a shorter dip below 0 is missed
};

/// An integrator with root finding.
///
/// A guard that starts at 0 is tested after it has left 0; only a fall is reported.
class Flow {
 public:
  virtual ~Flow() = default;

  /// Integrates from `start` for `duration`, or until the first guard falls through 0. The absolute tolerance is
  /// multiplied by `smallness`.
  [[nodiscard]] virtual Stretch follow(const Vector& start, double duration, double smallness,
                                       const Equations& equations) = 0;
};

}  // namespace rocking::peer
