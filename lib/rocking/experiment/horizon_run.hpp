#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "rocking/experiment/exponent.hpp"
#include "rocking/experiment/realisation.hpp"
#include "rocking/experiment/record.hpp"
#include "rocking/experiment/strobe_recorder.hpp"
#include "rocking/section/classify.hpp"

/// A motion run over the horizon of its condition, and its response named.
namespace rocking::experiment {

inline void add(Effort& effort, const integrate::LoopCounts& counts) {
  effort.steps += counts.steps;
  effort.root_isolations += counts.root_isolations;
}

/// A strobe point is about as accurate as the step times a few hundred of them; better than 1e-9 is never needed.
inline double resolution_of(double tolerance) { return std::max(1e-9, 1e3 * tolerance); }

/// The strobe points for which a motion must be scheduled before run_to_horizon. A run has at least one of them before the
/// copy for a companion is made.
[[nodiscard]] inline std::int64_t strobes_before_copy(const Condition& condition) {
  return std::max<std::int64_t>(condition.horizon.transient_periods, 1);
}

/// What a finished motion leaves behind, but for the verdict.
template <class Motion>
void collect(Record& record, const Motion& motion, const StrobeRecorder& recorder) {
  record.termination = motion.termination().value_or(dynamics::Termination::stopped);
  record.losses_of_contact = motion.losses_of_contact();
  record.first_loss_of_contact = motion.first_loss_of_contact();
  record.was_past_balance = motion.was_past_balance();
  record.contradictions = motion.contradictions();
  record.effort.slip_steps = motion.slip_steps();
  record.effort.events = recorder.events();
  motion.coefficients().add_to(record.effort);
  record.effort.record_segments = motion.excitation().segments_looked_up();
  record.clamps = motion.coefficients().clamps();
  record.strobe.reserve(recorder.periods().size());
  for (const section::Period& period : recorder.periods()) record.strobe.push_back(period.point);
}

/// Under a record nothing repeats: a block stands at the end or it does not.
[[nodiscard]] inline section::Verdict verdict_after_record(const std::vector<section::Period>& periods) {
  if (periods.back().moved) return section::unresolved(section::Reason::not_periodic, true);
  const bool ever_moved = std::ranges::any_of(periods, [](const section::Period& period) { return period.moved; });
  return {.mode = {.kind = section::ResponseKind::rest},
          .reason = ever_moved ? section::Reason::came_to_rest : section::Reason::never_moved,
          .in_transient = false,
          .margin = section::largest_margin};
}

/// Runs `motion`, scheduled for strobes_before_copy, over the horizon and names its response. A copy is kept from the end of the transient, for a companion.
template <class Motion>
void run_to_horizon(Record& record, Motion& motion, const StrobeRecorder& recorder, const Condition& condition) {
  const std::int64_t sampled = condition.horizon.sampled_periods;
  const std::int64_t more = condition.horizon.transient_periods + sampled - strobes_before_copy(condition);
  add(record.effort, integrate::advance(motion));
  const Motion after_transient = motion;
  if (more > 0) {
    motion.extend(more);
    add(record.effort, integrate::advance(motion));
  }
  collect(record, motion, recorder);
  if (record.termination == dynamics::Termination::overturned) {
    record.verdict.mode = {.kind = section::ResponseKind::overturned};
    return;
  }
  if (record.termination != dynamics::Termination::reached_horizon) return;
  if constexpr (std::is_same_v<Motion, experiment::Motion<dynamics::HarmonicExcitation>>) {
    const auto exponent = [&]() -> std::optional<section::ExponentEstimate> {
      const double shape_angle = dynamics::geometry_of(condition.scene.block).shape_angle;
      const CompanionRun run = companion_exponent(after_transient, shape_angle, sampled);
      record.effort.companion_periods += run.periods;
      return run.exponent;
    };
    record.verdict =
        section::classify({.periods = std::span(recorder.periods()).last(static_cast<std::size_t>(sampled)),
                           .random = is_random(condition.scene),
                           .resolution = resolution_of(condition.tolerance)},
                          exponent);
  } else {
    record.verdict = verdict_after_record(recorder.periods());
  }
}

}  // namespace rocking::experiment
