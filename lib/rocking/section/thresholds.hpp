#pragma once

namespace rocking::section {

/// Where the classifier draws its lines. The defaults are derived in lib/docs/methods-classification.md, one by one; how far
/// the result of an experiment depends on each is tabulated in lib/docs/classification-evidence.md. Users do not set them.
struct Thresholds {
  // Noise-free responses.
  double coincidence = 10.0;   ///< resolutions: points that are no further apart have come back
  double slowest_ratio = 0.8;  ///< of distances, from one third of the window to the next: slower is no convergence
  double small_drift = 1e-3;   ///< units of Theta: what may still come of a convergence
  // The exponent.
  double clear_standard_errors = 3.0;  ///< away from zero
  double clear_growth = 1.0;           ///< ln of the change of a distance over the window, away from zero
  // Noisy responses.
  double line_chance = 1e-4;          ///< false alarms of all spectral lines of a series together
  double least_separation = 4.0;      ///< scatters between centres: each cloud reaches two to the middle
  double separation_growth = 40.6;    ///< over the cycles of a divisor: least ln(separation/2)
  double stray_distance = 5.0;        ///< scatters; a normal law throws 4e-6 of the points that far
  double largest_stray_share = 0.05;  ///< of the points
  double tiny_share = 0.01;           ///< of the extent of the motion and of the separation
  double chance_per_cut = 53.0;       ///< over the cycles: what a cut of the window explains by chance
  double longest_memory = 0.96;       ///< correlation of deviations from period to period
  double least_regular_share = 0.9;   ///< of the cycles, those with the usual number of impacts
  // Responses that change their mind.
  double least_held = 0.5;  ///< share of the window that the last regime must have held to give its name
};

}  // namespace rocking::section
