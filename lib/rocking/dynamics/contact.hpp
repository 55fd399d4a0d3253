#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rocking::dynamics {

/// How the block touches the base: the discrete state of the hybrid automaton.
enum class ContactState : std::uint8_t { rest, slide, rock, rock_slide, overturned };

[[nodiscard]] inline bool is_rocking(ContactState contact) {
  return contact == ContactState::rock || contact == ContactState::rock_slide;
}

[[nodiscard]] inline bool is_sliding(ContactState contact) {
  return contact == ContactState::slide || contact == ContactState::rock_slide;
}

/// Kinds of events.
enum class EventKind : std::uint8_t {
  lift,          ///< full contact to rocking without slip
  impact_stick,  ///< the other edge lands; no slip afterwards
  impact_slip,   ///< the other edge lands; the block slips afterwards
  slip_start,    ///< rocking: friction is exhausted
  slip_stop,     ///< rocking: slip ends
  slip_reverse,  ///< V = 0, and slip or sliding goes on, in either direction
  slide_start,   ///< full contact: friction is exhausted
  slide_stop,    ///< full contact: sliding ends in rest
  to_rest,       ///< a chatter ends, without slip
  to_slide,      ///< a chatter ends, sliding
  tip,           ///< a sliding block tips over its edge: mu_k has come to exceed tan(psi)
  past_balance,  ///< abs(Theta) = 1 for the first time
  overturn,      ///< abs(theta) = pi/2
};

/// Spelled as in reports and tables, in the order of the enumerations.
inline constexpr std::array<std::string_view, 5> contact_names{"rest", "slide", "rock", "rock_slide", "overturned"};
inline constexpr std::array<std::string_view, 13> event_names{
    "lift",       "impact_stick", "impact_slip", "slip_start", "slip_stop",    "slip_reverse", "slide_start",
    "slide_stop", "to_rest",      "to_slide",    "tip",        "past_balance", "overturn"};
inline constexpr std::size_t event_kind_count = event_names.size();

[[nodiscard]] inline std::string_view to_string(ContactState state) {
  return contact_names[static_cast<std::size_t>(state)];
}
[[nodiscard]] inline std::string_view to_string(EventKind kind) { return event_names[static_cast<std::size_t>(kind)]; }

/// Where a block falls: over its left edge (theta > 0) or over its right one.
enum class Side : std::uint8_t { left, right };
inline constexpr std::array<std::string_view, 2> side_names{"left", "right"};
[[nodiscard]] inline std::string_view to_string(Side side) { return side_names[static_cast<std::size_t>(side)]; }

/// State of the block: positions, rates, contact. Normalised: time by p, slip by R.
struct State {
  double tilt = 0.0;            ///< theta [rad], counter-clockwise > 0
  double tilt_rate = 0.0;       ///< w = dtheta/dtau [rad]
  double slip = 0.0;            ///< X, of the contact edge relative to the base, over R
  double slip_rate = 0.0;       ///< V = dX/dtau
  double side = 1.0;            ///< S: +1 about the left edge, -1 about the right; meaningless in full contact
  double slip_direction = 1.0;  ///< s: sign of V; meaningless without slip
  ContactState contact = ContactState::rest;
};

/// Why a realisation ended.
enum class Termination : std::uint8_t {
  reached_horizon,
  overturned,  ///< abs(theta) reached pi/2
  painleve,    ///< D <= 0, or 1 + 3q <= 0 in an impact: the model has no solution
  stopped,     ///< more events or steps than a budget allows
};

inline constexpr std::array terminations{Termination::reached_horizon, Termination::overturned, Termination::painleve,
                                         Termination::stopped};
inline constexpr std::array<std::string_view, terminations.size()> termination_names{"reached_horizon", "overturned",
                                                                                     "painleve", "stopped"};

[[nodiscard]] inline std::string_view to_string(Termination termination) {
  return termination_names[static_cast<std::size_t>(termination)];
}

/// Inertia in the slip equations. `edge` is Jeong & Yang's Eq. 7 as printed; energy does not balance with it.
enum class SlideInertia : std::uint8_t { centroidal, edge };

/// When an impact slips. `signed_ratio` (spelled `signed`) is Jeong & Yang's Eq. 26 without absolute values.
enum class ImpactSlipRule : std::uint8_t { absolute, signed_ratio };

/// J: inertia over m R^2, 1/3 about the centre of mass, 4/3 about the edge.
[[nodiscard]] constexpr double inertia_ratio(SlideInertia inertia) {
  return inertia == SlideInertia::centroidal ? 1.0 / 3.0 : 4.0 / 3.0;
}

}  // namespace rocking::dynamics
