#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "rocking/lanes/root_search.hpp"
#include "rocking/lanes/step_points.hpp"

namespace rocking::lanes {
namespace {

/// Which guards cross zero in the coming step of the lanes, and when. An inexpensive bound clears most guards; the
/// first zero crossings of the others are searched for.
template <Kind kind, class Shaking, class Real>
class Crossings : public StepPoints<kind, Shaking, Real> {
  using Base = StepPoints<kind, Shaking, Real>;

 protected:
  using Base::state_, Base::guards, Base::length_, Base::load, Base::mark;
  using typename Base::Point;
  using Truth = TruthOf<Real>;

 public:
  using Base::Base;

  /// Of all lanes of a lane state.
  using Search = RootSearch<Base::order + 2, most_lanes * guards, Real>;

  /// Evaluates the bound of each guard.
  [[gnu::noinline]] void look() {
    occupied_ = load(state_.occupied) == Real(1.0);
    uncleared_guards_ = find_uncleared_guards();
    uncleared_ = uncleared_guards_[0];
    for (const Truth& guard : uncleared_guards_) uncleared_ = uncleared_ || guard;
  }

  /// Number of lanes with a guard that the bound does not clear.
  [[nodiscard]] int uncleared_count() const { return std::popcount(bits_of(uncleared_)); }
  /// Whether there are lanes without such a guard.
  [[nodiscard]] bool has_others() const { return bits_of(occupied_ && !uncleared_) != 0; }

  /// Adds those guards to the search.
  [[gnu::noinline]] void ask(Search& search) {
    using base::select;
    std::size_t i = 0;
    this->for_each_guard([&](const auto& row, auto coefficient) {
      const std::uint32_t wanted = bits_of(uncleared_guards_[i]);
      if (wanted != 0) {
        places_[i] = search.ask(wanted, length_, [&](std::size_t k) {
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

 protected:
  /// The first crossings, from the results of the search. If nothing was searched for, the lanes with an uncleared
  /// guard wait.
  void find_crossings(const Search& search) {
    duration_ = length_;
    isolations_ = Real(0.0);
    undecided_ = crosses_ = Real(0.0) < Real(0.0);
    crossings_.fill(crosses_);
    const bool waits = search.size() == 0;
    waits_ = waits ? uncleared_ : crosses_;
    mark(state_.held, bits_of(waits_));
    if (waits) {
      crosses_ = uncleared_;
    } else {
      take_answers(search);
    }
    end_ = this->point(duration_);
  }

  /// Whether a guard's crossing is among the first, as in integrate::earliest.
  [[nodiscard]] Truth is_first(std::size_t guard) const {
    return crossings_[guard] && !(duration_ + load(state_.resolution) < instants_[guard]);
  }

  Truth occupied_;
  Truth uncleared_;                      ///< lanes with a guard that the bound does not clear
  Real isolations_;                      ///< number of such guards that were searched
  Real duration_;                        ///< until the first crossing, or the end of the step
  Point end_;                            ///< the state then
  Truth crosses_;                        ///< lanes with a crossing, and lanes that wait for a search
  Truth waits_;                          ///< lanes that wait for a search
  Truth undecided_;                      ///< lanes with a guard for which the search gave no result
  std::array<Truth, guards> crossings_;  ///< lanes with a crossing, by guard
  std::array<Real, guards> instants_;    ///< of the crossings

 private:
  void take_answers(const Search& search) {
    using base::select;
    for (std::size_t i = 0; i < guards; ++i) {
      const Truth& searched = uncleared_guards_[i];
      const std::uint32_t wanted = bits_of(searched);
      if (wanted == 0) continue;
      isolations_ = isolations_ + select(searched, Real(1.0), Real(0.0));
      const Real found = search.answer(wanted, places_[i]);
      crossings_[i] = searched && found < Real(Search::never);
      undecided_ = undecided_ || (searched && !(found == found));
      crosses_ = crosses_ || crossings_[i];
      instants_[i] = found * length_;
      duration_ = select(crossings_[i] && instants_[i] < duration_, instants_[i], duration_);
    }
  }

  [[nodiscard]] std::array<Truth, guards> find_uncleared_guards() const {
    std::array<Truth, guards> all;
    std::size_t i = 0;
    this->for_each_guard([&](const auto& row, auto coefficient) {
      Truth& uncleared = all[i++];
      uncleared = is_in_reach(row.out_of_reach);
      if (bits_of(uncleared) == 0) return;
      uncleared = uncleared && !(Real(0.0) < this->bound(row.length, row.zeros, coefficient));
    });
    return all;
  }

  [[nodiscard]] Truth is_in_reach(const InReach&) const { return occupied_; }
  [[nodiscard]] Truth is_in_reach(const Truth& out_of_reach) const { return occupied_ && !out_of_reach; }

  std::array<Truth, guards> uncleared_guards_;  ///< by guard, the lanes in which the bound does not clear it
  std::array<std::size_t, guards> places_;      ///< of the answers in the search
};

}  // namespace
}  // namespace rocking::lanes
