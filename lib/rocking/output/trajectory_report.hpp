#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/fields/document.hpp"
#include "rocking/realisation/trajectory.hpp"
#include "rocking/store/summary.hpp"

namespace rocking {

/// Values of the units of a trajectory, over the normalised ones.
struct TrajectoryScales {
  double tilt = 1.0;         ///< on the left side
  double tilt_rate = 1.0;    ///< on the left side
  double right_share = 1.0;  ///< both on the right side over those on the left
  double slip = 1.0;
  double slip_rate = 1.0;
  double frequency_parameter = 1.0;  ///< tau over the time

  /// Both over those on the left side, of the block on the side of this tilt, or of its rate where the tilt is 0.
  [[nodiscard]] double share(double theta, double rate) const {
    return (theta != 0.0 ? theta : rate) < 0.0 ? right_share : 1.0;
  }
  [[nodiscard]] double time_of(double tau) const { return tau / frequency_parameter; }
};

/// Tilt and slip with their rates, in the units of the trajectory, as everything here.
struct ReportedState {
  double tilt = 0.0;
  double tilt_rate = 0.0;
  double slip = 0.0;
  double slip_rate = 0.0;
};

/// After the events of that instant.
struct ReportedStrobe {
  std::int64_t period = 0;
  double time = 0.0;
  ReportedState state;
  dynamics::ContactState contact = dynamics::ContactState::rest;
};

/// With the state after it.
struct ReportedEvent {
  double time = 0.0;
  dynamics::EventKind kind = dynamics::EventKind::lift;
  ReportedState state;
};

struct ReportedSample {
  double time = 0.0;
  ReportedState state;
  dynamics::ContactState contact = dynamics::ContactState::rest;
};

/// Departures from the model.
struct TrajectoryValidity {
  std::uint64_t losses_of_contact = 0;
  std::optional<double> first_loss_of_contact;  ///< time
  std::uint64_t losses_before_fall = 0;
  std::uint64_t contradictions = 0;
};

/// The trajectory of one realisation, in one of the units.
struct TrajectoryReport {
  RealisationKey key;
  TrajectoryUnits units = TrajectoryUnits::normalised;
  dynamics::Block block;
  std::vector<ReportedStrobe> strobe;
  std::vector<ReportedEvent> events;
  std::optional<int> samples_per_period;  ///< of the history; absent: it is empty
  std::vector<ReportedSample> history;
  PeakValues peaks;  ///< tilt and tilt_rate in the units of the trajectory
  TrajectoryValidity validity;
  EnergyAccount energy;  ///< normalised in either unit, since the mass is not known
  dynamics::Termination termination = dynamics::Termination::reached_horizon;
  std::optional<section::ResponseMode> mode;  ///< that a run gives this realisation; absent with a number of periods
  std::optional<section::Reason> reason;      ///< of the mode; absent where no rule was needed

  [[nodiscard]] TrajectoryScales scales() const;
};

/// What backs its label (m,n); absent of another one, or without a label.
[[nodiscard]] std::optional<section::Backing> backing_of(const TrajectoryReport& report);

[[nodiscard]] TrajectoryReport trajectory_report(const RealisationKey& key, const Trajectory& trajectory,
                                                 TrajectoryUnits units);

/// Of the block of a realisation, with the scales that follow from it.
[[nodiscard]] const StructType& block_fields();

[[nodiscard]] const StructType& fields_of(const TrajectoryReport*);

/// The output of `rocking trajectory`: a line for each strobe point and each event.
[[nodiscard]] const DocumentOf<TrajectoryReport>& trajectory_document();

/// The same as a table for spreadsheets: lines of metadata that start with `#`, a line of column names, and a row for
/// each strobe point, event and sample of the history, by time. Of rows with equal times, events come first, because
/// the other states are those after the events.
[[nodiscard]] std::string trajectory_table(const TrajectoryReport& report);

}  // namespace rocking
