#pragma once

#include <concepts>
#include <limits>
#include <optional>

#include "rocking/dynamics/clock.hpp"

namespace rocking::dynamics {

/// Where the automaton gets what may fluctuate: friction, restitution, amplitude. A source may draw at random, play a list
/// or always say the same.
template <class Source>
concept CoefficientSource = requires(Source source, const Clock& clock, bool slipping) {
  { source.has_friction() } -> std::same_as<bool>;
  { source.static_friction() } -> std::convertible_to<double>;         // mu_s in force
  { source.kinetic_friction(clock) } -> std::convertible_to<double>;   // mu_k in force, never above mu_s
  { source.restitution() } -> std::convertible_to<double>;             // e of the coming impact; the next call, of the next
  { source.amplitude(clock) } -> std::convertible_to<double>;          // A_h in force
  source.stop();                                                       // V has become 0
  source.chatter_ended();
  // The next instant at which kinetic friction (looked at only while slipping) or the amplitude changes.
  { source.next_change(clock, slipping) } -> std::same_as<std::optional<Instant>>;
};

/// Nothing fluctuates.
struct ConstantCoefficients {
  double amplitude_value = 0.0;
  double restitution_value = 0.0;
  std::optional<double> static_value;   ///< mu_s; absent: the block cannot slide
  double kinetic_value = 0.0;           ///< mu_k

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
