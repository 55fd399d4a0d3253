#pragma once

#include <concepts>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>

#include "rocking/dynamics/clock.hpp"

namespace rocking::dynamics {

/// Kinetic friction over an interval of its grid.
struct FrictionInterval {
  double kinetic_friction;  ///< mu_k, at most mu_s
  Instant end;
};

/// Where the automaton gets what may fluctuate: friction, restitution, amplitude. A source may draw at random, play a list
/// or always say the same.
template <class Source>
concept CoefficientSource = requires(Source source, const Clock& clock, bool slipping) {
  { source.has_friction() } -> std::same_as<bool>;
  { source.static_friction() } -> std::convertible_to<double>;        // mu_s in force
  { source.kinetic_friction(clock) } -> std::convertible_to<double>;  // mu_k in force, never above mu_s
  { source.restitution() } -> std::convertible_to<double>;     // e of the coming impact; the next call, of the next
  { source.amplitude(clock) } -> std::convertible_to<double>;  // A_h in force
  source.stop();                                               // V has become 0
  source.chatter_ended();
  // The next instant at which kinetic friction (looked at only while slipping) or the amplitude changes.
  { source.next_change(clock, slipping) } -> std::same_as<std::optional<Instant>>;
};

/// A source that can tell beforehand what kinetic friction will be, so that slip may go on elsewhere from interval to interval.
template <class Source>
concept ForeseesFriction = CoefficientSource<Source> &&
    requires(Source source, const Clock& clock, std::span<FrictionInterval> coming) {
  { source.foresee(clock, coming) } -> std::same_as<std::size_t>;  // of the intervals after the present one, how many
  source.pass_intervals(clock, std::size_t{});  // the clock has gone on by as many, the block slipping
};

/// Nothing fluctuates.
struct ConstantCoefficients {
  double amplitude_value = 0.0;
  double restitution_value = 0.0;
  std::optional<double> static_value;  ///< mu_s; absent: the block cannot slide
  double kinetic_value = 0.0;          ///< mu_k

  [[nodiscard]] bool has_friction() const { return static_value.has_value(); }
  [[nodiscard]] double static_friction() const {
    return static_value.value_or(std::numeric_limits<double>::infinity());
  }
  [[nodiscard]] double kinetic_friction(const Clock&) const { return kinetic_value; }
  [[nodiscard]] double restitution() const { return restitution_value; }
  [[nodiscard]] double amplitude(const Clock&) const { return amplitude_value; }
  void stop() {}
  void chatter_ended() {}
  [[nodiscard]] std::optional<Instant> next_change(const Clock&, bool) const { return std::nullopt; }
};

}  // namespace rocking::dynamics
