#include "evidence/long_run.hpp"

#include <algorithm>
#include <span>
#include <stdexcept>

namespace rocking::evidence {

LongRun::LongRun(const Condition& condition, const random::Draws& draws, int periods)
    : shape_angle_(dynamics::geometry_of(mean_block(condition.scene)).shape_angle),
      resolution_(std::max(1e-9, 1e3 * condition.tolerance)),
      random_(is_random_along_the_way(condition.scene)),
      orbits_(condition, draws),
      recorder_(dynamics::geometry_of(mean_block(condition.scene)), periods) {
  const Start start = start_of(condition.scene, draws);
  const int transient = condition.horizon.transient_periods;
  const auto beginning = begin_realisation(condition, draws, start, Strobe::poincare, transient);
  if (!is_periodic(condition.scene.excitation)) throw std::runtime_error("only a periodic excitation repeats");
  Motion motion = motion_of(condition.scene, beginning, recorder_);
  integrate::advance(motion);
  after_transient_ = motion;
  motion.extend(periods - transient);
  integrate::advance(motion);
  termination_ = motion.termination();
}

section::Classification LongRun::name(const Window& window, int exponent_periods,
                                      const section::Thresholds& thresholds) {
  const auto end = static_cast<std::size_t>(window.first + window.count);
  if (periods().size() < end) {
    const bool fell = termination_ == dynamics::Termination::overturned;
    return {.mode = {.kind = fell ? section::ResponseKind::overturned : section::ResponseKind::unresolved},
            .reason = {}};
  }
  const auto sampled =
      std::span(periods()).subspan(static_cast<std::size_t>(window.first), static_cast<std::size_t>(window.count));
  const auto pending = section::classify(
      {.periods = sampled,
       .random = random_,
       .resolution = resolution_,
       .thresholds = thresholds,
       .find_orbit = [this](const section::StrobePoint& near, int periods) { return orbits_.find(near, periods); }});
  if (pending.classification) return *pending.classification;
  const ExponentRun run = exponent(exponent_periods, pending);
  return pending.with_exponent(run.exponent, {.points = run.points, .exponent = run.over_all});
}

ExponentRun LongRun::exponent(int periods, const section::PendingClassification& pending) const {
  TangentRun run(*after_transient_, shape_angle_, periods);
  run_alone(run, pending);
  return run.result();
}

}  // namespace rocking::evidence
