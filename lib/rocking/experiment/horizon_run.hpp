#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
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

/// What a finished motion leaves behind, but for the verdict.
inline void collect(Record& record, const Motion& motion, const StrobeRecorder& recorder) {
  record.termination = motion.termination().value_or(dynamics::Termination::stopped);
  record.losses_of_contact = motion.losses_of_contact();
  record.first_loss_of_contact = motion.first_loss_of_contact();
  record.was_past_balance = motion.was_past_balance();
  record.contradictions = motion.contradictions();
  record.effort.slip_steps = motion.slip_steps();
  record.effort.events = recorder.events();
  motion.coefficients().add_to(record.effort);
  record.effort.record_segments = motion.segments_looked_up();
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

/// The strobe points for which a motion must be scheduled before a HorizonRun. A run has at least one of them before the copy
/// for a companion is made.
[[nodiscard]] inline std::int64_t strobes_before_copy(const Condition& condition) {
  return std::max<std::int64_t>(condition.horizon.transient_periods, 1);
}

/// One realisation on its way to the horizon, and its name at the end. It stays where it is, since its motion tells its
/// recorder. A copy of the motion is kept from the end of the transient, for a companion.
class HorizonRun {
 public:
  /// make_motion(observer) returns the motion, scheduled for strobes_before_copy.
  template <class MakeMotion>
  HorizonRun(const Condition& condition, MakeMotion&& make_motion)
      : condition_(&condition),
        recorder_(dynamics::geometry_of(condition.scene.block).shape_angle,
                  condition.horizon.transient_periods + condition.horizon.sampled_periods),
        motion_(make_motion(recorder_)) {}
  HorizonRun(const HorizonRun&) = delete;
  HorizonRun& operator=(const HorizonRun&) = delete;

  [[nodiscard]] Motion& motion() { return motion_; }
  [[nodiscard]] integrate::LoopCounts& counts() { return counts_; }

  /// Once the motion has ended: true if that was only the end of the transient, and it goes on.
  [[nodiscard]] bool go_on() {
    if (after_transient_) return false;
    after_transient_ = motion_;
    const Horizon& horizon = condition_->horizon;
    const std::int64_t more = horizon.transient_periods + horizon.sampled_periods - strobes_before_copy(*condition_);
    if (more > 0) motion_.extend(more);
    return !motion_.ended();
  }

  /// Once the motion does not go on: names the response, unless that takes companions. These are to be run then, until they do
  /// not go on.
  [[nodiscard]] CompanionPair* name();

  /// What came of it, once all is run.
  [[nodiscard]] Record finish();

 private:
  const Condition* condition_;
  StrobeRecorder recorder_;
  integrate::LoopCounts counts_;
  Motion motion_;
  std::optional<Motion> after_transient_;
  Record record_;
  section::Classification classification_;
  std::optional<CompanionPair> companions_;
};

inline CompanionPair* HorizonRun::name() {
  add(record_.effort, counts_);
  collect(record_, motion_, recorder_);
  if (record_.termination == dynamics::Termination::overturned) {
    record_.verdict.mode = {.kind = section::ResponseKind::overturned};
    return nullptr;
  }
  if (record_.termination != dynamics::Termination::reached_horizon) return nullptr;
  if (!motion_.excitation().is_periodic()) {
    record_.verdict = verdict_after_record(recorder_.periods());
    return nullptr;
  }
  const std::int64_t sampled = condition_->horizon.sampled_periods;
  classification_ =
      section::classify({.periods = std::span(recorder_.periods()).last(static_cast<std::size_t>(sampled)),
                         .random = is_random(condition_->scene),
                         .resolution = resolution_of(condition_->tolerance)});
  if (!classification_.verdict) {
    const double shape_angle = dynamics::geometry_of(condition_->scene.block).shape_angle;
    return &companions_.emplace(*after_transient_, shape_angle, sampled);
  }
  record_.verdict = *classification_.verdict;
  return nullptr;
}

inline Record HorizonRun::finish() {
  if (companions_) {
    const CompanionRun run = companions_->result();
    record_.effort.companion_periods += run.periods;
    record_.verdict = classification_.with_exponent(run.exponent);
  }
  return std::move(record_);
}

/// Runs it on one lane. Throws base::Stopped once it is asked to stop.
[[nodiscard]] inline Record run_alone(HorizonRun& run, base::StopRequest stop) {
  while (!run.motion().ended() || run.go_on()) {
    stop.check();
    integrate::step(run.motion(), run.counts());
  }
  if (CompanionPair* companions = run.name()) run_alone(*companions, stop);
  return run.finish();
}

}  // namespace rocking::experiment
