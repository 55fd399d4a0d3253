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

/// The cases of reports/evidence/performance.md.
[[nodiscard]] inline std::array<Case, 3> usual_cases() {
  return {{{"no sliding", 4.5, false, 0.0}, {"sliding", 7.0, true, 0.0}, {"fluctuating friction", 7.0, true, 0.03}}};
}

inline constexpr int starts = 16;   ///< number of initial tilts, one realisation each
inline constexpr int periods = 20;  ///< number of excitation periods

[[nodiscard]] differential::Question question_of(const Case& c, int start);

struct EndState {
  double tilt;       ///< Theta
  double tilt_rate;  ///< Theta'
  double slip_rate;  ///< V
  bool reached;      ///< whether the run reached the last period
};

/// Simulates one realisation to its end at a tolerance.
using Follow = std::function<EndState(const differential::Question&, double)>;

[[nodiscard]] EndState follow_by_ours(const differential::Question& question, double tolerance);
[[nodiscard]] EndState follow_by_odeint(const differential::Question& question, double tolerance);

/// Realisations from all initial tilts in turn, advanced together in lanes; when one ends, the next begins.
class SideBySide {
 public:
  SideBySide(const Case& c, double tolerance, const lanes::Kernels& kernels);
  ~SideBySide();

  /// Continues until `count` more have ended; returns how many of them reached their last period.
  int finish(int count);

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// A tolerance, and the resulting errors in Theta, Theta', V over all initial tilts.
struct Calibration {
  double tolerance;
  double median;
  double largest;
};

/// The coarsest tolerance of a sequence at which the median error is at most `wanted`; otherwise the one with the
/// smallest error.
[[nodiscard]] Calibration calibrate(const Case& c, const Follow& follow, double wanted);

}  // namespace rocking::benchmarks
