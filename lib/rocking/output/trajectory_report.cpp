#include "rocking/output/trajectory_report.hpp"

namespace rocking {
namespace {

TrajectoryScales scales_of(const dynamics::Block& block, TrajectoryUnits units) {
  if (units == TrajectoryUnits::normalised) return {};
  const dynamics::Geometry geometry = dynamics::geometry_of(block);
  const double psi = geometry.shape_angle;
  const double p = geometry.frequency_parameter;
  return {.tilt = psi,
          .tilt_rate = psi * p,
          .slip = geometry.half_diagonal,
          .slip_rate = geometry.half_diagonal * p,
          .frequency_parameter = p};
}

template <class Sample>
ReportedState state_of(const Sample& sample, const TrajectoryScales& scales) {
  return {.tilt = sample.tilt * scales.tilt,
          .tilt_rate = sample.tilt_rate * scales.tilt_rate,
          .slip = sample.slip * scales.slip,
          .slip_rate = sample.slip_rate * scales.slip_rate};
}

}  // namespace

TrajectoryScales TrajectoryReport::scales() const { return scales_of(block, units); }

TrajectoryReport trajectory_report(const RealisationKey& key, const Trajectory& trajectory, TrajectoryUnits units) {
  const TrajectoryScales scales = scales_of(trajectory.block, units);
  TrajectoryReport report;
  report.key = key;
  report.units = units;
  report.block = trajectory.block;
  for (const TrajectorySample& sample : trajectory.strobe) {
    report.strobe.push_back({.period = sample.period,
                             .time = scales.time_of(static_cast<double>(sample.period) * trajectory.period_length),
                             .state = state_of(sample, scales),
                             .contact = sample.contact});
  }
  for (const TrajectoryEvent& event : trajectory.events) {
    report.events.push_back({.time = scales.time_of(event.tau), .kind = event.kind, .state = state_of(event, scales)});
  }
  for (const HistorySample& sample : trajectory.history) {
    report.history.push_back(
        {.time = scales.time_of(sample.tau), .state = state_of(sample, scales), .contact = sample.contact});
  }
  if (!trajectory.history.empty()) report.samples_per_period = trajectory.samples_per_period;
  report.peaks = trajectory.peaks;
  report.peaks.tilt *= scales.tilt;
  report.peaks.tilt_rate *= scales.tilt_rate;
  report.validity = {.losses_of_contact = trajectory.losses_of_contact,
                     .first_loss_of_contact = trajectory.first_loss_of_contact,
                     .losses_before_fall = trajectory.losses_before_fall,
                     .contradictions = trajectory.contradictions};
  if (auto& first = report.validity.first_loss_of_contact) first = scales.time_of(*first);
  report.energy = trajectory.energy;
  report.termination = trajectory.termination;
  return report;
}

}  // namespace rocking
