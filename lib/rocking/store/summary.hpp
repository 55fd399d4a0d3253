#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rocking/base/digest.hpp"
#include "rocking/realisation/measures.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/store/realisation_key.hpp"

namespace rocking {

/// The part of a result that is stored, after the comparison with the neighbouring realisation: a few hundred bytes,
/// whatever the horizon.
struct Summary {
  section::ResponseMode mode;
  std::optional<section::Reason> reason;  ///< absent if no rule was needed
  dynamics::Termination termination = dynamics::Termination::reached_horizon;
  double margin = 0.0;
  double held = 0.0;  ///< share of the sampled periods that support the mode
  /// Largest Lyapunov exponent and its standard error [1/period]; absent if no classification needed it.
  std::optional<double> exponent;
  std::optional<double> exponent_error;
  bool in_transient = false;
  bool left_ground = false;
  bool was_past_balance = false;
  std::optional<dynamics::Side> overturned_side;  ///< absent if it did not overturn
  bool met_contradiction = false;
  base::Sha256 digest{};  ///< of the result
  /// For an even-numbered realisation: period in which the next one diverged from it.
  std::optional<std::int64_t> diverged_from_next;
  /// For a realisation that was rerun at a tighter tolerance: its mode there, and the period in which the two diverged.
  std::optional<section::ResponseMode> rerun_mode;
  std::optional<std::int64_t> rerun_diverged;
  OperationCounts operations;
  Clamps clamps;
  /// Whether contact was lost before a final fall (dynamics::BlockMotion::losses_before_fall).
  bool left_ground_before_fall = false;
  PeakValues peaks;
  /// Settling, for realisations that are run until they are classified; otherwise absent.
  std::optional<section::ResponseMode> horizon_mode;
  std::optional<std::int64_t> observed_periods;
  std::optional<std::int64_t> settling_period;
  std::optional<std::int64_t> left_period;
  std::optional<section::ResponseMode> left_to;
  std::optional<section::ModeCounts> long_run;  ///< absent without a long run

  [[nodiscard]] bool was_clamped() const;
  /// Whether the motion ended before its horizon without an answer: by a budget, or by Painleve's paradox.
  [[nodiscard]] bool has_no_answer() const;
};

[[nodiscard]] Summary summarise(const RealisationResult& result, std::uint64_t realisation);

/// Number of the layout of a store. A new or renamed field of a row needs the next one.
inline constexpr std::int64_t current_layout = 10;

/// Calls visit(name, field) for every field of a summary, in a fixed order. These fields make up a stored row. A member
/// that is forgotten here does not compile.
template <class SomeSummary, class Visit>
void for_each_field(SomeSummary& summary, Visit&& visit) {
  auto& [mode, reason, termination, margin, held, exponent, exponent_error, in_transient, left_ground, was_past_balance,
         overturned_side, met_contradiction, digest, diverged_from_next, rerun_mode, rerun_diverged, operations, clamps,
         left_ground_before_fall, peaks, horizon_mode, observed_periods, settling_period, left_period, left_to,
         long_run] = summary;
  visit("mode", mode);
  visit("reason", reason);
  visit("termination", termination);
  visit("margin", margin);
  visit("held", held);
  visit("exponent", exponent);
  visit("exponent_error", exponent_error);
  visit("in_transient", in_transient);
  visit("left_ground", left_ground);
  visit("past_balance", was_past_balance);
  visit("overturned_side", overturned_side);
  visit("contradiction", met_contradiction);
  visit("digest", digest);
  visit("diverged_from_next", diverged_from_next);
  visit("rerun_mode", rerun_mode);
  visit("rerun_diverged", rerun_diverged);
  visit("steps", operations.steps);
  visit("slip_steps", operations.slip_steps);
  visit("root_isolations", operations.root_isolations);
  visit("ground_motion_segments", operations.ground_motion_segments);
  visit("exponent_periods", operations.exponent_periods);
  visit("static_friction_draws", operations.static_friction_draws);
  visit("kinetic_friction_draws", operations.kinetic_friction_draws);
  visit("restitution_draws", operations.restitution_draws);
  visit("amplitude_draws", operations.amplitude_draws);
  visit("initial_draws", operations.initial_draws);
  for (std::size_t kind = 0; kind < operations.events.size(); ++kind) {
    visit("event_" + std::string(to_string(static_cast<dynamics::EventKind>(kind))), operations.events[kind]);
  }
  for (const ClampKind& kind : clamp_kinds) visit(std::string(kind.column), clamps.*kind.count);
  visit("left_ground_before_fall", left_ground_before_fall);
  visit("peak_tilt", peaks.tilt);
  visit("peak_tilt_rate", peaks.tilt_rate);
  visit("peak_slip", peaks.slip);
  visit("peak_slip_m", peaks.slip_m);
  visit("final_slip", peaks.final_slip);
  visit("final_slip_m", peaks.final_slip_m);
  visit("horizon_mode", horizon_mode);
  visit("observed_periods", observed_periods);
  visit("settling_period", settling_period);
  visit("left_period", left_period);
  visit("left_to", left_to);
  visit("long_run", long_run);
}

}  // namespace rocking
