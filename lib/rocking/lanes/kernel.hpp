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

/// Advances the lanes of all registers in turns, stage by stage, so that the processor has independent operations to
/// execute while others wait for operands. The lanes go on while nothing happens in any of them.
template <int registers, class Form>
void advance(LaneState& state) {
  [&]<std::size_t... i>(std::index_sequence<i...>) {
    Advance<Form> all[] = {Advance<Form>(state, i * Row<typename Form::Real>::lanes)...};
    do {
      (all[i].begin(), ...);
      (all[i].expand(), ...);
      (all[i].look(), ...);
      (all[i].pass(), ...);
    } while ((all[i].can_go_on() && ...));
    SearchOf<Form> search;
    const bool have_others = (all[i].uncleared().has_others() || ...);
    if (!have_others || (all[i].uncleared().lane_count() + ...) >= fewest_uncleared<Form>()) {
      (all[i].ask(search), ...);
      search.search();
    }
    (all[i].finish(search), ...);
  }
  (std::make_index_sequence<registers>{});
}

template <int registers, dynamics::BlockForm form, class Shaking, class Real, bool with_tangents, std::size_t... kind>
constexpr std::array<Kernel, kind_count> by_kind(std::index_sequence<kind...>) {
  if constexpr (with_tangents && (!Shaking::is_periodic || Shaking::has_vertical)) return {};
  return {advance<registers, StepForm<static_cast<Kind>(kind), form, Shaking, Real, with_tangents>>...};
}

template <int registers, class Real, bool with_tangents, class... Shaking>
constexpr Kernels::ByKind kernels_by_kind(std::variant<Shaking...>*) {
  using dynamics::BlockForm;
  constexpr auto kinds = std::make_index_sequence<kind_count>{};
  return {by_kind<registers, BlockForm::rectangle, Shaking, Real, with_tangents>(kinds)...,
          by_kind<registers, BlockForm::general, Shaking, Real, with_tangents>(kinds)...};
}

/// The kernels of so many registers of Real side by side.
template <int registers, class Real>
constexpr Kernels kernels_of(std::string_view name) {
  constexpr auto* shaking = static_cast<dynamics::Excitation::Kinds*>(nullptr);
  return {.name = name,
          .lanes = registers * Row<Real>::lanes,
          .advance = kernels_by_kind<registers, Real, false>(shaking),
          .advance_with_tangents = kernels_by_kind<registers, Real, true>(shaking)};
}

}  // namespace
}  // namespace rocking::lanes
