#include "rocking/experiment/trajectory.hpp"

#include <utility>

#include "rocking/experiment/realisation.hpp"

namespace rocking::experiment {
namespace {

/// Keeps everything, in the units of files.
class Recorder final : public dynamics::Observer {
 public:
  explicit Recorder(double shape_angle) : shape_angle_(shape_angle) {}

  void event(dynamics::EventKind kind, double tau, const dynamics::State& state) override {
    trajectory.events.push_back({.tau = tau,
                                 .kind = kind,
                                 .tilt = state.tilt / shape_angle_,
                                 .tilt_rate = state.tilt_rate / shape_angle_,
                                 .slip = state.slip,
                                 .slip_rate = state.slip_rate});
  }

  void strobe(const dynamics::State& state) override {
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
};

}  // namespace

Trajectory trajectory_of(const Condition& condition, std::uint64_t seed, std::uint64_t realisation,
                         std::int64_t periods) {
  const random::Draws draws(seed, realisation);
  Recorder recorder(dynamics::geometry_of(condition.scene.block).shape_angle);
  const Beginning beginning =
      begin_realisation(condition, draws, start_of(condition.scene, draws), Strobe::start, periods);
  with_motion(condition.scene, beginning, recorder, [&](auto motion) {
    integrate::advance(motion);
    Trajectory& trajectory = recorder.trajectory;
    trajectory.termination = motion.termination().value_or(Termination::stopped);
    trajectory.losses_of_contact = motion.losses_of_contact();
    if (motion.losses_of_contact() > 0) trajectory.first_loss_of_contact = motion.first_loss_of_contact();
    trajectory.contradictions = motion.contradictions();
  });
  return std::move(recorder.trajectory);
}

}  // namespace rocking::experiment
