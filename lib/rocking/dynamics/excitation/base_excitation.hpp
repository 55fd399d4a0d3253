#pragma once

#include <concepts>
#include <cstdint>
#include <optional>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/motion_series.hpp"

namespace rocking::dynamics {

/// What each kind of base motion offers. Values are base accelerations over g; `amplitude` is the one in force times `unit`.
template <class Kind>
concept BaseExcitation = requires(Kind kind, const Clock& clock, const Geometry& block, double amplitude,
                                  MotionSeries<double>& series) {
  { Kind::is_periodic } -> std::convertible_to<bool>;                    // with the clock's period
  { Kind::has_vertical } -> std::convertible_to<bool>;                   // 1 + alpha_v is not 1 throughout
  { Kind::runs_in_lanes } -> std::convertible_to<bool>;                  // a pack can expand its series
  { kind.unit(block) } -> std::convertible_to<double>;                   // alpha for amplitude 1
  { kind.horizontal(clock, amplitude) } -> std::convertible_to<double>;  // alpha now
  { kind.most_horizontal(amplitude) } -> std::convertible_to<double>;  // bound of abs(alpha), infinite where not known
  { kind.weight(clock) } -> std::convertible_to<double>;               // 1 + alpha_v now
  {
    kind.next_change(clock)
    } -> std::same_as<std::optional<Instant>>;                   // the next breakpoint: the series hold until then
  { kind.segments_looked_up() } -> std::same_as<std::uint64_t>;  // of a record
  kind.template expand<full_order>(series, clock, amplitude);    // series of alpha and, if vertical, 1 + alpha_v
};

}  // namespace rocking::dynamics
