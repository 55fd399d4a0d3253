#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "rocking/base/stop_request.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/realisation/measures.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/classification.hpp"

namespace rocking {

/// The state at an instant of the section, and the contact state then.
struct SectionState {
  section::StrobePoint point;
  dynamics::ContactState contact = dynamics::ContactState::rest;
};

/// Energy balance of a realisation, over m R^2 p^2, in the frame of the base. The work of the base is that of the
/// inertia force - (4/3) alpha on the centre of mass (and of - (4/3) alpha_v).
struct EnergyAccount {
  double at_start = 0.0;  ///< kinetic energy plus (4/3) cos(phi) of the weight
  double at_end = 0.0;
  double base_work = 0.0;
  double friction_work = 0.0;      ///< of kinetic friction; never > 0 while N > 0
  double lost_in_impacts = 0.0;    ///< including what the end of a chatter neglects
  double gained_in_impacts = 0.0;  ///< energy added by some impacts; 0 except for squat blocks with e > 1/3

  /// Difference that the equations of motion leave unexplained: 0 to within rounding and tolerance if the mechanics is
  /// right.
  [[nodiscard]] double unaccounted() const {
    return at_end - at_start - base_work - friction_work - gained_in_impacts + lost_in_impacts;
  }
};

using dynamics::Termination;

/// State at tau = 2 pi period/Omega_h, after the events of that instant.
struct TrajectorySample {
  std::int64_t period;
  double tilt;       ///< Theta [-]
  double tilt_rate;  ///< Theta' [-]
  double slip;       ///< X [-]
  double slip_rate;  ///< V [-]
  dynamics::ContactState contact;
};

/// An event, with the state after it.
struct TrajectoryEvent {
  double tau;
  dynamics::EventKind kind;
  double tilt;       ///< Theta [-]
  double tilt_rate;  ///< Theta' [-]
  double slip;       ///< X [-]
  double slip_rate;  ///< V [-]
};

/// State at an instant between strobes, after the events of that instant.
struct HistorySample {
  double tau;
  double tilt;       ///< Theta [-]
  double tilt_rate;  ///< Theta' [-]
  double slip;       ///< X [-]
  double slip_rate;  ///< V [-]
  dynamics::ContactState contact;
  double base_acceleration;  ///< alpha: horizontal acceleration of the base, over g
};

struct Trajectory {
  dynamics::Block block;       ///< of this realisation
  BlockOutline outline;        ///< of the same, to draw
  double period_length = 0.0;  ///< 2 pi/Omega_h: tau between two strobe points
  std::vector<TrajectorySample> strobe;
  std::vector<TrajectoryEvent> events;
  std::vector<HistorySample> history;           ///< from tau = 0 on; empty if none was requested
  int samples_per_period = 0;                   ///< of the history
  std::uint64_t losses_of_contact = 0;          ///< downward crossings of N = 0
  std::optional<double> first_loss_of_contact;  ///< tau, if there was one
  std::uint64_t losses_before_fall = 0;         ///< of them, without those of the final fall
  PeakValues peaks;
  std::array<double, 2> peak_sides{1.0,
                                   1.0};  ///< of the block at the largest abs(Theta) and abs(Theta'): +1 left, -1 right
  std::uint64_t contradictions = 0;       ///< instants at which neither sticking nor slipping agrees with the equations
  EnergyAccount energy;
  Termination termination = Termination::reached_horizon;
  /// What a run calls this realisation; absent if it was followed for another number of periods than that of its horizon.
  std::optional<section::Classification> label = std::nullopt;
};

/// Units of the states and times in which a trajectory is written: Theta, Theta', X, V and tau; or rad, rad/s, m, m/s and s, for
/// the block of the realisation.
enum class TrajectoryUnits : std::uint8_t { normalised, si };

inline constexpr std::array<std::string_view, 2> trajectory_unit_names{"normalised", "si"};

/// Requested length and sampling of a trajectory.
struct TrajectoryExtent {
  TrajectoryExtent(std::int64_t all_periods, int history_samples = 0, base::StopRequest stop_request = {})
      : periods(all_periods), samples_per_period(history_samples), stop(stop_request) {}

  std::int64_t periods;    ///< excitation periods from the initial state; at least 1
  int samples_per_period;  ///< samples of the history; 0: no history
  base::StopRequest stop;
};

/// The trajectory of one realisation. Its other results do not depend on whether a history is requested. Throws
/// base::InputError if check_condition does, and base::Stopped if it is asked to stop.
[[nodiscard]] Trajectory trajectory_of(const Condition& condition, std::uint64_t seed, std::uint64_t realisation,
                                       const TrajectoryExtent& extent);

/// The same of a condition that was checked, or that breaks a rule on purpose; its numbers are finite.
[[nodiscard]] Trajectory trajectory_of_unchecked(const Condition& condition, std::uint64_t seed,
                                                 std::uint64_t realisation, const TrajectoryExtent& extent);

}  // namespace rocking
