#pragma once

#include <array>
#include <cstddef>

namespace rocking::peer {

/// theta, w, X, V.
using Vector = std::array<double, 4>;

/// Functions whose fall through 0 ends a stretch.
inline constexpr std::size_t guard_count = 8;
using Guards = std::array<double, guard_count>;

/// A smooth piece of motion. Times are since the start of the stretch.
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
  double longest_step;  ///< guards are looked at once a step: a dip below 0 that is shorter is missed
};

/// An integrator with its root finding.
///
/// A guard that starts at 0 counts from when it has left 0; only a fall is reported.
class Flow {
 public:
  virtual ~Flow() = default;

  /// From `start` for `duration` or until the first guard falls through 0. The absolute tolerance is times `smallness`.
  [[nodiscard]] virtual Stretch follow(const Vector& start, double duration, double smallness,
                                       const Equations& equations) = 0;
};

}  // namespace rocking::peer
