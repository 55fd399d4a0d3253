#pragma once

#include <functional>
#include <string>

#include "differential/random_scene.hpp"

namespace rocking::benchmarks {

/// A block of H/B = 4 at Omega_h = 10.
struct Case {
  std::string name;
  double amplitude;
  bool slides;   ///< with friction 0.40/0.35
  double sigma;  ///< of static and kinetic friction
};

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

/// Follows `copies` realisations of each start to their ends, side by side in the lanes that the machine has. Returns how many
/// reached them.
[[nodiscard]] int follow_side_by_side(const Case& c, double tolerance, int copies);

/// A tolerance, and the errors in Theta, Theta', V that it leaves over all starts.
struct Calibration {
  double tolerance;
  double median;
  double largest;
};

/// The coarsest tolerance of a ladder at which the median error is at most `wanted`, or else the one of the least.
[[nodiscard]] Calibration calibrate(const Case& c, const Follow& follow, double wanted);

}  // namespace rocking::benchmarks
