#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "rocking/lanes/root_search.hpp"
#include "rocking/lanes/step.hpp"

namespace rocking::lanes {
namespace {

/// Which guards lose their sign in the coming step of every lane, and when. A cheap bound clears most; the roots of the others
/// are asked for.
template <Kind kind, class Shaking, class Real>
class Losses : public Step<kind, Shaking, Real> {
  using Base = Step<kind, Shaking, Real>;

 protected:
  using Base::b_, Base::length_, Base::load, Base::mark;
  using typename Base::Point;
  using Truth = TruthOf<Real>;
  static constexpr std::size_t guards = Base::guards;

 public:
  using Base::Base;

  /// Of all the lanes of a block.
  using Search = RootSearch<Base::order + 2, most_lanes * guards, Real>;

  /// Which guards may lose their sign in the step.
  [[gnu::noinline]] void look() {
    occupied_ = load(b_.occupied) == Real(1.0);
    doubts_ = guards_in_doubt();
    Truth any = doubts_[0];
    for (const Truth& doubt : doubts_) any = any || doubt;
    in_doubt_ = any;
  }

  /// Lanes with a guard that may lose its sign, and lanes without.
  [[nodiscard]] int doubtful() const { return std::popcount(bits_of(in_doubt_)); }
  [[nodiscard]] bool has_others() const { return bits_of(occupied_ && !in_doubt_) != 0; }

  /// Asks for the roots of those guards.
  [[gnu::noinline]] void ask(Search& search) {
    using base::select;
    std::size_t i = 0;
    this->for_each_guard([&](Guard, const auto&, auto count, const auto& starts_at_zero, auto coefficient) {
      const std::uint32_t doubt = bits_of(doubts_[i]);
      if (doubt != 0) {
        places_[i] = search.ask(doubt, length_, [&](std::size_t k) {
          const auto own = [&](std::size_t j) { return j < count ? coefficient(j) : Real(0.0); };
          if constexpr (std::is_same_v<std::decay_t<decltype(starts_at_zero)>, NeverZero>) {
            return own(k);
          } else {
            return select(starts_at_zero, own(k + 1), own(k));
          }
        });
      }
      ++i;
    });
  }

 protected:
  void find_losses(const Search& search) {
    duration_ = length_;
    isolations_ = Real(0.0);
    unclear_ = lost_ = Real(0.0) < Real(0.0);
    losses_.fill(lost_);
    const bool waits = search.size() == 0;
    mark(b_.held, waits ? bits_of(in_doubt_) : 0);
    if (waits) {
      lost_ = in_doubt_;
    } else {
      take_answers(search);
    }
    end_ = this->point(duration_);
  }

  void take_answers(const Search& search) {
    using base::select;
    for (std::size_t i = 0; i < guards; ++i) {
      const std::uint32_t doubt = bits_of(doubts_[i]);
      if (doubt == 0) continue;
      isolations_ = isolations_ + select(doubts_[i], Real(1.0), Real(0.0));
      const Real found = search.answer(doubt, places_[i]);
      losses_[i] = doubts_[i] && found < Real(Search::never);
      unclear_ = unclear_ || (doubts_[i] && !(found == found));
      lost_ = lost_ || losses_[i];
      instants_[i] = found * length_;
      duration_ = select(losses_[i] && instants_[i] < duration_, instants_[i], duration_);
    }
  }

  /// Whether a guard's loss is among the first, as integrate::earliest says it.
  [[nodiscard]] Truth is_first(std::size_t guard) const {
    return losses_[guard] && !(duration_ + load(b_.resolution) < instants_[guard]);
  }

  Truth occupied_;
  Truth in_doubt_;   ///< lanes with a guard that a cheap bound does not clear
  Real isolations_;  ///< of roots of such guards
  Real duration_;    ///< until the first loss, or the end of the step
  Point end_;        ///< the state then
  Truth lost_;       ///< lanes with a guard that loses its sign, or that wait for others to look for it
  Truth unclear_;    ///< lanes with a guard of which that is not found out here
  std::array<Truth, guards> losses_;   ///< of each guard
  std::array<Real, guards> instants_;  ///< when

 private:
  /// For each guard the lanes in which a cheap bound does not clear it.
  [[nodiscard]] std::array<Truth, guards> guards_in_doubt() const {
    std::array<Truth, guards> doubts;
    std::size_t i = 0;
    this->for_each_guard(
        [&](Guard, const auto& out_of_reach, auto count, const auto& starts_at_zero, auto coefficient) {
          Truth& doubt = doubts[i++];
          doubt = is_in_reach(out_of_reach);
          if (bits_of(doubt) == 0) return;
          doubt = doubt && !(Real(0.0) < this->bound(count, starts_at_zero, coefficient));
        });
    return doubts;
  }

  [[nodiscard]] Truth is_in_reach(const InReach&) const { return occupied_; }
  [[nodiscard]] Truth is_in_reach(const Truth& out_of_reach) const { return occupied_ && !out_of_reach; }

  std::array<Truth, guards> doubts_;        ///< for each guard the lanes in which a cheap bound does not clear it
  std::array<std::size_t, guards> places_;  ///< of the answers
};

}  // namespace
}  // namespace rocking::lanes
