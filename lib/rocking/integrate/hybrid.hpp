#pragma once

#include <array>
#include <bitset>
#include <concepts>
#include <cstdint>
#include <span>

#include "rocking/integrate/polynomial.hpp"
#include "rocking/integrate/zero_crossing.hpp"

/// The hybrid loop: smooth steps on a Taylor polynomial, events where a guard crosses zero, resets, strobe points.
namespace rocking::integrate {

/// Guards have small numbers, which the system assigns.
inline constexpr std::size_t max_guards = 16;
using FiredGuards = std::bitset<max_guards>;

/// All guards.
inline constexpr FiredGuards every_guard{(1U << max_guards) - 1U};

/// Receives a guard's number and its polynomial over the coming step, from which known zeros at the start are divided
/// out.
struct IgnoreGuard {
  void operator()(std::size_t, std::span<const double>) const {}
};

/// What a system must offer. Time is measured from the start of the coming step.
template <class System>
concept HybridSystem = requires(System system, const System constant, double x, FiredGuards fired,
                                IgnoreGuard visitor) {
  { constant.ended() } -> std::same_as<bool>;
  { constant.time_resolution() } -> std::convertible_to<double>;     // instants closer than this are one
  { constant.time_to_breakpoint() } -> std::convertible_to<double>;  // the equations hold until then
  { constant.time_to_strobe() } -> std::convertible_to<double>;
  { system.expand(x) } -> std::convertible_to<double>;  // series of the motion; length of the step, <= x
  constant.for_each_guard(fired, visitor);              // of those in the set
  system.strobe(x);                                     // records the state x into the step
  system.move(x);                                       // to the end of the step
  system.reset(fired, true);                            // what follows from the guards and, if true, the breakpoint
};

struct LoopCounts {
  std::uint64_t steps = 0;
  std::uint64_t root_isolations = 0;  ///< guards that the inexpensive bound did not clear
};

/// When the first guards fire within a step, and which.
struct FirstCrossing {
  double time;
  FiredGuards fired;
};

/// The guards that the inexpensive bound does not clear over the coming step.
template <HybridSystem System>
[[nodiscard]] FiredGuards uncleared_guards(const System& system, double length) {
  FiredGuards uncleared;
  system.for_each_guard(every_guard, [&](std::size_t guard, std::span<const double> coefficients) {
    uncleared[guard] = !is_clearly_positive(coefficients, length);
  });
  return uncleared;
}

/// Zero crossings within a step.
struct Crossings {
  std::array<double, max_guards> instants;  ///< by guard, of those in the set
  FiredGuards guards;
};

/// The earliest of them; crossings within `resolution` of it count as simultaneous.
[[nodiscard]] inline FirstCrossing earliest(const Crossings& crossings, double length, double resolution) {
  FirstCrossing first{length, crossings.guards};
  if (crossings.guards.none()) return first;
  for (std::size_t guard = 0; guard < max_guards; ++guard) {
    if (crossings.guards[guard] && crossings.instants[guard] < first.time) first.time = crossings.instants[guard];
  }
  for (std::size_t guard = 0; guard < max_guards; ++guard) {
    if (first.fired[guard] && crossings.instants[guard] > first.time + resolution) first.fired.reset(guard);
  }
  return first;
}

/// Finds the first zero crossing within a step, among the guards `uncleared`.
template <HybridSystem System>
[[nodiscard]] FirstCrossing first_crossing(const System& system, double length, const FiredGuards& uncleared,
                                           LoopCounts& counts) {
  Crossings crossings;
  if (uncleared.none()) return {length, {}};
  system.for_each_guard(uncleared, [&](std::size_t guard, std::span<const double> coefficients) {
    ++counts.root_isolations;
    std::array<double, max_coefficients> storage;
    const auto crossing = first_zero_crossing(scale_to_unit(coefficients, length, storage));
    if (!crossing) return;
    crossings.instants[guard] = *crossing * length;
    crossings.guards.set(guard);
  });
  return earliest(crossings, length, system.time_resolution());
}

/// Advances the system by one step: its series, strobe points and events. A system may have a function
/// rest_below_threshold that makes steps without events more cheaply; such steps come first.
///
/// A strobe point is the state after the events of its instant. Therefore a strobe instant within the time resolution
/// of the end of a step belongs to the next step.
template <HybridSystem System>
void step(System& system, LoopCounts& counts) {
  if constexpr (requires { system.rest_below_threshold(); }) {
    counts.steps += system.rest_below_threshold();
    if (system.ended()) return;
  }
  const double reach = system.time_to_breakpoint();
  const double length = system.expand(reach);
  ++counts.steps;
  if (system.ended()) return;
  const double resolution = system.time_resolution();
  const auto [time, fired] = first_crossing(system, length, uncleared_guards(system, length), counts);
  while (!system.ended() && system.time_to_strobe() < time - resolution) {
    const double instant = system.time_to_strobe();
    system.strobe(instant > resolution ? instant : 0.0);
  }
  if (system.ended()) return;
  system.move(time);
  system.reset(fired, time >= reach - resolution);
}

/// Advances a system until it has ended.
template <HybridSystem System>
LoopCounts advance(System& system) {
  LoopCounts counts;
  while (!system.ended()) step(system, counts);
  return counts;
}

}  // namespace rocking::integrate
