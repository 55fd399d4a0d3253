#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <optional>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/motion_series.hpp"

namespace rocking::dynamics {

/// The numbers that a kind of base motion needs from one breakpoint to the next, for one motion or a pack.
template <class Kind, base::Lane Real>
using Piece = std::array<Real, Kind::piece_numbers>;

/// What each kind of base motion offers. Values are base accelerations over g; `amplitude` is the one in force times
/// `unit`.
template <class Kind>
concept BaseExcitation = requires(Kind kind, const Clock& clock, const Geometry& block, double amplitude,
                                  const Moment<double>& now, MotionSeries<double>& series) {
  { Kind::is_periodic } -> std::convertible_to<bool>;           // with the clock's period
  { Kind::has_vertical } -> std::convertible_to<bool>;          // 1 + alpha_v is not 1 throughout
  { Kind::bounds_acceleration } -> std::convertible_to<bool>;   // most_horizontal is finite
  { Kind::has_knots } -> std::convertible_to<bool>;             // pieces lie in a row; see RecordedExcitation::follow
  { Kind::piece_numbers } -> std::convertible_to<std::size_t>;  // of a Piece
  { kind.unit(block) } -> std::convertible_to<double>;          // alpha for amplitude 1
  { kind.horizontal(clock, amplitude) } -> std::convertible_to<double>;  // alpha now
  { kind.most_horizontal(amplitude) } -> std::convertible_to<double>;  // bound of abs(alpha), infinite where not known
  { kind.weight(clock) } -> std::convertible_to<double>;               // 1 + alpha_v now
  {
    kind.next_change(clock)
    } -> std::same_as<std::optional<Instant>>;                 // the next breakpoint: the series hold until then
  { kind.piece(clock) } -> std::same_as<Piece<Kind, double>>;  // until then
  // Series of alpha and, if vertical, 1 + alpha_v; also for packs.
  Kind::template expand<full_order>(series, Piece<Kind, double>{}, amplitude, now);
};

}  // namespace rocking::dynamics
