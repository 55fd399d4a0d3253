#include "rocking/realisation/poincare_map.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/realisation/strobe_recorder.hpp"

namespace rocking {
namespace {

constexpr double largest_tolerance(PoincareMap::Detail detail) {
  return detail == PoincareMap::Detail::everything ? 1e-16 : 1e-13;
}

/// Sides times slip directions after a change of contact: each is negative, absent or positive.
constexpr int directions = 9;

/// Keeps the contact states and their changes too.
class SectionObserver final : public dynamics::Observer {
 public:
  SectionObserver(const dynamics::Geometry& block, int periods) : block_(block), recorder_(block, periods + 1) {}

  void event(dynamics::EventKind kind, double tau, const dynamics::State& state) override {
    recorder_.event(kind, tau, state);
    events_.push_back({kind, state});
    note(kind, state);
  }
  void strobe(const dynamics::State& state) override {
    recorder_.strobe(state);
    contacts_.push_back(state.contact);
    at_strobe_ = state;
  }

  /// Without the first strobe point.
  [[nodiscard]] std::vector<SectionState> later_states() const {
    std::vector<SectionState> states;
    for (std::size_t k = 1; k < contacts_.size(); ++k) {
      states.push_back({.point = recorder_.periods()[k].point, .contact = contacts_[k]});
    }
    return states;
  }
  [[nodiscard]] dynamics::ContactState first_contact() const { return contacts_.front(); }
  [[nodiscard]] const std::vector<section::Period>& periods() const { return recorder_.periods(); }
  [[nodiscard]] const ContactSequence& sequence() const { return sequence_; }

  /// Where a chatter ends, the impacts in the middle one of three rounds of the motion: a strobe instant may cut it, and it
  /// counts once.
  [[nodiscard]] int impacts() const {
    const auto ends_chatter = [](const auto& event) {
      return event.first == dynamics::EventKind::to_rest || event.first == dynamics::EventKind::to_slide;
    };
    if (std::ranges::none_of(events_, ends_chatter)) {
      int sum = 0;
      for (std::size_t k = 1; k < periods().size(); ++k) sum += periods()[k].impacts;
      return sum;
    }
    StrobeRecorder rounds(block_, 4);
    rounds.strobe(at_strobe_);
    for (int round = 0; round < 3; ++round) {
      for (const auto& [kind, state] : events_) rounds.event(kind, 0.0, state);
      rounds.strobe(at_strobe_);
    }
    return rounds.periods()[2].impacts;
  }

 private:
  void note(dynamics::EventKind kind, const dynamics::State& after) {
    using dynamics::EventKind;
    if (kind == EventKind::past_balance) return;
    if (kind == EventKind::to_rest || kind == EventKind::to_slide) {
      while (!sequence_.empty() && is_impact(sequence_.back())) sequence_.pop_back();
    }
    const int side = dynamics::is_rocking(after.contact) ? (after.side > 0.0 ? 2 : 0) : 1;
    const int slip = dynamics::is_sliding(after.contact) ? (after.slip_direction > 0.0 ? 2 : 0) : 1;
    sequence_.push_back(static_cast<std::uint8_t>(directions * static_cast<int>(kind) + 3 * side + slip));
  }
  static bool is_impact(std::uint8_t change) {
    const auto kind = static_cast<dynamics::EventKind>(change / directions);
    return kind == dynamics::EventKind::impact_stick || kind == dynamics::EventKind::impact_slip;
  }

  dynamics::Geometry block_;
  StrobeRecorder recorder_;
  std::vector<std::pair<dynamics::EventKind, dynamics::State>> events_;  ///< each with the state after it
  dynamics::State at_strobe_;                                            ///< the newest one
  std::vector<dynamics::ContactState> contacts_;
  ContactSequence sequence_;
};

/// The scene with its clock at 0 at the start. The vertical motion is where it is at such an instant.
Scene from_section(Scene scene) {
  auto& harmonic = std::get<Harmonic>(scene.excitation);
  if (harmonic.vertical) {
    const auto sine = harmonic.vertical_sine(dynamics::geometry_of(mean_block(scene)), scene.block.gravity);
    harmonic.vertical->phase = sine.phase - sine.cycles / sine.periods * mean_of(harmonic.phase);
  }
  harmonic.phase = 0.0;
  return scene;
}

Beginning beginning_of(Condition condition, PoincareMap::Detail detail) {
  condition.scene = from_section(std::move(condition.scene));
  condition.tolerance = std::min(condition.tolerance, largest_tolerance(detail));
  const random::Draws draws(0, 0);
  return begin_realisation(condition, draws, start_of(condition.scene, draws), Strobe::poincare, 1);
}

/// `from`, `to`: psi of the sides on which the block is at both ends.
SectionMatrix in_units_of_section(const TangentMotion<Motion, 3>::Tangents& columns, double from, double to) {
  const auto& [by_tilt, by_rate, by_slip] = columns;
  const double ratio = from / to;
  return {{{by_tilt.tilt * ratio, by_rate.tilt * ratio, by_slip.tilt / to},
           {by_tilt.tilt_rate * ratio, by_rate.tilt_rate * ratio, by_slip.tilt_rate / to},
           {by_tilt.slip_rate * from, by_rate.slip_rate * from, by_slip.slip_rate}}};
}

}  // namespace

bool is_same_sequence(const ContactSequence& a, const ContactSequence& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t shift = 0; shift < std::max<std::size_t>(b.size(), 1); ++shift) {
    ContactSequence rotated = b;
    std::rotate(rotated.begin(), rotated.begin() + static_cast<std::ptrdiff_t>(shift), rotated.end());
    if (a == rotated) return true;
  }
  return false;
}

ContactSequence mirrored(const ContactSequence& sequence) {
  ContactSequence mirror;
  for (const int change : sequence) {
    mirror.push_back(
        static_cast<std::uint8_t>(directions * (change / directions) + directions - 1 - change % directions));
  }
  return mirror;
}

PoincareMap::PoincareMap(const Condition& condition, Detail detail)
    : scene_(from_section(condition.scene)), detail_(detail), at_zero_(beginning_of(condition, detail)) {
  ROCKING_EXPECT(!is_random(condition.scene));
}

Beginning PoincareMap::beginning(const section::StrobePoint& from, const dynamics::Schedule& schedule) const {
  Beginning beginning = at_zero_;
  const double psi = beginning.setting.block.tilt_unit(from.tilt, from.tilt_rate);
  beginning.state = {.tilt = psi * from.tilt, .tilt_rate = psi * from.tilt_rate, .slip_rate = from.slip_rate};
  beginning.schedule = schedule;
  return beginning;
}

std::optional<PoincareImage> PoincareMap::image(const section::StrobePoint& from,
                                                const dynamics::Schedule& schedule) const {
  const Beginning begin = beginning(from, schedule);
  SectionObserver observer(begin.setting.block, static_cast<int>(schedule.strobes));
  TangentMotion<Motion, 3> motion(motion_of(scene_, begin, observer),
                                  {{{.tilt = 1.0}, {.tilt_rate = 1.0}, {.slip_rate = 1.0}}});
  GuardLog log;
  if (detail_ == Detail::everything) motion.log_guards(log);
  observer.strobe(motion.state());  // the edge about which the block turns at the start
  integrate::advance(motion);
  if (motion.termination() != dynamics::Termination::reached_horizon) return std::nullopt;
  const auto psi_at = [&](const section::StrobePoint& point) {
    return begin.setting.block.tilt_unit(point.tilt, point.tilt_rate);
  };
  const double psi_at_end = psi_at(observer.periods().back().point);
  PoincareImage image{.contact = observer.first_contact(),
                      .states = observer.later_states(),
                      .derivative = in_units_of_section(motion.at_strobe(), psi_at(from), psi_at_end),
                      .impacts = observer.impacts(),
                      .not_differentiable = motion.not_differentiable(),
                      .sequence = observer.sequence(),
                      .crossings = log.crossings(),
                      .minima = log.minima()};
  for (std::size_t k = 1; k < observer.periods().size(); ++k) {
    image.moved = image.moved || observer.periods()[k].moved;
  }
  return image;
}

std::optional<PoincareImage> PoincareMap::image(const section::StrobePoint& from, int periods) const {
  return image(from, {.first_strobe = {.period = 1, .time = 0.0}, .strobes = periods});
}

std::optional<PoincareImage> PoincareMap::mirrored_half(const section::StrobePoint& from, int periods) const {
  ROCKING_EXPECT(periods % 2 == 1);
  if (!has_mirror_symmetry()) return std::nullopt;
  const double half = 0.5 * at_zero_.clock.period_length();
  auto image = this->image(from, {.first_strobe = {.period = 0, .time = half}, .strobes = (periods + 1) / 2});
  if (!image) return std::nullopt;
  image->states = {image->states.back()};
  section::StrobePoint& end = image->states.front().point;
  end = {.tilt = -end.tilt, .tilt_rate = -end.tilt_rate, .slip_rate = -end.slip_rate};
  for (auto& row : image->derivative) {
    for (double& entry : row) entry = -entry;
  }
  return image;
}

std::optional<std::vector<SectionState>> PoincareMap::half_way(const section::StrobePoint& from, int periods) const {
  if (!has_mirror_symmetry()) return std::nullopt;
  const double half = 0.5 * at_zero_.clock.period_length();
  const Beginning begin = beginning(from, {.first_strobe = {.period = 0, .time = half}, .strobes = periods});
  SectionObserver observer(begin.setting.block, periods);
  Motion motion = motion_of(scene_, begin, observer);
  observer.strobe(motion.state());
  integrate::advance(motion);
  if (motion.termination() != dynamics::Termination::reached_horizon) return std::nullopt;
  return observer.later_states();
}

}  // namespace rocking
