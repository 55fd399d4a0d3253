#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>

#include "differential/random_scene.hpp"
#include "rocking/lanes/kernels.hpp"

namespace rocking::benchmarks {

/// A block of H/B = 4 at Omega_h = 10.
struct Case {
  std::string name;
  double amplitude;
  bool slides;   ///< with friction 0.40/0.35
  double sigma;  ///< of static and kinetic friction
};

/// Those of lib/docs/performance.md.
[[nodiscard]] inline std::array<Case, 3> usual_cases() {
  return {{{"no sliding", 4.5, false, 0.0}, {"sliding", 7.0, true, 0.0}, {"fluctuating friction", 7.0, true, 0.03}}};
}

inline constexpr int starts = 16;   ///< initial tilts, each a realisation
inline constexpr int periods = 20;  ///< of the excitation

[[nodiscard]] differential::Question question_of(const Case& c, int start);

struct EndState {
  double tilt;       ///< Theta
  double tilt_rate;  ///< Theta'
  double slip_rate;  ///< V
  bool reached;      ///< the last period
};

/// Follows one realisation to its end at a tolerance.
using Follow = std::function<EndState(const differential::Question&, double)>;

[[nodiscard]] EndState follow_by_ours(const differential::Question& question, double tolerance);
[[nodiscard]] EndState follow_by_odeint(const differential::Question& question, double tolerance);
[[nodiscard]] EndState follow_by_arkode(const differential::Question& question, double tolerance);

/// Realisations from all starts in turn, side by side in lanes; one that has ended makes room for the next.
class SideBySide {
 public:
  SideBySide(const Case& c, double tolerance, const lanes::Kernels& kernels);
  ~SideBySide();

  /// Goes on until `count` more have ended; returns how many of them reached their last period.
  int finish(int count);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// A tolerance, and the errors in Theta, Theta', V that it leaves over all starts.
struct Calibration {
  double tolerance;
  double median;
  double largest;
};

/// The coarsest tolerance of a ladder at which the median error is at most `wanted`, or else the one of the least.
[[nodiscard]] Calibration calibrate(const Case& c, const Follow& follow, double wanted);

}  // namespace rocking::benchmarks
