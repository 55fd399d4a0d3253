#include "differential/peer/wall_block.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "differential/peer/coefficients.hpp"
#include "differential/peer/mechanics.hpp"
#include "differential/peer/timetable.hpp"

namespace rocking::peer {
namespace {

/// The corners of a broken line in tau, after a still base.
class Record {
 public:
  explicit Record(const Scene& scene, const Body& body) : corners_(scene.record) {
    const double unit = std::hypot(0.5 * (scene.edges[0] + scene.edges[1]), scene.height);
    for (Corner& corner : corners_) corner.seconds *= std::sqrt(scene.gravity / (unit * body.weight));
  }

  [[nodiscard]] bool is_given() const { return !corners_.empty(); }

  /// From now on the line is that after the last corner up to tau.
  void enter(double tau) {
    while (next_ < corners_.size() && corners_[next_].seconds <= tau) ++next_;
  }
  [[nodiscard]] double next_break() const {
    return next_ < corners_.size() ? corners_[next_].seconds : std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] Shaking at(double tau) const {
    if (next_ == 0 || next_ == corners_.size()) return {0.0, 0.0};
    const Corner& a = corners_[next_ - 1];
    const Corner& b = corners_[next_];
    const double share = (tau - a.seconds) / (b.seconds - a.seconds);
    return {std::lerp(a.horizontal, b.horizontal, share), std::lerp(a.vertical, b.vertical, share)};
  }

 private:
  std::vector<Corner> corners_;
  std::size_t next_ = 0;
};

enum Watch : std::size_t { overturn, ground, balance, hold };

/// A block that turns about one edge only, event by event.
class WallBlock final : private Equations {
 public:
  WallBlock(const Scene& scene, std::int64_t periods, double shortest_hop, Flow& flow)
      : scene_(scene),
        body_(body_of(scene)),
        coefficients_(scene),
        timetable_(scene),
        record_(scene, body_),
        side_(scene.open_side),
        psi_(body_.psi(side_)),
        shortest_hop_(shortest_hop),
        periods_(periods),
        flow_(flow) {}

  Story tell() {
    y_ = {scene_.tilt * psi_, scene_.tilt_rate * psi_, 0.0, 0.0};
    past_balance_ = std::abs(y_[0]) >= psi_;
    rests_ = y_[0] == 0.0 && y_[1] == 0.0;
    look_up();
    leave_rest_if_pushed();
    while (story_.ending.empty()) advance();
    return std::move(story_);
  }

 private:
  [[nodiscard]] Shaking base(double time) const {
    const double tau = tau_ + time;
    if (record_.is_given()) {
      const Shaking line = record_.at(tau);
      return {amplitude_ * line.alpha, amplitude_ * line.vertical};
    }
    Shaking sines{amplitude_ * body_.unit() * timetable_.sine(tau)};
    if (scene_.vertical) {
      sines.vertical = scene_.vertical->amplitude * body_.unit() *
                       std::sin(scene_.vertical->frequency * tau + scene_.vertical->phase);
    }
    return sines;
  }

  void look_up() {
    record_.enter(tau_);
    amplitude_ = coefficients_.amplitude(timetable_.excitation_period(tau_));
  }

  [[nodiscard]] double rise(double time, double theta, double w) const {
    return sticking(body_, {side_, theta, w}, base(time)).w_dot;
  }

  [[nodiscard]] Vector rates(double time, const Vector& y) const override {
    if (rests_) return {};
    return {y[1], rise(time, y[0], y[1]), 0.0, 0.0};
  }

  [[nodiscard]] Guards guards(double time, const Vector& y) const override {
    Guards g;
    g.fill(1.0);
    if (rests_) {
      g[hold] = margin(time);
      return g;
    }
    g[overturn] = std::numbers::pi / 2.0 - side_ * y[0];
    g[ground] = side_ * y[0];
    if (!past_balance_) g[balance] = psi_ - side_ * y[0];
    return g;
  }

  /// The acceleration away from the wall by which a block in full contact does not lift yet, over g.
  [[nodiscard]] double margin(double time) const {
    const Shaking now = base(time);
    return body_.tangent(side_) * (1.0 + now.vertical) - side_ * now.alpha;
  }

  void tell_of(std::string_view kind) { story_.events.push_back({tau_, kind, posture()}); }
  [[nodiscard]] Posture posture() const { return {y_[0] / psi_, y_[1] / psi_, 0.0, 0.0}; }

  void advance() {
    const double end = std::min(timetable_.next_break(tau_, false), record_.next_break());
    // A hop is integrated to the same relative accuracy, however low it is.
    const double height = y_[1] * y_[1] + std::abs(y_[0]);
    const Stretch stretch = flow_.follow(y_, end - tau_, height > 0.0 ? std::min(1.0, 1e8 * height) : 1.0, *this);
    y_ = stretch.state;
    const auto& fired = stretch.fired;
    if (std::none_of(fired.begin(), fired.end(), [](bool did) { return did; })) return arrive(end);
    tau_ += stretch.duration;
    if (fired[overturn]) {
      tell_of("overturn");
      story_.ending = "overturned";
      return;
    }
    if (fired[ground]) hit();
    if (fired[hold]) lift();
    if (fired[balance]) {
      past_balance_ = true;
      tell_of("past_balance");
    }
  }

  void arrive(double instant) {
    const std::int64_t strobes = timetable_.strobes(tau_);
    tau_ = instant;
    look_up();
    leave_rest_if_pushed();
    if (timetable_.strobes(tau_) == strobes) return;
    story_.samples.push_back({rests_ ? "rest" : "rock", posture()});
    if (static_cast<std::int64_t>(story_.samples.size()) == periods_) story_.ending = "reached_horizon";
  }

  void leave_rest_if_pushed() {
    if (rests_ && margin(0.0) < 0.0) lift();
  }

  void lift() {
    rests_ = false;
    tell_of("lift");
  }

  void hit() {
    y_ = {0.0, -coefficients_.next_restitution() * y_[1], 0.0, 0.0};
    tell_of("impact_stick");
    const double pull = -side_ * rise(0.0, 0.0, 0.0);
    if (pull > 0.0 ? 2.0 * std::abs(y_[1]) < shortest_hop_ * pull : y_[1] == 0.0) {
      rests_ = true;
      y_[1] = 0.0;
      if (pull <= 0.0) return lift();
      coefficients_.chatter_ended();
      tell_of("to_rest");
    }
  }

  Scene scene_;
  Body body_;
  Coefficients coefficients_;
  Timetable timetable_;
  Record record_;
  double side_;
  double psi_;
  double shortest_hop_;
  std::int64_t periods_;
  Flow& flow_;

  double tau_ = 0.0;
  Vector y_{};
  bool rests_ = false;
  bool past_balance_ = false;
  double amplitude_ = 0.0;
  Story story_;
};

}  // namespace

Story story_at_wall(const Scene& scene, std::int64_t periods, double shortest_hop, Flow& flow) {
  return WallBlock(scene, periods, shortest_hop, flow).tell();
}

}  // namespace rocking::peer
