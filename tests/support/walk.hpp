#pragma once

#include <array>
#include <cstddef>

#include "rocking/dynamics/contact.hpp"
#include "rocking/integrate/hybrid.hpp"

namespace rocking::support {

/// An instant of a smooth piece of motion.
struct WalkNode {
  double tau;
  double weight;  ///< of Gauss's quadrature over the piece
  dynamics::State state;
};

inline constexpr std::size_t nodes_per_piece = 10;

/// A smooth piece of motion between two resets or ends of steps.
struct WalkPiece {
  std::array<WalkNode, nodes_per_piece> nodes;
  dynamics::State start;
  dynamics::State end;    ///< before the event at its end
  dynamics::State after;  ///< after it
  double start_tau;
  double end_tau;
  double kinetic_friction;  ///< mu_k in force; 0 without friction
  double static_friction;
  std::size_t first_event;  ///< in the log: the events at its end begin here
};

/// Advances a simulation to tau = `end` or to its own end, and calls the visitor for every smooth piece, sampled at the
/// nodes of Gauss's formula of order 20. It makes the steps itself; therefore no strobe point may be scheduled in that
/// time. False if it needed more than `most_pieces` pieces: time does not advance.
template <class Simulation, class Visit>
[[nodiscard]] bool walk(Simulation& simulation, double end, int most_pieces, Visit&& visit) {
  constexpr std::array<double, 5> abscissa{0.1488743389816312, 0.4333953941292472, 0.6794095682990244,
                                           0.8650633666889845, 0.9739065285171717};
  constexpr std::array<double, 5> weight{0.2955242247147529, 0.2692667193099963, 0.2190863625159820, 0.1494513491505806,
                                         0.0666713443086881};
  auto& motion = simulation.motion;
  const double resolution = motion.time_resolution();
  integrate::LoopCounts counts;
  for (int pieces = 0; !motion.ended() && motion.clock().tau() < end; ++pieces) {
    if (pieces == most_pieces) return false;
    auto coefficients = motion.coefficients();
    WalkPiece piece{
        .nodes = {},
        .start = motion.state(),
        .end = {},
        .after = {},
        .start_tau = motion.clock().tau(),
        .end_tau = 0.0,
        .kinetic_friction = coefficients.has_friction() ? coefficients.kinetic_friction(motion.clock()) : 0.0,
        .static_friction = coefficients.static_friction(),
        .first_event = simulation.log.events.size()};
    const double reach = motion.time_to_breakpoint();
    const double length = motion.expand(reach);
    if (motion.ended()) break;
    const auto [time, fired] =
        integrate::first_crossing(motion, length, integrate::uncleared_guards(motion, length), counts);
    simulation.log.strobes.clear();
    for (std::size_t i = 0; i < nodes_per_piece; ++i) {
      const double sign = i % 2 == 0 ? -1.0 : 1.0;
      const double x = 0.5 * time * (1.0 + sign * abscissa[i / 2]);
      motion.strobe(x);
      piece.nodes[i] = {piece.start_tau + x, 0.5 * time * weight[i / 2], simulation.log.strobes.back()};
    }
    motion.move(time);
    piece.end = motion.state();
    piece.end_tau = motion.clock().tau();
    motion.reset(fired, time >= reach - resolution);
    piece.after = motion.state();
    visit(piece);
  }
  return true;
}

}  // namespace rocking::support
