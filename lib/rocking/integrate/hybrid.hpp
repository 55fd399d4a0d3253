#pragma once

#include <array>
#include <bitset>
#include <concepts>
#include <cstdint>
#include <span>

#include "rocking/integrate/polynomial.hpp"
#include "rocking/integrate/sign_loss.hpp"

/// The hybrid loop: smooth steps on a Taylor polynomial, events where a guard loses its sign, resets, strobe samples.
namespace rocking::integrate {

/// Guards are known by small numbers that the system gives them.
inline constexpr std::size_t max_guards = 16;
using FiredGuards = std::bitset<max_guards>;

/// All guards.
inline constexpr FiredGuards every_guard{(1U << max_guards) - 1U};

/// Takes a guard's number and its polynomial over the coming step, zeros at the start that are known exactly divided out.
struct IgnoreGuard {
  void operator()(std::size_t, std::span<const double>) const {}
};

/// What a system offers to be advanced. Time is measured from the start of the coming step.
template <class System>
concept HybridSystem = requires(System system, const System constant, double x, FiredGuards fired,
                                IgnoreGuard visitor) {
  { constant.ended() } -> std::same_as<bool>;
  { constant.time_resolution() } -> std::convertible_to<double>;     // instants closer than this are one
  { constant.time_to_breakpoint() } -> std::convertible_to<double>;  // until which the equations hold
  { constant.time_to_strobe() } -> std::convertible_to<double>;
  { system.expand(x) } -> std::convertible_to<double>;  // series of the motion; length of the step, <= x
  constant.for_each_guard(fired, visitor);              // of those in the set
  system.strobe(x);                                     // records the state x into the step
  system.move(x);                                       // to the end of the step
  system.reset(fired, true);                            // events and, if true, the breakpoint, in their order
};

struct LoopCounts {
  std::uint64_t steps = 0;
  std::uint64_t root_isolations = 0;  ///< guards that the cheap bound did not clear
};

/// When the first guards fire within a step, and which.
struct FirstLoss {
  double time;
  FiredGuards fired;
};

/// The guards that the cheap bound does not clear over the coming step.
template <HybridSystem System>
[[nodiscard]] FiredGuards guards_in_doubt(const System& system, double length) {
  FiredGuards in_doubt;
  system.for_each_guard(every_guard, [&](std::size_t guard, std::span<const double> coefficients) {
    in_doubt[guard] = !is_clearly_positive(coefficients, length);
  });
  return in_doubt;
}

/// Losses of sign within a step, and when.
struct Losses {
  std::array<double, max_guards> instants;  ///< of the guards below
  FiredGuards guards;
};

/// The earliest of them; losses within `resolution` of it count as simultaneous.
[[nodiscard]] inline FirstLoss earliest(const Losses& losses, double length, double resolution) {
  FirstLoss first{length, losses.guards};
  if (losses.guards.none()) return first;
  for (std::size_t guard = 0; guard < max_guards; ++guard) {
    if (losses.guards[guard] && losses.instants[guard] < first.time) first.time = losses.instants[guard];
  }
  for (std::size_t guard = 0; guard < max_guards; ++guard) {
    if (first.fired[guard] && losses.instants[guard] > first.time + resolution) first.fired.reset(guard);
  }
  return first;
}

/// Finds the earliest loss of sign within a step, among the guards `in_doubt`.
template <HybridSystem System>
[[nodiscard]] FirstLoss first_loss(const System& system, double length, const FiredGuards& in_doubt,
                                   LoopCounts& counts) {
  Losses losses;
  if (in_doubt.none()) return {length, {}};
  system.for_each_guard(in_doubt, [&](std::size_t guard, std::span<const double> coefficients) {
    ++counts.root_isolations;
    std::array<double, max_coefficients> storage;
    const auto loss = first_sign_loss(scale_to_unit(coefficients, length, storage));
    if (!loss) return;
    losses.instants[guard] = *loss * length;
    losses.guards.set(guard);
  });
  return earliest(losses, length, system.time_resolution());
}

/// Does one step: its series, its events, its strobe points.
///
/// A strobe sample shows the state after the events of its instant: one that falls within the time resolution of a step's
/// end waits for the next step.
template <HybridSystem System>
void step(System& system, LoopCounts& counts) {
  const double reach = system.time_to_breakpoint();
  const double length = system.expand(reach);
  ++counts.steps;
  if (system.ended()) return;
  const double resolution = system.time_resolution();
  const auto [time, fired] = first_loss(system, length, guards_in_doubt(system, length), counts);
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
