#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "rocking/realisation/exponent.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/start.hpp"
#include "rocking/realisation/strobe_recorder.hpp"
#include "rocking/section/classify.hpp"

/// Runs a motion over the horizon of its condition and classifies the response.
namespace rocking {

inline void add(OperationCounts& operations, const integrate::LoopCounts& counts) {
  operations.steps += counts.steps;
  operations.root_isolations += counts.root_isolations;
}

/// Accuracy of a strobe point, in units of Theta: the tolerance of a step times about a thousand steps; at least 1e-9,
/// which is always sufficient.
inline double resolution_of(double tolerance) { return std::max(1e-9, 1e3 * tolerance); }

/// Copies the results of a finished motion, except the classification.
inline void collect(RealisationResult& result, const Motion& motion, const StrobeRecorder& recorder) {
  result.termination = motion.termination().value_or(dynamics::Termination::stopped);
  result.losses_of_contact = motion.losses_of_contact();
  result.losses_before_fall = motion.losses_before_fall();
  result.first_loss_of_contact = motion.first_loss_of_contact();
  result.was_past_balance = motion.was_past_balance();
  result.contradictions = motion.contradictions();
  result.peaks = peaks_of(motion, motion.setting().block);
  result.operations.slip_steps = motion.slip_steps();
  result.operations.events = recorder.events();
  motion.coefficients().add_to(result.operations);
  result.operations.ground_motion_segments = motion.segments_looked_up();
  result.clamps += motion.coefficients().clamps();
  result.strobe.reserve(recorder.periods().size());
  for (const section::Period& period : recorder.periods()) result.strobe.push_back(period.point);
}

/// Classification under a recorded excitation, which does not repeat: the block is at rest at the end, or it is not.
[[nodiscard]] inline section::Classification classification_after_shaking(const std::vector<section::Period>& periods) {
  if (periods.back().moved) return section::unresolved(section::Reason::not_periodic, true);
  const bool ever_moved = std::ranges::any_of(periods, [](const section::Period& period) { return period.moved; });
  return {.mode = {.kind = section::ResponseKind::rest},
          .reason = ever_moved ? section::Reason::came_to_rest : section::Reason::never_moved,
          .in_transient = false,
          .margin = section::largest_margin};
}

/// Number of strobe points for which a motion must be scheduled before a HorizonRun: at least one precedes the copy for
/// the perturbed trajectory.
[[nodiscard]] inline std::int64_t strobes_before_copy(const Condition& condition) {
  return std::max<std::int64_t>(condition.horizon.transient_periods, 1);
}

/// One realisation on its way to the horizon, and its classification at the end. The motion has a pointer to the
/// recorder, so that the object cannot be moved. A copy of the motion at the end of the transient is kept for the
/// reference and the perturbed trajectory.
class HorizonRun {
 public:
  /// make_motion(observer) returns the motion of the realisation that begins so, scheduled for strobes_before_copy.
  template <class MakeMotion>
  HorizonRun(const Condition& condition, const Beginning& beginning, MakeMotion&& make_motion)
      : condition_(&condition),
        shape_angle_(beginning.setting.block.shape_angle),
        recorder_(shape_angle_, condition.horizon.transient_periods + condition.horizon.sampled_periods),
        motion_(make_motion(recorder_)) {
    result_.operations.initial_draws = beginning.draws;
    result_.clamps = beginning.clamps;
  }
  HorizonRun(const HorizonRun&) = delete;
  HorizonRun& operator=(const HorizonRun&) = delete;

  [[nodiscard]] Motion& motion() { return motion_; }
  [[nodiscard]] integrate::LoopCounts& counts() { return counts_; }

  /// To be called when the motion has ended. True if that was only the end of the transient and the motion continues.
  [[nodiscard]] bool go_on() {
    if (after_transient_) return false;
    after_transient_ = motion_;
    const Horizon& horizon = condition_->horizon;
    const std::int64_t more = horizon.transient_periods + horizon.sampled_periods - strobes_before_copy(*condition_);
    if (more > 0) motion_.extend(more);
    return !motion_.ended();
  }

  /// To be called when go_on() has returned false. Classifies the response, unless that needs the exponent. In that
  /// case returns the pair of trajectories, which the caller runs to its end.
  [[nodiscard]] PerturbedPair* classify();

  /// The result, to be called when everything has been run.
  [[nodiscard]] RealisationResult finish();

 private:
  const Condition* condition_;
  double shape_angle_;
  StrobeRecorder recorder_;
  integrate::LoopCounts counts_;
  Motion motion_;
  std::optional<Motion> after_transient_;
  RealisationResult result_;
  section::PendingClassification classification_;
  std::optional<PerturbedPair> perturbed_pair_;
};

inline PerturbedPair* HorizonRun::classify() {
  add(result_.operations, counts_);
  collect(result_, motion_, recorder_);
  if (result_.termination == dynamics::Termination::overturned) {
    result_.classification.mode = {.kind = section::ResponseKind::overturned};
    return nullptr;
  }
  if (result_.termination != dynamics::Termination::reached_horizon) return nullptr;
  if (!motion_.excitation().is_periodic()) {
    result_.classification = classification_after_shaking(recorder_.periods());
    return nullptr;
  }
  const std::int64_t sampled = condition_->horizon.sampled_periods;
  classification_ =
      section::classify({.periods = std::span(recorder_.periods()).last(static_cast<std::size_t>(sampled)),
                         .random = is_random(condition_->scene),
                         .resolution = resolution_of(condition_->tolerance)});
  if (!classification_.classification) return &perturbed_pair_.emplace(*after_transient_, shape_angle_, sampled);
  result_.classification = *classification_.classification;
  return nullptr;
}

inline RealisationResult HorizonRun::finish() {
  if (perturbed_pair_) {
    const ExponentRun run = perturbed_pair_->result();
    result_.operations.perturbed_pair_periods += run.periods;
    result_.classification = classification_.with_exponent(run.exponent);
  }
  return std::move(result_);
}

/// Runs the realisation on one lane. Throws base::Stopped if it is asked to stop.
[[nodiscard]] inline RealisationResult run_alone(HorizonRun& run, base::StopRequest stop) {
  while (!run.motion().ended() || run.go_on()) {
    stop.check();
    integrate::step(run.motion(), run.counts());
  }
  if (PerturbedPair* perturbed_pair = run.classify()) run_alone(*perturbed_pair, stop);
  return run.finish();
}

}  // namespace rocking
