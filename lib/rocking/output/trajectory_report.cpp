#include "rocking/output/trajectory_report.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <vector>

#include "rocking/base/number_text.hpp"

namespace rocking {
namespace {

TrajectoryScales scales_of(const dynamics::Block& block, TrajectoryUnits units) {
  if (units == TrajectoryUnits::normalised) return {};
  const dynamics::Geometry geometry = dynamics::geometry_of(block);
  const double psi = geometry.edges[0].shape_angle;
  const double p = geometry.frequency_parameter;
  return {.tilt = psi,
          .tilt_rate = psi * p,
          .right_share = geometry.edges[1].shape_angle / psi,
          .slip = geometry.half_diagonal,
          .slip_rate = geometry.half_diagonal * p,
          .frequency_parameter = p};
}

template <class Sample>
ReportedState state_of(const Sample& sample, const TrajectoryScales& scales) {
  const double share = scales.share(sample.tilt, sample.tilt_rate);
  return {.tilt = sample.tilt * scales.tilt * share,
          .tilt_rate = sample.tilt_rate * scales.tilt_rate * share,
          .slip = sample.slip * scales.slip,
          .slip_rate = sample.slip_rate * scales.slip_rate};
}

struct TimedRow {
  double time;
  int order;  ///< among rows of one time
  std::string text;
};

TimedRow row_of(int order, const std::string& name, double time, const ReportedState& state, const std::string& end) {
  std::string text = name;
  for (const double number : {time, state.tilt, state.tilt_rate, state.slip, state.slip_rate}) {
    text += ',' + base::shortest(number);
  }
  return {.time = time, .order = order, .text = text + ',' + end};
}

std::vector<TimedRow> rows_of(const TrajectoryReport& report) {
  std::vector<TimedRow> rows;
  for (const auto& [time, kind, state] : report.events) {
    rows.push_back(row_of(0, "event", time, state, ',' + std::string(to_string(kind))));
  }
  for (const auto& [period, time, state, contact] : report.strobe) {
    rows.push_back(row_of(1, "strobe", time, state, std::string(to_string(contact)) + ','));
  }
  for (const auto& [time, state, contact] : report.history) {
    rows.push_back(row_of(2, "sample", time, state, std::string(to_string(contact)) + ','));
  }
  std::ranges::stable_sort(rows, {}, [](const TimedRow& row) { return std::tuple(row.time, row.order); });
  return rows;
}

}  // namespace

TrajectoryScales TrajectoryReport::scales() const { return scales_of(block, units); }

std::optional<section::Backing> backing_of(const TrajectoryReport& report) {
  return report.reason ? section::backing_of(*report.reason) : std::nullopt;
}

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
  report.peaks.tilt *= scales.tilt * scales.share(trajectory.peak_sides[0], 0.0);
  report.peaks.tilt_rate *= scales.tilt_rate * scales.share(trajectory.peak_sides[1], 0.0);
  report.validity = {.losses_of_contact = trajectory.losses_of_contact,
                     .first_loss_of_contact = trajectory.first_loss_of_contact,
                     .losses_before_fall = trajectory.losses_before_fall,
                     .contradictions = trajectory.contradictions};
  if (auto& first = report.validity.first_loss_of_contact) first = scales.time_of(*first);
  report.energy = trajectory.energy;
  report.termination = trajectory.termination;
  if (trajectory.label) {
    report.mode = trajectory.label->mode;
    report.reason = trajectory.label->reason;
  }
  return report;
}

std::string trajectory_table(const TrajectoryReport& report) {
  std::string text = "# format: " + std::string(trajectory_document().format());
  text += "\n# condition: " + std::to_string(report.key.condition);
  text += "\n# realisation: " + std::to_string(report.key.realisation);
  text += "\n# units: " + std::string(trajectory_unit_names[static_cast<std::size_t>(report.units)]);
  const Json block = block_fields().json(&report.block);
  for (const auto& [name, value] : block.items()) text += "\n# " + name + ": " + value.dump();
  text += "\n# termination: " + std::string(to_string(report.termination));
  if (report.mode) text += "\n# mode: " + to_string(*report.mode);
  if (const auto backing = backing_of(report)) text += "\n# backed_by: " + std::string(to_string(*backing));
  text += report.units == TrajectoryUnits::si ? "\nrow,time_s,tilt_rad,tilt_rate_rad_s,slip_m,slip_rate_m_s"
                                              : "\nrow,tau,tilt,tilt_rate,slip,slip_rate";
  text += ",contact,event\n";
  for (const TimedRow& row : rows_of(report)) text += row.text + '\n';
  return text;
}

}  // namespace rocking
