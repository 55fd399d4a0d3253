#include "differential/peer/block.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "differential/peer/coefficients.hpp"
#include "differential/peer/cvode_flow.hpp"
#include "differential/peer/impact.hpp"
#include "differential/peer/mechanics.hpp"
#include "differential/peer/timetable.hpp"
#include "differential/peer/wall_block.hpp"

namespace rocking::peer {
namespace {

enum class Contact { rest, slide, rock, rock_slide };
enum Watch : std::size_t { overturn, ground, standstill, grip_left, grip_right, balance, determinant, normal };

double sign_of(double value) { return value < 0.0 ? -1.0 : 1.0; }

/// A block, simulated event by event.
class Block final : private Equations {
 public:
  Block(const Scene& scene, std::int64_t periods, double shortest_hop, Flow& flow)
      : scene_(scene),
        body_(body_of(scene)),
        coefficients_(scene),
        shortest_hop_(shortest_hop),
        periods_(periods),
        timetable_(scene),
        flow_(flow) {}

  Story tell() {
    begin();
    while (story_.ending.empty()) advance();
    return std::move(story_);
  }

 private:
  [[nodiscard]] double alpha_at(double time) const { return amplitude_ * body_.unit() * timetable_.sine(tau_ + time); }
  [[nodiscard]] double alpha() const { return alpha_at(0.0); }

  /// Looks up the coefficients in force.
  void look_up() {
    amplitude_ = coefficients_.amplitude(timetable_.excitation_period(tau_));
    if (scene_.friction) friction_ = coefficients_.friction(timetable_.interval(tau_));
  }

  // Mechanics in the present contact state.

  [[nodiscard]] Stance stance(const Vector& y) const { return {side_, y[0], y[1]}; }
  [[nodiscard]] Balance balance_at(double time, const Vector& y) const {
    const double a = alpha_at(time);
    return contact_ == Contact::rock ? sticking(body_, stance(y), {a})
                                     : sliding(body_, stance(y), {a}, direction_, friction_.sliding);
  }

  [[nodiscard]] Vector rates(double time, const Vector& y) const override {
    if (contact_ == Contact::slide) {
      return {0.0, 0.0, y[3], -body_.weight * (alpha_at(time) + direction_ * friction_.sliding)};
    }
    const Balance now = balance_at(time, y);
    if (contact_ == Contact::rock) return {y[1], now.w_dot, 0.0, 0.0};
    return {y[1], now.w_dot, y[3], now.v_dot};
  }

  [[nodiscard]] Guards guards(double time, const Vector& y) const override {
    Guards g;
    g.fill(1.0);
    if (contact_ != Contact::rock) g[standstill] = direction_ * y[3];
    if (contact_ == Contact::slide) return g;
    g[overturn] = std::numbers::pi / 2.0 - side_ * y[0];
    g[ground] = side_ * y[0];
    if (!past_balance_) g[balance] = body_.psi(side_) - side_ * y[0];
    if (contact_ == Contact::rock && !scene_.friction) return g;
    const Balance now = balance_at(time, y);
    if (contact_ == Contact::rock_slide) {
      g[determinant] = now.determinant;
    } else if (holds_anyway_) {
      g[normal] = now.normal;
    } else if (now.normal > 0.0) {
      g[grip_left] = friction_.at_rest * now.normal + now.friction;
      g[grip_right] = friction_.at_rest * now.normal - now.friction;
    }
    return g;
  }

  /// `now`: forces of sticking. If sticking would need N <= 0, the block slips, provided that slip presses it on the
  /// base and is accelerated.
  [[nodiscard]] bool grips(const Balance& now) const {
    if (!scene_.friction) return true;
    if (now.normal > 0.0) return std::abs(now.friction) <= friction_.at_rest * now.normal;
    const double direction = -sign_of(now.friction);
    const Balance slipping = sliding(body_, stance(y_), {alpha()}, direction, friction_.sliding);
    return slipping.normal <= 0.0 || direction * slipping.v_dot <= 0.0;
  }
  /// abs(alpha) at which a block at rest leaves its place, pushed over the edge of `side`.
  [[nodiscard]] double threshold(double side) const {
    const double tangent = body_.tangent(side);
    return scene_.friction ? std::min(tangent, friction_.at_rest) : tangent;
  }
  [[nodiscard]] bool tips_when_sliding(double over_side) const { return friction_.sliding > body_.tangent(over_side); }

  // Output.

  [[nodiscard]] Posture posture() const {
    const double psi = body_.psi(y_[0] != 0.0 ? y_[0] : y_[1]);
    return {y_[0] / psi, y_[1] / psi, y_[2], y_[3]};
  }
  void tell_of(std::string_view kind) { story_.events.push_back({tau_, kind, posture()}); }

  // Events.

  void begin() {
    const double psi = body_.psi(scene_.tilt != 0.0 ? scene_.tilt : scene_.tilt_rate);
    y_ = {scene_.tilt * psi, scene_.tilt_rate * psi, 0.0, scene_.slip_rate};
    look_up();
    direction_ = sign_of(y_[3]);
    side_ = sign_of(y_[0] != 0.0 ? y_[0] : y_[1]);
    past_balance_ = std::abs(y_[0]) >= psi;
    const bool flat = y_[0] == 0.0 && y_[1] == 0.0;
    if (flat && y_[3] == 0.0) {
      contact_ = Contact::rest;
      leave_rest_if_pushed();
    } else if (flat) {
      contact_ = Contact::slide;
      tip_if_gripped();
    } else {
      contact_ = y_[3] == 0.0 ? Contact::rock : Contact::rock_slide;
      slip_if_loose();
    }
  }

  void advance() {
    const bool slips = contact_ == Contact::slide || contact_ == Contact::rock_slide;
    const double end = timetable_.next_break(tau_, slips);
    if (contact_ == Contact::rest) {
      const double largest = amplitude_ * body_.unit();
      const double leave = timetable_.next_reach(tau_, threshold(1.0) / largest, threshold(-1.0) / largest);
      if (leave >= end) return arrive(end);
      tau_ = leave;
      look_up();
      return leave_full_contact(sign_of(alpha()), true);
    }
    // A hop is integrated to the same relative accuracy, however low it is: its height is of the order of w^2 + abs(theta).
    const double height = y_[1] * y_[1] + std::abs(y_[0]);
    const double smallness = height > 0.0 ? std::min(1.0, 1e8 * height) : 1.0;
    const Stretch stretch = flow_.follow(y_, end - tau_, smallness, *this);
    y_ = stretch.state;
    const auto& fired = stretch.fired;
    if (std::none_of(fired.begin(), fired.end(), [](bool did) { return did; })) return arrive(end);
    tau_ += stretch.duration;
    look_up();
    const bool held_anyway = std::exchange(holds_anyway_, false);
    if (fired[overturn]) return end_with("overturned", "overturn");
    if (fired[determinant]) return end_with("painleve");
    if (fired[ground]) {
      if (fired[standstill]) y_[3] = 0.0;
      hit_ground(fired[standstill]);
    } else if (fired[standstill]) {
      stand_still();
    } else if (fired[grip_left] || fired[grip_right]) {
      slip(fired[grip_left] ? 1.0 : -1.0);
    }
    if (fired[balance]) {
      past_balance_ = true;
      tell_of("past_balance");
    }
    if (held_anyway) slip_if_loose();
  }

  void end_with(std::string_view ending, std::string_view event = {}) {
    if (!event.empty()) tell_of(event);
    story_.ending = ending;
  }

  /// Handles an instant at which a coefficient changes or a sample is taken.
  void arrive(double instant) {
    const std::int64_t strobes = timetable_.strobes(tau_);
    const std::int64_t period = timetable_.excitation_period(tau_);
    tau_ = instant;
    look_up();
    if (contact_ == Contact::slide) tip_if_gripped();
    const bool draws_amplitude = scene_.sigmas.amplitude > 0.0 && timetable_.excitation_period(tau_) != period;
    if (draws_amplitude && std::exchange(holds_anyway_, false)) slip_if_loose();
    if (timetable_.strobes(tau_) == strobes) return;
    constexpr std::string_view names[] = {"rest", "slide", "rock", "rock_slide"};
    story_.samples.push_back({names[static_cast<std::size_t>(contact_)], posture()});
    if (static_cast<std::int64_t>(story_.samples.size()) == periods_) end_with("reached_horizon");
  }

  void leave_rest_if_pushed() {
    if (std::abs(alpha()) > threshold(alpha())) leave_full_contact(sign_of(alpha()), false);
  }

  void leave_full_contact(double push, bool at_threshold) {
    const bool was_sliding = contact_ == Contact::slide;
    const Balance upright = sticking(body_, {push, 0.0, 0.0}, {alpha()});
    const bool too_slippery = scene_.friction && friction_.at_rest <= body_.tangent(push);
    if (!too_slippery && (at_threshold || grips(upright) || tips_when_sliding(push))) {
      side_ = push;
      contact_ = Contact::rock;
      tell_of("lift");
      if (!at_threshold) slip_if_loose();
      return;
    }
    contact_ = Contact::slide;
    direction_ = -push;
    tell_of(was_sliding ? "slip_reverse" : "slide_start");
  }

  /// Whether slip in `direction` would not be reversed at once. (With mu_s = mu_k its acceleration may start at 0.)
  [[nodiscard]] bool slip_would_last(double direction) const {
    constexpr double rounding = 1e-9;  // of accelerations at an onset that was found as a root
    return direction * sliding(body_, stance(y_), {alpha()}, direction, friction_.sliding).v_dot >= -rounding;
  }

  void slip(double direction) {
    holds_anyway_ = !slip_would_last(direction);
    if (holds_anyway_) return;
    contact_ = Contact::rock_slide;
    direction_ = direction;
    tell_of("slip_start");
  }

  void slip_if_loose() {
    if (contact_ != Contact::rock) return;
    const Balance now = sticking(body_, stance(y_), {alpha()});
    if (!grips(now)) slip(-sign_of(now.friction));
  }

  void tip_if_gripped() {
    if (!tips_when_sliding(-direction_)) return;
    contact_ = Contact::rock_slide;
    side_ = -direction_;
    tell_of("tip");
  }

  void stand_still() {
    y_[3] = 0.0;
    coefficients_.stopped();
    look_up();
    if (contact_ == Contact::slide) {
      if (std::abs(alpha()) > threshold(alpha())) return leave_full_contact(sign_of(alpha()), false);
      contact_ = Contact::rest;
      return tell_of("slide_stop");
    }
    const Balance now = sticking(body_, stance(y_), {alpha()});
    const double direction = -sign_of(now.friction);
    if (!grips(now) && slip_would_last(direction)) {
      direction_ = direction;
      return tell_of("slip_reverse");
    }
    holds_anyway_ = !grips(now);
    contact_ = Contact::rock;
    tell_of("slip_stop");
  }

  void hit_ground(bool has_stopped) {
    y_[0] = 0.0;
    const double w_before = y_[1];
    const double v_before = y_[3];
    std::optional<Friction> friction;
    if (scene_.friction) friction = friction_;
    const Rebound after = land(body_, {.w = w_before,
                                       .v = v_before,
                                       .restitution = coefficients_.next_restitution(),
                                       .friction = friction,
                                       .signed_rule = scene_.signed_impact_rule});
    if (!after.determined) return end_with("painleve");
    y_[1] = after.w;
    y_[3] = after.v;
    side_ = sign_of(after.w);
    if (after.v != 0.0) direction_ = sign_of(after.v);
    tell_of(after.slipped ? "impact_slip" : "impact_stick");
    if (has_stopped || (v_before != 0.0 && after.v == 0.0)) {
      coefficients_.stopped();
      look_up();
    }
    contact_ = after.v == 0.0 ? Contact::rock : Contact::rock_slide;
    const bool same_edge = after.w * w_before < 0.0;
    if (hops_are_short(std::min(pull(-1.0), pull(1.0)))) return come_down();
    if (same_edge && pull(-side_) < 0.0 && hops_are_short(pull(side_))) return come_down();
    slip_if_loose();
  }

  /// w' towards the ground of a block that stands on the edge of `side`.
  [[nodiscard]] double pull(double side) const {
    const Stance stance{side, 0.0, 0.0};
    const Balance now = contact_ == Contact::rock ? sticking(body_, stance, {alpha()})
                                                  : sliding(body_, stance, {alpha()}, direction_, friction_.sliding);
    return -side * now.w_dot;
  }

  /// Whether hops under this pull, starting at rate w, are too short to be simulated.
  [[nodiscard]] bool hops_are_short(double pull) const {
    return pull > 0.0 && 2.0 * std::abs(y_[1]) < shortest_hop_ * pull;
  }

  void come_down() {
    y_[1] = 0.0;
    coefficients_.chatter_ended();
    look_up();
    const bool slides = contact_ == Contact::rock_slide;
    contact_ = slides ? Contact::slide : Contact::rest;
    tell_of(slides ? "to_slide" : "to_rest");
    if (slides) return tip_if_gripped();
    leave_rest_if_pushed();
  }

  Scene scene_;
  Body body_;
  Coefficients coefficients_;
  double shortest_hop_;
  std::int64_t periods_;
  Timetable timetable_;
  Flow& flow_;

  double tau_ = 0.0;
  Vector y_{};
  Contact contact_ = Contact::rest;
  double side_ = 1.0;
  double direction_ = 1.0;
  bool past_balance_ = false;
  bool holds_anyway_ = false;  ///< neither sticking nor slipping agrees with the laws: it sticks until the next event
  double amplitude_ = 0.0;
  Friction friction_{};
  Story story_;
};

}  // namespace

Story story_of(const Scene& scene, std::int64_t periods, const Care& care) {
  CvodeFlow flow(
      {.relative = 2e-14, .absolute = 1e-15, .longest_step = Timetable(scene).period() / care.steps_per_period});
  if (scene.open_side != 0.0) return story_at_wall(scene, periods, care.shortest_hop, flow);
  return Block(scene, periods, care.shortest_hop, flow).tell();
}

}  // namespace rocking::peer
