#pragma once

#include <array>
#include <cstddef>
#include <memory>

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

struct FlowAccuracy {
  double relative = 2e-14;
  double absolute = 1e-15;
  double longest_step;  ///< guards are looked at once a step: a dip below 0 that is shorter is missed
};

/// CVODE, method of Adams, with its root finding.
///
/// A guard that starts at 0 counts from when it has left 0; only a fall is reported.
/// Source: Hindmarsh et al. (2005), SUNDIALS, ACM TOMS 31(3) 363-396.
class Flow {
 public:
  explicit Flow(const FlowAccuracy& accuracy);
  ~Flow();

  /// From `start` for `duration` or until the first guard falls through 0. The absolute tolerance is times `smallness`.
  [[nodiscard]] Stretch follow(const Vector& start, double duration, double smallness, const Equations& equations);

 private:
  struct Solver;
  FlowAccuracy accuracy_;
  std::unique_ptr<Solver> solver_;
};

}  // namespace rocking::peer
