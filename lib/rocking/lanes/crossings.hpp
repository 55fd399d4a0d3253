#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "rocking/lanes/guard_bounds.hpp"
#include "rocking/lanes/root_search.hpp"

namespace rocking::lanes {
namespace {

/// The search for zero crossings of all lanes of a lane state.
template <class Form>
using SearchOf = RootSearch<Form::order + 2, most_lanes * Form::guards, typename Form::Real>;

/// By guard, where the search has the answers for the lanes in which the guard is uncleared.
template <class Form>
using SearchPlaces = std::array<std::size_t, Form::guards>;

/// Adds the uncleared guards to the search.
template <class Form, class Real = typename Form::Real>
[[gnu::noinline]] void ask(const LaneAccess<Real>& lanes, const Step<Form>& step, const UnclearedGuards<Form>& guards,
                           SearchOf<Form>& search, SearchPlaces<Form>& places) {
  using base::select;
  std::size_t i = 0;
  for_each_guard(lanes, step, [&](const auto& row, auto coefficient) {
    const std::uint32_t wanted = bits_of(guards.lanes[i]);
    if (wanted != 0) {
      places[i] = search.ask(wanted, step.length, [&](std::size_t k) {
        const auto own = [&](std::size_t j) { return j < row.length ? coefficient(j) : Real(0.0); };
        if constexpr (std::is_same_v<std::decay_t<decltype(row.zeros)>, NeverZero>) {
          return own(k);
        } else {
          return select(row.zeros, own(k + 1), own(k));
        }
      });
    }
    ++i;
  });
}

/// Which guards cross zero in the coming step of the lanes, and when.
template <class Form>
struct Crossings {
  using Real = typename Form::Real;
  using Truth = typename Form::Truth;

  Real isolations = Real(0.0);              ///< number of guards that were searched
  Truth crosses = Real(0.0) < Real(0.0);    ///< lanes with a crossing, and lanes that wait for a search
  Truth waits = Real(0.0) < Real(0.0);      ///< lanes that wait for a search
  Truth undecided = Real(0.0) < Real(0.0);  ///< lanes with a guard for which the search gave no result
  Real duration;                            ///< until the first crossing, or the end of the step
  std::array<Truth, Form::guards> of;       ///< lanes with a crossing, by guard
  std::array<Real, Form::guards> instants;  ///< of the crossings

  /// Whether a guard's crossing is among the first, as in integrate::earliest.
  [[nodiscard]] Truth is_first(std::size_t guard, const Real& resolution) const {
    return of[guard] && !(duration + resolution < instants[guard]);
  }
};

/// The first crossings, from the results of the search. If nothing was searched for, the lanes with an uncleared guard
/// wait.
template <class Form, class Real = typename Form::Real>
inline void find_crossings(const Real& length, const UnclearedGuards<Form>& guards, const SearchOf<Form>& search,
                           const SearchPlaces<Form>& places, Crossings<Form>& found) {
  using base::select;
  found.duration = length;
  found.of.fill(found.crosses);
  if (search.size() == 0) {
    found.waits = found.crosses = guards.any;
    return;
  }
  for (std::size_t i = 0; i < Form::guards; ++i) {
    const auto& searched = guards.lanes[i];
    const std::uint32_t wanted = bits_of(searched);
    if (wanted == 0) continue;
    found.isolations = found.isolations + select(searched, Real(1.0), Real(0.0));
    const Real answer = search.answer(wanted, places[i]);
    found.of[i] = searched && answer < Real(SearchOf<Form>::never);
    found.undecided = found.undecided || (searched && !(answer == answer));
    found.crosses = found.crosses || found.of[i];
    found.instants[i] = answer * length;
    found.duration = select(found.of[i] && found.instants[i] < found.duration, found.instants[i], found.duration);
  }
}

}  // namespace
}  // namespace rocking::lanes
