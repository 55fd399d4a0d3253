#pragma once

#include "rocking/lanes/step.hpp"

namespace rocking::lanes {
namespace {

/// Moves on the lanes where nothing can happen: no guard in doubt, no breakpoint (but at the end of a brief step), at most one
/// strobe point, not the last. The others are left as they were.
template <Kind kind, class Real>
class Move : Step<kind, Real> {
  using Base = Step<kind, Real>;
  using Base::b_, Base::load, Base::store, Base::length_, Base::m_, Base::period_, Base::period_length_, Base::reach_,
      Base::slips, Base::time_;
  using typename Base::Point;

 public:
  using Base::Base;

  void run() {
    using base::select;
    this->expand();
    const Real one(1.0);
    const Real resolution = load(b_.resolution);
    const Real later = time_ + length_;
    const auto wraps = !(later < period_length_);
    const Real time = select(wraps, later - period_length_, later);
    const Real steps_since = load(b_.steps_since_strobe) + one;
    const Point next = this->point(length_);
    const auto strobing = this->strobing(length_ - resolution);
    auto quiet = is_clear() && this->is_finite(next) && this->is_ordinary(resolution, steps_since) &&
                 time < period_length_ && strobing.is_simple;
    const auto arrives = !(length_ < reach_ - resolution);
    if constexpr (kind != Kind::rock_slide_briefly) quiet = quiet && !arrives;
    auto strobed = quiet && strobing.strobes;
    if (bits_of(strobed) != 0) {
      quiet = quiet && (this->store_strobe(strobing, resolution) || !strobing.strobes);
      strobed = quiet && strobing.strobes;
      store(b_.strobe_period, select(strobed, load(b_.strobe_period) + one, load(b_.strobe_period)));
      store(b_.strobes_left, select(strobed, load(b_.strobes_left) - one, load(b_.strobes_left)));
    }
    b_.strobed = bits_of(strobed);
    b_.quiet = bits_of(quiet);
    b_.arrived = bits_of(quiet && arrives);
    store(b_.steps_since_strobe, select(strobed, Real(0.0), select(quiet, steps_since, load(b_.steps_since_strobe))));
    store(b_.steps, select(quiet, load(b_.steps) + one, load(b_.steps)));
    store(b_.tilt, select(quiet, next.tilt, m_.tilt[0]));
    store(b_.tilt_rate, select(quiet, next.tilt_rate, m_.tilt_rate[0]));
    if constexpr (slips) {
      store(b_.slip, select(quiet, next.slip, m_.slip[0]));
      store(b_.slip_rate, select(quiet, next.slip_rate, m_.slip_rate[0]));
    }
    store(b_.time, select(quiet, time, time_));
    store(b_.period, select(quiet && wraps, period_ + one, period_));
  }

 private:
  /// Whether cheap bounds show that no guard loses its sign.
  [[nodiscard]] TruthOf<Real> is_clear() const {
    TruthOf<Real> clear = length_ == length_;
    this->for_each_guard([&](Guard, auto count, const auto& zero, auto coefficient) {
      clear = clear && Real(0.0) < this->bound(count, zero, coefficient);
    });
    return clear;
  }
};

}  // namespace
}  // namespace rocking::lanes
