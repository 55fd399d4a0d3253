#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/dynamics/contact.hpp"
#include "rocking/dynamics/termination.hpp"
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

struct Trajectory {
  std::vector<TrajectorySample> strobe;
  std::vector<TrajectoryEvent> events;
  std::uint64_t losses_of_contact = 0;          ///< downward crossings of N = 0
  std::optional<double> first_loss_of_contact;  ///< tau
  std::uint64_t contradictions = 0;  ///< instants at which neither sticking nor slipping agrees with the equations
  Termination termination = Termination::reached_horizon;
};

/// One realisation in full, over exactly `periods` excitation periods from its initial state.
[[nodiscard]] Trajectory trajectory_of(const Condition& condition, std::uint64_t seed, std::uint64_t realisation,
                                       std::int64_t periods);

}  // namespace rocking::experiment
