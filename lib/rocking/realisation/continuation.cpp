#include "rocking/realisation/continuation.hpp"

#include "rocking/realisation/horizon_run.hpp"
#include "rocking/scene/check_condition.hpp"

namespace rocking {
namespace {

/// `clock`, set to the same count of periods and the same fraction of a period as `now`.
dynamics::Clock in_step_with(const dynamics::Clock& now, dynamics::Clock clock) {
  const double stretch = clock.period_length() / now.period_length();
  clock.set({.period = now.now().period, .time = now.now().time * stretch});
  return clock;
}

}  // namespace

RealisationResult Continuation::run(const Condition& of_sweep) {
  check_condition(of_sweep);
  Condition condition = of_sweep;
  condition.horizon.until_classified.reset();  // every step of a sweep is as long as the others
  const std::int64_t strobes = strobes_before_window(condition);
  const Start start = start_of(condition.scene, draws_);
  const Beginning beginning = begin_realisation(condition, draws_, start, Strobe::poincare, strobes);
  HorizonRun run(condition, draws_, beginning, [&](dynamics::Observer& observer) {
    if (!motion_) return motion_of(condition.scene, beginning, observer);
    motion_->observe_with(observer);
    motion_->go_on_under(beginning.setting, in_step_with(motion_->clock(), beginning.clock),
                         motion_->coefficients().under(beginning.coefficients),
                         excitation_of(condition.scene, beginning), strobes);
    return *motion_;
  });
  RealisationResult result = run_alone(run, stop_);
  motion_.reset();
  if (result.termination == dynamics::Termination::reached_horizon) {
    motion_ = run.motion();
    motion_->move_to_last_strobe();
  }
  return result;
}

}  // namespace rocking
