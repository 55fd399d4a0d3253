#pragma once

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

}  // namespace rocking
