#pragma once

#include <cstddef>

namespace rocking::section {

/// Thresholds of the classifier. Users do not set them. The defaults are derived one by one in
/// lib/docs/methods-classification.md; reports/evidence/classification-evidence.md tabulates how much the result of an
/// experiment depends on each of them.
struct Thresholds {
  // Noise-free responses.
  double coincidence = 10.0;  ///< in resolutions: points no further apart than this coincide
  /// Ratio of distances from one third of the window to the next; above it nothing converges.
  double slowest_ratio = 0.8;
  double clear_divisors =
      1e5;                    ///< factor by which points miss more after a divisor of the period than after the period
  double least_decay = 1e-6;  ///< of a stable orbit: -ln abs(largest multiplier) per period
  double reach = 0.02;        ///< units of Theta: largest distance from the orbit that the points tend to
  std::size_t fewest_cycles = 4;  ///< in the last half of the window, to see that they do
  double least_decay_share =
      0.5;                    ///< of the decay that the multipliers give, from one quarter of the window to the next
  double largest_miss = 0.1;  ///< of the map's derivative, as a share of the way from cycle to cycle
  // The exponent.
  double clear_standard_errors = 3.0;  ///< distance from zero
  double sure_standard_errors = 5.0;   ///< the same, from which on no more periods are computed
  double clear_growth = 1.0;           ///< distance from zero of ln of the change of a distance over the window
  // Quasi-periodic responses.
  double largest_disorder = 0.05;        ///< von Neumann's ratio of the points in the order of a rotation
  double largest_first_disorder = 0.25;  ///< the same, above which no further points are looked at
  double least_turns = 5.0;              ///< of a curve
  double widest_gap = 5.0;               ///< in mean gaps between the points of the first half on a circle
  double least_miss = 3.0;               ///< in scatters about the curve: a return this wide is none of a period
  double largest_change = 1.5;           ///< of the closest returns from one half of the points to the other, a factor
  double largest_change_of_line = 1.02;  ///< the same of the amplitude of the strongest line
  // Noisy responses.
  double line_chance = 1e-4;      ///< false-alarm probability for all spectral lines of a series together
  double least_separation = 4.0;  ///< scatters between centres: each cloud reaches two scatters towards the middle
  double usual_memory = 0.83;     ///< from cycle to cycle: of deviations near an orbit without slip
  double separation_growth =
      40.6;                     ///< over the number of cycles of a divisor: smallest ln(separation/2), for that memory
  double stray_distance = 5.0;  ///< scatters; exceeded by 4e-6 of the points of a normal law
  double largest_stray_share = 0.05;  ///< share of the points
  double tiny_share = 0.01;           ///< share of the extent of the motion and of the separation
  double chance_per_cut = 53.0;       ///< over the number of cycles: what dividing the window explains by chance
  double longest_memory = 0.96;       ///< correlation of deviations from period to period
  double least_regular_share = 0.9;   ///< share of the cycles that have the typical number of impacts
  double orbit_distance = 3.0;        ///< scatters from the centres of clouds to the stable orbit that they lie about
  // Responses that change within the window.
  double least_held = 0.5;  ///< share of the window that the last regime must fill to be the classification
};

}  // namespace rocking::section
