#pragma once

#include "rocking/studies/fragility/stripes.hpp"

namespace rocking {

/// The event at one intensity: overturning, or the event of the curve.
struct FragilityLevel {
  double intensity = 0.0;
  std::optional<Shaking> shaking = std::nullopt;  ///< of the condition; absent under a ground motion
  stats::Proportion overturned;
  /// Realisations without an answer (Summary::has_no_answer). They count as not overturned in `overturned` and
  /// `estimate`; the intervals also cover that all of them overturn.
  std::uint64_t unresolved = 0;
  double estimate = 0.0;                        ///< share of the realisations that overturned
  stats::Interval exact = {};                   ///< Clopper-Pearson, of this level alone
  stats::Interval simultaneous = {};            ///< Bonferroni-Clopper-Pearson over the levels of the curve
  std::optional<double> fitted = std::nullopt;  ///< by the law; absent where none is fitted
  /// Of `fitted` at this intensity alone; of `isotonic` it is `simultaneous`, which holds also if the probability decreases
  /// somewhere. Absent without both.
  std::optional<stats::Interval> band = std::nullopt;
  /// Most likely probability that does not decrease with the intensity; present where the fitted function was rejected.
  std::optional<double> isotonic = std::nullopt;

  /// Whether the fitted function lies outside the simultaneous interval.
  [[nodiscard]] bool is_missed() const;
};

/// A small probability of the event at an intensity, by `rocking rare` (lib/docs/rare.md).
struct RareLevel {
  double intensity = 0.0;
  double probability = 0.0;         ///< in (0, 1)
  stats::Interval interval = {};    ///< at its own confidence
  double relative_error = 0.0;      ///< standard error over the probability
  double degrees_of_freedom = 1.0;  ///< of the error
};

/// How far rare estimates give the probabilities of a rate.
enum class RareUse : std::uint8_t {
  below_sure_level,  ///< below the lowest level with ten events
  below_best_level,  ///< no level has so many: below the one above the estimates that has the most
  up_to_highest,     ///< no level above the estimates has an event: up to the highest estimate
  not_used,          ///< none lies below a level with ten events, or there is one alone and no level with an event
};
/// Their names, in their order.
inline constexpr std::array<std::string_view, 4> rare_use_names{"below_sure_level", "below_best_level", "up_to_highest",
                                                                "not_used"};
[[nodiscard]] constexpr std::string_view to_string(RareUse use) {
  return rare_use_names[static_cast<std::size_t>(use)];
}

/// The fitted function of a curve, and what follows from it at the curve's confidence and levels.
struct FittedLaw {
  stats::LognormalFragility function;
  stats::Bounded median;
  bool is_extrapolated = false;  ///< the median lies outside the levels
  stats::Bounded dispersion;
};

/// Probability of overturning as a function of intensity, from conditions that differ in nothing else.
struct FragilityCurve {
  CurveSubject subject;
  stats::FragilityOutcome outcome = stats::FragilityOutcome::fitted;
  std::optional<FittedLaw> law;          ///< present if and only if the outcome is `fitted`
  std::optional<stats::LackOfFit> test;  ///< of the fitted function; absent where none could be fitted
  std::vector<FragilityLevel> levels;    ///< by growing intensity
  std::vector<RareLevel> rare;           ///< likewise; the function is not fitted to them

  /// Levels at which the fitted function lies outside the simultaneous interval.
  [[nodiscard]] std::size_t missed_levels() const;
};

}  // namespace rocking
