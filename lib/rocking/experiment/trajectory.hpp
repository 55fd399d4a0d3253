#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/termination.hpp"
#include "rocking/experiment/energy_account.hpp"
#include "rocking/experiment/experiment.hpp"

namespace rocking::experiment {

using dynamics::Termination;

/// State at tau = 2 pi period/Omega_h, after the events of that instant.
struct TrajectorySample {
  std::int64_t period;
  double tilt;       ///< Theta
  double tilt_rate;  ///< Theta'
  double slip;       ///< X
  double slip_rate;  ///< V
  dynamics::ContactState contact;
};

/// Something that happened, with the state after it.
struct TrajectoryEvent {
  double tau;
  dynamics::EventKind kind;
  double tilt;       ///< Theta
  double tilt_rate;  ///< Theta'
  double slip;       ///< X
  double slip_rate;  ///< V
};

/// State at an instant between strobes, after its events.
struct HistorySample {
  double tau;
  double tilt;       ///< Theta
  double tilt_rate;  ///< Theta'
  double slip;       ///< X
  double slip_rate;  ///< V
  dynamics::ContactState contact;
};

struct Trajectory {
  std::vector<TrajectorySample> strobe;
  std::vector<TrajectoryEvent> events;
  std::vector<HistorySample> history;           ///< from tau = 0 on; empty where none was asked for
  int samples_per_period = 0;                   ///< of the history
  std::uint64_t losses_of_contact = 0;          ///< downward crossings of N = 0
  std::optional<double> first_loss_of_contact;  ///< tau
  std::uint64_t contradictions = 0;  ///< instants at which neither sticking nor slipping agrees with the equations
  EnergyAccount energy;
  Termination termination = Termination::reached_horizon;
};

/// How much of a realisation is wanted.
struct TrajectoryExtent {
  TrajectoryExtent(std::int64_t all_periods, int history_samples = 0)
      : periods(all_periods), samples_per_period(history_samples) {}

  std::int64_t periods;    ///< of the excitation, exactly so many from the initial state; at least 1
  int samples_per_period;  ///< of the history; 0: no history
};

/// One realisation in full. A history changes nothing else of it.
[[nodiscard]] Trajectory trajectory_of(const Condition& condition, std::uint64_t seed, std::uint64_t realisation,
                                       const TrajectoryExtent& extent);

}  // namespace rocking::experiment
