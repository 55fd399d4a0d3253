#pragma once

#include "rocking/lanes/sign_losses.hpp"
#include "rocking/lanes/step.hpp"

namespace rocking::lanes {
namespace {

/// Finds out how the coming step ends in each lane: which guards lose their sign in it, when, and the state at the first such
/// instant. What follows from it is left to each lane's motion.
template <Kind kind, class Real>
class End : Step<kind, Real> {
  using Base = Step<kind, Real>;
  using Base::b_, Base::load, Base::store, Base::length_, Base::m_, Base::slips, Base::time_;
  using typename Base::Point;

 public:
  using Base::Base;

  void run() {
    this->expand();
    duration_ = length_;
    unclear_ = Real(0.0) < Real(0.0);
    this->for_each_guard([this](Guard guard, auto count, const auto& zero, auto coefficient) {
      this->find_loss(static_cast<std::size_t>(guard), count, zero, coefficient);
    });
    const Real resolution = load(b_.resolution);
    const Point end = this->point(duration_);
    const auto strobing = this->strobing(duration_ - resolution);
    const auto steps_since = load(b_.steps_since_strobe) + Real(1.0);
    // Off the ground the guards are others than were looked at here.
    auto fits = !unclear_ && Real(0.0) < m_.normal[0] && this->is_finite(end) &&
                this->is_ordinary(resolution, steps_since) && strobing.is_simple;
    if (bits_of(strobing.strobes) != 0) {
      fits = fits && (this->store_strobe(strobing, resolution) || !strobing.strobes);
    }
    b_.strobed = bits_of(strobing.strobes);
    b_.alone = ~bits_of(fits);
    store(b_.length, length_);
    store(b_.duration, duration_);
    store(b_.end_tilt, end.tilt);
    store(b_.end_tilt_rate, end.tilt_rate);
    if constexpr (slips) {
      store(b_.end_slip, end.slip);
      store(b_.end_slip_rate, end.slip_rate);
    }
  }

 private:
  template <std::size_t count, class Zero, class Coefficient>
  void find_loss(std::size_t guard, Count<count> all, const Zero& starts_at_zero, Coefficient coefficient) {
    using base::select;
    const auto in_doubt = !(Real(0.0) < this->bound(all, starts_at_zero, coefficient));
    b_.in_doubt[guard] = bits_of(in_doubt);
    b_.lost[guard] = 0;
    if constexpr (std::is_same_v<Zero, NeverZero>) {
      if (b_.in_doubt[guard] != 0) find_loss_in<0, count>(guard, in_doubt, coefficient);
    } else {
      const auto from_zero = in_doubt && starts_at_zero;
      const auto others = in_doubt && !starts_at_zero;
      if (bits_of(from_zero) != 0) find_loss_in<1, count>(guard, from_zero, coefficient);
      if (bits_of(others) != 0) find_loss_in<0, count>(guard, others, coefficient);
    }
  }

  /// Of the polynomial from coefficient `first` on, in the lanes where `wanted`.
  template <std::size_t first, std::size_t count, class Coefficient>
  void find_loss_in(std::size_t guard, const TruthOf<Real>& wanted, Coefficient coefficient) {
    using base::select;
    Real c[count - first];
    Real power(1.0);
#pragma GCC unroll 20
    for (std::size_t k = first; k < count; ++k) {
      c[k - first] = coefficient(k) * power;
      power = power * length_;
    }
    SignLosses<Real> found;
    first_sign_losses<count - first>(c, wanted, found);
    unclear_ = unclear_ || found.unclear;
    const Real instant = found.instant * length_;
    duration_ = select(found.lost && instant < duration_, instant, duration_);
    store(b_.instants[guard], select(found.lost, instant, load(b_.instants[guard])));
    b_.lost[guard] |= bits_of(found.lost);
  }

  Real duration_;
  TruthOf<Real> unclear_;  ///< lanes with a guard whose loss is not found here
};

}  // namespace
}  // namespace rocking::lanes
