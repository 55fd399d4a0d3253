#pragma once

#include <cstdint>
#include <vector>

#include "rocking/dynamics/contact.hpp"

namespace rocking {

/// A hybrid system that is `Motion`, to the bit. A wrapper that watches a motion derives from it and hides the members
/// at which it does so.
template <class Motion>
class ForwardedMotion {
 public:
  [[nodiscard]] bool ended() const { return motion_->ended(); }
  [[nodiscard]] double time_resolution() const { return motion_->time_resolution(); }
  [[nodiscard]] double time_to_breakpoint() const { return motion_->time_to_breakpoint(); }
  [[nodiscard]] double time_to_strobe() const { return motion_->time_to_strobe(); }
  [[nodiscard]] double expand(double reach) { return motion_->expand(reach); }
  template <class Guards, class Visitor>
  void for_each_guard(const Guards& wanted, Visitor&& visit) const {
    motion_->for_each_guard(wanted, visit);
  }
  void strobe(double x) { motion_->strobe(x); }
  void move(double x) { motion_->move(x); }
  template <class Fired>
  void reset(const Fired& fired, bool at_breakpoint) {
    motion_->reset(fired, at_breakpoint);
  }

 protected:
  /// The motion must outlive this object.
  explicit ForwardedMotion(Motion& motion) : motion_(&motion) {}
  [[nodiscard]] Motion& motion() const { return *motion_; }

 private:
  Motion* motion_;
};

/// State at an instant of a time history.
struct HistoryPoint {
  double tau;
  dynamics::State state;
  double base_acceleration;  ///< alpha: horizontal, over g
};

/// A hybrid system with the same bits as `Motion` that also samples the motion at a number of evenly spaced instants
/// per period, from the polynomials of the steps. At an instant with events the state is the one after them, as at a
/// strobe. The motion must have a strobe a whole number of periods after tau = 0.
template <class Motion>
class SampledMotion : public ForwardedMotion<Motion> {
 public:
  /// `samples` >= 1 per period of length `period` in tau. Points are appended to `history`. Both must outlive this
  /// object.
  SampledMotion(Motion& motion, int samples, double period, std::vector<HistoryPoint>& history)
      : ForwardedMotion<Motion>(motion), samples_(samples), period_(period), history_(&history) {}

  void strobe(double x) {
    sample_until(x);
    this->motion().strobe(x);
    const bool was_taken = this->motion().time_to_strobe() > x + 0.5 * period_;
    if (was_taken) begin_period(x);
  }

  void move(double x) {
    sample_until(x);
    this->motion().move(x);
  }

 private:
  /// Time from the start of the step to the next sample, in tau.
  [[nodiscard]] double time_to_sample() const {
    return this->motion().time_to_strobe() - period_ * (1.0 - static_cast<double>(next_) / samples_);
  }

  void sample_until(double x) {
    for (; next_ < samples_; ++next_) {
      const double instant = time_to_sample();
      if (instant >= x - this->motion().time_resolution()) return;
      keep(instant);
    }
  }

  void keep(double instant) {
    const double periods = static_cast<double>(done_) + static_cast<double>(next_) / samples_;
    const double x = instant > 0.0 ? instant : 0.0;
    history_->push_back({.tau = periods * period_,
                         .state = this->motion().state_at(x),
                         .base_acceleration = this->motion().base_at(x).horizontal});
  }

  void begin_period(double x) {
    ++done_;
    next_ = 0;
    keep(x);
    next_ = 1;
  }

  int samples_;
  double period_;
  std::vector<HistoryPoint>* history_;
  std::int64_t done_ = 0;  ///< periods
  int next_ = 0;           ///< index in the current period; 0: its first sample is still to come
};

}  // namespace rocking
