#include "rocking/realisation/trajectory.hpp"

#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/realisation/accounted_motion.hpp"
#include "rocking/realisation/sampled_motion.hpp"
#include "rocking/realisation/start.hpp"
#include "rocking/scene/check_condition.hpp"

namespace rocking {
namespace {

/// Records strobe points and events, in the units of files.
class Recorder final : public dynamics::Observer {
 public:
  Recorder(double shape_angle, base::StopRequest stop) : shape_angle_(shape_angle), stop_(stop) {}

  void event(dynamics::EventKind kind, double tau, const dynamics::State& state) override {
    trajectory.events.push_back({.tau = tau,
                                 .kind = kind,
                                 .tilt = state.tilt / shape_angle_,
                                 .tilt_rate = state.tilt_rate / shape_angle_,
                                 .slip = state.slip,
                                 .slip_rate = state.slip_rate});
  }

  void strobe(const dynamics::State& state) override {
    stop_.check();  // a block at rest passes many periods in one step
    trajectory.strobe.push_back({.period = static_cast<std::int64_t>(trajectory.strobe.size()) + 1,
                                 .tilt = state.tilt / shape_angle_,
                                 .tilt_rate = state.tilt_rate / shape_angle_,
                                 .slip = state.slip,
                                 .slip_rate = state.slip_rate,
                                 .contact = state.contact});
  }

  Trajectory trajectory;

 private:
  double shape_angle_;
  base::StopRequest stop_;
};

template <class Motion>
void advance(Motion& motion, base::StopRequest stop) {
  for (integrate::LoopCounts counts; !motion.ended(); integrate::step(motion, counts)) stop.check();
}

/// Runs the motion to its end and samples it.
template <class Motion>
void run(Motion& motion, const Beginning& beginning, const TrajectoryExtent& extent,
         std::vector<HistoryPoint>& history) {
  if (extent.samples_per_period == 0) {
    advance(motion, extent.stop);
    return;
  }
  SampledMotion<Motion> sampled(motion, extent.samples_per_period, beginning.clock.period_length(), history);
  advance(sampled, extent.stop);
}

std::vector<HistorySample> in_units_of_files(const std::vector<HistoryPoint>& points, double shape_angle) {
  std::vector<HistorySample> history;
  history.reserve(points.size());
  for (const auto& [tau, state, base_acceleration] : points) {
    history.push_back({.tau = tau,
                       .tilt = state.tilt / shape_angle,
                       .tilt_rate = state.tilt_rate / shape_angle,
                       .slip = state.slip,
                       .slip_rate = state.slip_rate,
                       .contact = state.contact,
                       .base_acceleration = base_acceleration});
  }
  return history;
}

}  // namespace

std::string_view to_string(TrajectoryUnits units) {
  switch (units) {
    case TrajectoryUnits::normalised: return "normalised";
    case TrajectoryUnits::si: return "si";
  }
  return "";
}

Trajectory trajectory_of(const Condition& condition, std::uint64_t seed, std::uint64_t realisation,
                         const TrajectoryExtent& extent) {
  check_condition(condition);
  return trajectory_of_unchecked(condition, seed, realisation, extent);
}

Trajectory trajectory_of_unchecked(const Condition& condition, std::uint64_t seed, std::uint64_t realisation,
                                   const TrajectoryExtent& extent) {
  ROCKING_EXPECT(extent.periods > 0);
  const random::Draws draws(seed_of(condition, seed), realisation);
  const Start start = start_of(condition.scene, draws);
  const double shape_angle = start.geometry.shape_angle;
  Recorder recorder(shape_angle, extent.stop);
  std::vector<HistoryPoint> history;
  const Beginning beginning = begin_realisation(condition, draws, start, Strobe::start, extent.periods);
  AccountedMotion motion(motion_of(condition.scene, beginning, recorder), beginning.setting);
  run(motion, beginning, extent, history);
  Trajectory& trajectory = recorder.trajectory;
  trajectory.block = start.block;
  trajectory.period_length = beginning.clock.period_length();
  trajectory.termination = motion.termination().value_or(Termination::stopped);
  trajectory.losses_of_contact = motion.losses_of_contact();
  if (motion.losses_of_contact() > 0) trajectory.first_loss_of_contact = motion.first_loss_of_contact();
  trajectory.losses_before_fall = motion.losses_before_fall();
  trajectory.peaks = peaks_of(motion, beginning.setting.block);
  trajectory.contradictions = motion.contradictions();
  trajectory.energy = motion.account();
  trajectory.samples_per_period = extent.samples_per_period;
  trajectory.history = in_units_of_files(history, shape_angle);
  return std::move(recorder.trajectory);
}

}  // namespace rocking
