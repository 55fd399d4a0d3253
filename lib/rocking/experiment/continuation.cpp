#include "rocking/experiment/continuation.hpp"

#include "rocking/experiment/horizon_run.hpp"
#include "rocking/experiment/strobe_recorder.hpp"

namespace rocking::experiment {
namespace {

using HarmonicMotion = Motion<dynamics::HarmonicExcitation>;

/// `clock` at the same count of periods and the same part of a period as `now`.
dynamics::Clock in_step_with(const dynamics::Clock& now, dynamics::Clock clock) {
  const double stretch = clock.period_length() / now.period_length();
  clock.set({.period = now.now().period, .time = now.now().time * stretch});
  return clock;
}

}  // namespace

Record Continuation::run(const Condition& condition) {
  StrobeRecorder recorder(dynamics::geometry_of(condition.scene.block).shape_angle,
                          condition.horizon.transient_periods + condition.horizon.sampled_periods);
  const std::int64_t strobes = strobes_before_copy(condition);
  const Start start = start_of(condition.scene, draws_);
  const Beginning beginning = begin_realisation(condition, draws_, start, Strobe::poincare, strobes);
  if (motion_) {
    motion_->observe_with(recorder);
    motion_->go_on_under(beginning.setting, in_step_with(motion_->clock(), beginning.clock),
                         motion_->coefficients().under(condition.scene), strobes);
  } else {
    motion_.emplace(beginning.setting, beginning.clock, beginning.coefficients, beginning.state, beginning.schedule,
                    recorder);
  }
  Record record;
  run_to_horizon(record, *motion_, recorder, condition);
  if (record.termination == dynamics::Termination::reached_horizon) {
    motion_->move_to_last_strobe();
  } else {
    motion_.reset();
  }
  return record;
}

}  // namespace rocking::experiment
