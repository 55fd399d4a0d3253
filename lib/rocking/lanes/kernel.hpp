#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <variant>

#include "rocking/lanes/advance.hpp"

namespace rocking::lanes {
namespace {

/// Number of lanes with an uncleared guard from which on zero crossings are searched for. The search takes as long for
/// one lane as for a register of them; therefore a few lanes wait for each other. In brief steps so few guards are
/// uncleared that they would wait long.
template <class Form>
constexpr int fewest_uncleared() {
  return Form::is_brief ? 1 : (Row<typename Form::Real>::lanes + 1) / 2;
}

template <class Form>
void advance(LaneState& state) {
  Advance<Form> lanes(state, 0);
  lanes.begin();
  lanes.expand();
  lanes.look();
  SearchOf<Form> search;
  const auto& uncleared = lanes.uncleared();
  if (!uncleared.has_others() || uncleared.lane_count() >= fewest_uncleared<Form>()) {
    lanes.ask(search);
    search.search();
  }
  lanes.finish(search);
}

/// The lanes of two registers in turns, so that the processor has independent operations to execute while others wait
/// for operands.
template <class Form>
void advance_in_turns(LaneState& state) {
  Advance<Form> first(state, 0);
  Advance<Form> second(state, Row<typename Form::Real>::lanes);
  first.begin();
  second.begin();
  first.expand();
  second.expand();
  first.look();
  second.look();
  SearchOf<Form> search;
  const bool all_uncleared = !first.uncleared().has_others() && !second.uncleared().has_others();
  if (all_uncleared || first.uncleared().lane_count() + second.uncleared().lane_count() >= fewest_uncleared<Form>()) {
    first.ask(search);
    second.ask(search);
    search.search();
  }
  first.finish(search);
  second.finish(search);
}

template <int registers, Kind kind, class Shaking, class Real>
constexpr Kernel kernel() {
  static_assert(registers == 1 || registers == 2);
  if constexpr (registers == 2) {
    return advance_in_turns<StepForm<kind, Shaking, Real>>;
  } else {
    return advance<StepForm<kind, Shaking, Real>>;
  }
}

template <int registers, class Shaking, class Real, std::size_t... kind>
constexpr std::array<Kernel, kind_count> by_kind(std::index_sequence<kind...>) {
  return {kernel<registers, static_cast<Kind>(kind), Shaking, Real>()...};
}

template <int registers, class Real, class... Shaking>
constexpr Kernels kernels_under(std::string_view name, std::variant<Shaking...>*) {
  return {.name = name,
          .lanes = registers * Row<Real>::lanes,
          .advance = {by_kind<registers, Shaking, Real>(std::make_index_sequence<kind_count>{})...}};
}

/// The kernels of so many registers of Real side by side: one, or two in turns.
template <int registers, class Real>
constexpr Kernels kernels_of(std::string_view name) {
  return kernels_under<registers, Real>(name, static_cast<dynamics::Excitation::Kinds*>(nullptr));
}

}  // namespace
}  // namespace rocking::lanes
