#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "rocking/dynamics/clock.hpp"

namespace rocking::dynamics {

/// What is known beforehand of kinetic friction, which changes at the boundaries of a grid.
struct FrictionForesight {
  /// Of the present interval and of those to come, before it is held between 0 and mu_s; empty if nothing is known.
  std::span<const double> wanted;
  std::int64_t per_period = 1;     ///< intervals of the grid
  std::int64_t next_boundary = 0;  ///< where the present interval ends: its number within its period
};

/// Boundary number `index` of a period that has `per_period` of them; number 0 is where a run starts.
[[nodiscard]] inline Instant grid_boundary(const Clock& clock, std::int64_t period, std::int64_t index,
                                           std::int64_t per_period) {
  const double time = static_cast<double>(index) * clock.period_length() / static_cast<double>(per_period);
  return {.period = period, .time = clock.start() + time};
}

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

/// A source that can tell beforehand what will be in force, so that a motion may go on elsewhere (module lanes).
template <class Source>
concept ForeseesCoefficients = CoefficientSource<Source> && requires(Source source, const Clock& clock) {
  { source.constant_restitution() } -> std::same_as<std::optional<double>>;  // absent: every impact asks for its own
  { source.foresee() } -> std::same_as<FrictionForesight>;                   // until the next change of the source
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
