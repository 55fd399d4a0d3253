#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "rocking/dynamics/clock.hpp"

namespace rocking::dynamics {

/// Kinetic friction of the present and the coming intervals of its refresh grid, as far as it is drawn already.
struct KnownIntervals {
  /// mu_k of each interval before the clamp to [0, mu_s], the present one first; empty if nothing is known.
  std::span<const double> wanted;
  std::int64_t per_period = 1;     ///< intervals of the grid
  std::int64_t next_boundary = 0;  ///< number, within its period, of the boundary at the end of the present interval
};

inline constexpr std::int64_t most_known_intervals = 64;  ///< a power of two

/// Boundary number `index` of a period that has `per_period` of them; a run starts at number 0.
[[nodiscard]] inline Instant grid_boundary(const Clock& clock, std::int64_t period, std::int64_t index,
                                           std::int64_t per_period) {
  const double time = static_cast<double>(index) * clock.period_length() / static_cast<double>(per_period);
  return {.period = period, .time = clock.start() + time};
}

/// Source of the coefficients that may fluctuate: friction, restitution, amplitude. It may draw them at random, read
/// them from a list, or return constants.
template <class Source>
concept CoefficientSource = requires(Source source, const Clock& clock, bool slipping) {
  { source.has_friction() } -> std::same_as<bool>;
  { source.static_friction() } -> std::convertible_to<double>;        // mu_s in force
  { source.kinetic_friction(clock) } -> std::convertible_to<double>;  // mu_k in force, never above mu_s
  // e of the coming impact, in which the edge of a side with this sign lands. Each call returns that of another impact.
  { source.restitution(1.0) } -> std::convertible_to<double>;
  { source.amplitude(clock) } -> std::convertible_to<double>;  // A_h in force
  source.stop();                                               // V has become 0
  source.chatter_ended();
  // The next instant at which kinetic friction (only while slipping) or the amplitude changes.
  { source.next_change(clock, slipping) } -> std::same_as<std::optional<Instant>>;
};

/// A source that can also say which coefficients will be in force, so that lanes can compute several steps in a row.
template <class Source>
concept KnowsComingCoefficients = CoefficientSource<Source> && requires(Source source, const Clock& clock) {
  // e of every impact of a rectangle; absent if it fluctuates, or differs between the edges.
  { source.constant_restitution() } -> std::same_as<std::optional<double>>;
  // Until the next change of anything but kinetic friction.
  { source.known_intervals() } -> std::same_as<KnownIntervals>;
  // The clock has passed this number of intervals while the block slipped.
  source.pass_intervals(clock, std::size_t{});
};

/// A source whose friction may belong to the place: the base is divided into cells along the slip X, and each has its
/// own coefficients.
template <class Source>
concept HasFrictionOfPlace = CoefficientSource<Source> &&
    requires(Source source, const Source constant, double number) {
  source.place(number);  // the block is at this X
  // X of the end of the present cell for slip in this direction; absent: friction does not belong to the place.
  { constant.cell_end(number) } -> std::same_as<std::optional<double>>;
  source.enter_cell(number);  // the next one in this direction
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
  [[nodiscard]] double restitution(double) const { return restitution_value; }
  [[nodiscard]] double amplitude(const Clock&) const { return amplitude_value; }
  void stop() {}
  void chatter_ended() {}
  [[nodiscard]] std::optional<Instant> next_change(const Clock&, bool) const { return std::nullopt; }
};

}  // namespace rocking::dynamics
