#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "rocking/lanes/sign_losses.hpp"
#include "rocking/lanes/step.hpp"

namespace rocking::lanes {
namespace {

/// Which guards lose their sign in the coming step of every lane, and when. A cheap bound clears most; the others are looked at
/// side by side, whichever they are.
template <Kind kind, class Real>
class Losses : public Step<kind, Real> {
  using Base = Step<kind, Real>;

 protected:
  using Base::b_, Base::first_, Base::is_brief, Base::load, Base::mark, Base::length_;
  using typename Base::Point;
  using Truth = TruthOf<Real>;
  static constexpr std::size_t guards = Base::guards;

 public:
  using Base::Base;

  /// Which guards may lose their sign in the step, and the state at its end if none does.
  [[gnu::noinline]] void look() {
    occupied_ = load(b_.occupied) == Real(1.0);
    doubts_ = guards_in_doubt();
    end_ = this->point(length_);
  }

 protected:
  /// The search for roots takes as long for one lane as for all: a few lanes that ask for it had better wait for each other. Not
  /// on the friction grid, where hardly any step asks for it and they would wait long.
  static constexpr int fewest_in_doubt = is_brief ? 1 : (3 * Row<Real>::lanes + 7) / 8;

  void find_losses() {
    duration_ = length_;
    isolations_ = Real(0.0);
    unclear_ = lost_ = Real(0.0) < Real(0.0);
    Truth any = doubts_[0];
    for (const Truth& doubt : doubts_) any = any || doubt;
    in_doubt_ = bits_of(any);
    const bool has_others = (bits_of(occupied_) & ~in_doubt_) != 0;
    const bool waits = has_others && std::popcount(in_doubt_) < fewest_in_doubt;
    mark(b_.held, waits ? in_doubt_ : 0);
    if (waits) lost_ = any;
    losses_.fill(Real(0.0) < Real(0.0));
    if (in_doubt_ == 0 || waits) return;
    while (look_for_roots()) continue;
    end_ = this->point(duration_);
  }

  /// Whether a guard's loss is among the first, as integrate::earliest says it.
  [[nodiscard]] Truth is_first(std::size_t guard) const {
    return losses_[guard] && !(duration_ + load(b_.resolution) < instants_[guard]);
  }

  Truth occupied_;
  std::uint32_t in_doubt_;  ///< lanes with a guard that a cheap bound does not clear
  Real isolations_;         ///< of roots of such guards
  Real duration_;           ///< until the first loss, or the end of the step
  Point end_;               ///< the state then
  Truth lost_;              ///< lanes with a guard that loses its sign, or that wait for others to look for it
  Truth unclear_;           ///< lanes with a guard of which that is not found out here
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

  /// In each lane with a guard in doubt, looks for the root of the first such, which is in doubt no longer. False if there is
  /// none.
  [[nodiscard]] bool look_for_roots() {
    using base::select;
    constexpr std::size_t count = Base::order + 2;
    static_assert(count % 2 == 0);
    Real c[count];
    for (Real& coefficient : c) coefficient = Real(0.0);
    std::array<Truth, guards> looked_at;
    Truth taken = Real(0.0) < Real(0.0);
    std::size_t i = 0;
    this->for_each_guard([&](Guard, const auto&, auto own_count, const auto& starts_at_zero, auto coefficient) {
      looked_at[i] = doubts_[i] && !taken;
      doubts_[i] = doubts_[i] && taken;
      taken = taken || looked_at[i];
      copy(looked_at[i], own_count, starts_at_zero, coefficient, c);
      ++i;
    });
    if (bits_of(taken) == 0) return false;
    const Real square = length_ * length_;
    Real even(1.0);
    Real odd = length_;
#pragma GCC unroll 20
    for (std::size_t k = 0; k < count; k += 2) {  // as integrate::scale_to_unit says it
      c[k] = c[k] * even;
      c[k + 1] = c[k + 1] * odd;
      even = even * square;
      odd = odd * square;
    }
    isolations_ = isolations_ + select(taken, Real(1.0), Real(0.0));
    SignLosses<Real> found;
    first_sign_losses<count>(c, taken, found);
    unclear_ = unclear_ || found.unclear;
    lost_ = lost_ || found.lost;
    const Real instant = found.instant * length_;
    duration_ = select(found.lost && instant < duration_, instant, duration_);
    for (i = 0; i < guards; ++i) {
      const Truth lost = found.lost && looked_at[i];
      instants_[i] = select(lost, instant, instants_[i]);
      losses_[i] = losses_[i] || lost;
    }
    return true;
  }

  /// A guard's coefficients, without the first where that is known to be 0, to c in the lanes where it is looked at.
  template <std::size_t count, class Zero, class Coefficient>
  static void copy(const Truth& looked_at, Count<count>, const Zero& starts_at_zero, Coefficient coefficient, Real* c) {
    using base::select;
    if (bits_of(looked_at) == 0) return;
    if constexpr (std::is_same_v<Zero, NeverZero>) {
#pragma GCC unroll 20
      for (std::size_t k = 0; k < count; ++k) c[k] = select(looked_at, coefficient(k), c[k]);
    } else {
      const Truth shifted = looked_at && starts_at_zero;
      const Truth whole = looked_at && !starts_at_zero;
#pragma GCC unroll 20
      for (std::size_t k = 0; k + 1 < count; ++k) {
        c[k] = select(whole, coefficient(k), select(shifted, coefficient(k + 1), c[k]));
      }
      c[count - 1] = select(whole, coefficient(count - 1), c[count - 1]);
    }
  }

  std::array<Truth, guards> doubts_;  ///< for each guard the lanes in which a cheap bound does not clear it
};

}  // namespace
}  // namespace rocking::lanes
