#include "rocking/store/summary.hpp"

#include <algorithm>

#include "rocking/realisation/realisation_result.hpp"

namespace rocking {

namespace {

/// All fields but those of Settling.
Summary summary_at_fixed_horizon(const RealisationResult& result, std::uint64_t realisation) {
  return {.mode = result.classification.mode,
          .reason = result.classification.reason,
          .termination = result.termination,
          .margin = result.classification.margin,
          .held = result.classification.held,
          .exponent = result.exponent ? std::optional(result.exponent->exponent) : std::nullopt,
          .exponent_error = result.exponent ? std::optional(result.exponent->standard_error) : std::nullopt,
          .in_transient = result.classification.in_transient,
          .left_ground = result.losses_of_contact > 0,
          .was_past_balance = result.was_past_balance,
          .overturned_side = result.overturned_side,
          .met_contradiction = result.contradictions > 0,
          .digest = digest_of(result, realisation),
          .diverged_from_next = std::nullopt,
          .rerun_mode = std::nullopt,
          .rerun_diverged = std::nullopt,
          .operations = result.operations,
          .clamps = result.clamps,
          .left_ground_before_fall = result.losses_before_fall > 0,
          .peaks = result.peaks,
          .horizon_mode = std::nullopt,
          .observed_periods = std::nullopt,
          .settling_period = std::nullopt,
          .left_period = std::nullopt,
          .left_to = std::nullopt,
          .long_run = std::nullopt};
}

}  // namespace

bool Summary::was_clamped() const {
  return std::ranges::any_of(clamp_kinds, [this](const ClampKind& kind) { return clamps.*kind.count > 0; });
}

bool Summary::has_no_answer() const {
  using enum dynamics::Termination;
  return (termination == painleve || termination == stopped) && mode.kind == section::ResponseKind::unresolved;
}

Summary summarise(const RealisationResult& result, std::uint64_t realisation) {
  Summary summary = summary_at_fixed_horizon(result, realisation);
  if (!result.settling) return summary;
  const Settling& settling = *result.settling;
  summary.horizon_mode = settling.horizon_mode;
  summary.observed_periods = settling.observed_periods;
  summary.settling_period = settling.settling_period;
  summary.left_period = settling.left_period;
  summary.left_to = settling.left_to;
  summary.long_run = settling.long_run;
  return summary;
}

}  // namespace rocking
