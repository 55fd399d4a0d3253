#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/ensemble/result.hpp"
#include "rocking/scene/experiment.hpp"

/// What a reader of a result must know before using it, and what to do about it.
namespace rocking {

/// Clamped draws are reported as an alarm above this share of the realisations of a condition, or of its draws: below
/// it they change a probability by less than the usual half-width of an interval.
inline constexpr double tolerable_clamped_share = 0.01;

/// The number of a condition's realisations with a clamped draw, and of its clamped draws.
struct ClampedShare {
  std::uint64_t realisations = 0;
  std::uint64_t of_realisations = 0;
  std::uint64_t draws = 0;
  std::uint64_t of_draws = 0;  ///< 0: not known, as in reports of earlier versions

  [[nodiscard]] double share_of_realisations() const;
  [[nodiscard]] double share_of_draws() const;
  [[nodiscard]] bool is_alarming() const;
};

/// `12.0 % of the realisations, 0.8 % of the draws`.
[[nodiscard]] std::string spoken(const ClampedShare& share);

/// What a clamp of this kind (the key of a report, `kinetic_friction_at_static`) means and what would avoid it.
[[nodiscard]] std::string_view clamp_remedy(std::string_view key);

/// What to do if response modes change with the tolerance: the key and its value, or what is left if `tolerance` is at
/// the limit of double precision.
[[nodiscard]] std::string tolerance_remedy(double tolerance);

/// The alarms of a run, each a sentence or two: contact lost before a final fall, clamped draws.
[[nodiscard]] std::vector<std::string> alarms_of(const ExperimentResult& result);

/// The tightest tolerance of an experiment.
[[nodiscard]] double tightest_tolerance(const Experiment& experiment);

}  // namespace rocking
