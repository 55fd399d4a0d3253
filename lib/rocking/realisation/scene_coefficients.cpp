#include "rocking/realisation/scene_coefficients.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "rocking/base/error.hpp"
#include "rocking/dynamics/impact.hpp"

namespace rocking {

using dynamics::Clock;
using dynamics::Instant;
using random::Source;

namespace {

bool redraws_amplitude(const Scene& scene) {
  return scene.fluctuation.amplitude > 0.0 && amplitude_draws(scene.excitation) != AmplitudeDraws::once;
}

/// Of the friction and the restitution of a block of this shape, and of its A_h (or the scale), whatever the units in
/// which they are given.
CoefficientLaws laws_of(const Scene& scene, const dynamics::Geometry& own) {
  const Fluctuation& f = scene.fluctuation;
  CoefficientLaws laws;
  if (scene.friction) {
    laws.static_friction = law_along_the_way(f.laws.static_friction, mean_static(*scene.friction), f.static_friction);
    laws.kinetic_friction =
        law_along_the_way(f.laws.kinetic_friction, mean_kinetic(*scene.friction), f.kinetic_friction);
    laws.correlation = f.friction_correlation;
    laws.own_share = std::sqrt(1.0 - laws.correlation * laws.correlation);
  }
  laws.restitution = law_along_the_way(f.laws.restitution, mean_restitution(scene.restitution, own),
                                       f.restitution / unit_of(scene.restitution, own));
  laws.restitution_reach = reach_along_the_way(scene.restitution, own);
  laws.right_edge = right_edge_of(scene.restitution, own);
  laws.amplitude =
      law_along_the_way(f.laws.amplitude, amplitude_for(scene, own), f.amplitude / amplitude_unit(scene, own));
  return laws;
}

}  // namespace

SceneCoefficients::SceneCoefficients(const Scene& scene, const random::BranchedDraws& draws,
                                     const dynamics::Geometry& own)
    : laws_(laws_of(scene, own)),
      has_friction_(scene.friction.has_value()),
      refreshes_per_period_(scene.fluctuation.refreshes_per_period),
      redraws_amplitude_(redraws_amplitude(scene)),
      draws_(draws),
      static_friction_(std::numeric_limits<double>::infinity()) {
  if (!has_friction_) return;
  const Fluctuation& f = scene.fluctuation;
  if (f.refresh_slip_m && (f.static_friction > 0.0 || f.kinetic_friction > 0.0)) {
    cells_.emplace(*f.refresh_slip_m / own.half_diagonal);
    draw_friction_of_cell();
  } else {
    draw_static_friction();
  }
}

void SceneCoefficients::place(double slip) {
  if (cells_ && cells_->move_to(slip)) draw_friction_of_cell();
}

std::optional<double> SceneCoefficients::cell_end(double direction) const {
  return cells_ ? std::optional(cells_->end(direction)) : std::nullopt;
}

void SceneCoefficients::enter_cell(double direction) {
  cells_->enter_next(direction);
  draw_friction_of_cell();
}

void SceneCoefficients::draw_friction_of_cell() {
  look_up_static_friction(cells_->index());
  follows_former_static_ = false;
  held_at_static_ = false;
  if (!is_drawn(laws_.kinetic_friction)) return;
  const double own = draws_.standard_normal(Source::kinetic_friction, cells_->index());
  use_kinetic_friction(value_at_normal(laws_.kinetic_friction, with_share_of_static(own)));
}

void SceneCoefficients::draw_static_friction() {
  static_count_ = stops_;
  look_up_static_friction(random::paired_index(static_count_.chatters, static_count_.since));
}

void SceneCoefficients::look_up_static_friction(std::uint64_t index) {
  if (!is_drawn(laws_.static_friction)) {
    static_friction_ = std::get<double>(laws_.static_friction);
    return;
  }
  ++static_draws_;
  static_normal_ = draws_.standard_normal(Source::static_friction, index);
  static_friction_ = value_at_normal(laws_.static_friction, static_normal_);
  if (static_friction_ < 0.0) {
    static_friction_ = 0.0;
    ++clamps_.static_at_zero;
  }
  if (!is_drawn(laws_.kinetic_friction)) held_at_static_ = false;
  follows_former_static_ = laws_.correlation != 0.0;
}

void SceneCoefficients::stop() {
  ++stops_.since;
  if (has_friction_ && !cells_) draw_static_friction();
}

void SceneCoefficients::chatter_ended() {
  const bool had_stops = stops_.since > 0;
  stops_ = {.chatters = stops_.chatters + 1, .since = 0};
  impacts_ = {.chatters = impacts_.chatters + 1, .since = 0};
  if (has_friction_ && had_stops && !cells_) draw_static_friction();
}

SceneCoefficients SceneCoefficients::under(const SceneCoefficients& others) const {
  ROCKING_EXPECT(others.has_friction_ == has_friction_);
  SceneCoefficients other = *this;
  other.laws_ = others.laws_;
  other.refreshes_per_period_ = others.refreshes_per_period_;
  other.redraws_amplitude_ = others.redraws_amplitude_;
  other.interval_ = -1;
  other.drawn_from_ = none_drawn;
  other.amplitude_period_ = -1;
  if (!other.has_friction_) return other;
  other.cells_ = others.cells_;
  if (other.cells_) {
    other.draw_friction_of_cell();
  } else {
    other.look_up_static_friction(random::paired_index(other.static_count_.chatters, other.static_count_.since));
  }
  return other;
}

random::FirstUnused SceneCoefficients::first_unused() const {
  random::FirstUnused first{};
  for (std::size_t number = 1; number < first.size(); ++number)
    first[number] = first_unused(static_cast<Source>(number));
  return first;
}

std::uint64_t SceneCoefficients::first_unused(Source source) const {
  const bool is_of_friction = source == Source::static_friction || source == Source::kinetic_friction;
  if (cells_ && is_of_friction) return cells_->first_unused();
  switch (source) {
    case Source::static_friction: return random::paired_index(static_count_.chatters, static_count_.since) + 1;
    case Source::kinetic_friction: return static_cast<std::uint64_t>(interval_ + 1);
    case Source::restitution: return random::paired_index(impacts_.chatters, impacts_.since);
    case Source::amplitude: return static_cast<std::uint64_t>(amplitude_period_ + 1);
    default: break;
  }
  return 0;  // not along the way: a branch does not change it
}

void SceneCoefficients::continue_with(const random::BranchedDraws& draws) {
  draws_ = draws;
  drawn_from_ = none_drawn;  // those ahead may belong to another branch
}

void SceneCoefficients::draw_amplitude_again(const Clock& clock) {
  if (redraws_amplitude_) amplitude_period_ = std::min(amplitude_period_, clock.now().period - 1);
}

double SceneCoefficients::kinetic_friction(const Clock& clock) {
  if (const auto* constant = std::get_if<double>(&laws_.kinetic_friction)) return held_kinetic_friction(*constant);
  return held_kinetic_friction(cells_ ? kinetic_friction_ : drawn_kinetic_friction(clock));
}

/// `wanted`, limited to the static friction in force.
double SceneCoefficients::held_kinetic_friction(double wanted) {
  if (wanted <= static_friction_) return wanted;
  if (!held_at_static_) ++clamps_.kinetic_at_static;
  held_at_static_ = true;
  return static_friction_;
}

double SceneCoefficients::drawn_kinetic_friction(const Clock& clock) {
  const std::int64_t interval = grid_index(clock);
  if (interval == interval_ && !follows_former_static_) return kinetic_friction_;
  if (interval - drawn_from_ >= intervals_at_once || follows_former_static_) {
    drawn_from_ = interval - interval % 2;  // draws are made in pairs
    draws_.standard_normals(Source::kinetic_friction, static_cast<std::uint64_t>(drawn_from_), drawn_);
    turn_normals_into_friction();
    follows_former_static_ = false;
  }
  if (interval != interval_) move_to_interval(clock, interval);
  use_kinetic_friction(drawn_[static_cast<std::size_t>(interval - drawn_from_)]);
  return kinetic_friction_;
}

/// A normal number with the wanted correlation with that of static friction, from an independent one.
double SceneCoefficients::with_share_of_static(double own) const {
  return laws_.correlation * static_normal_ + laws_.own_share * own;
}

/// Of the normal numbers that `drawn_` holds, in which those of static friction have their share.
void SceneCoefficients::turn_normals_into_friction() {
  if (laws_.correlation != 0.0) {
    for (double& value : drawn_) value = with_share_of_static(value);
  }
  if (const auto* normal = std::get_if<Normal>(&laws_.kinetic_friction)) {
    for (double& value : drawn_) value = normal->mean + normal->sigma * value;
  } else {
    for (double& value : drawn_) value = value_at_normal(laws_.kinetic_friction, value);
  }
}

void SceneCoefficients::use_kinetic_friction(double wanted) {
  held_at_static_ = false;
  ++kinetic_draws_;
  kinetic_friction_ = wanted;
  if (kinetic_friction_ < 0.0) {
    kinetic_friction_ = 0.0;
    ++clamps_.kinetic_at_zero;
  }
}

/// Kinetic friction as far as it has been drawn. Only valid if no other coefficient changes with time.
dynamics::KnownIntervals SceneCoefficients::known_intervals() const {
  const bool is_known = interval_ >= 0 && drawn_from_ != none_drawn && !follows_former_static_;
  if (!is_drawn(laws_.kinetic_friction) || cells_ || redraws_amplitude_ || !is_known) return {};
  const auto present = static_cast<std::size_t>(interval_ - drawn_from_);
  return {
      .wanted = std::span(drawn_).subspan(present), .per_period = refreshes_per_period_, .next_boundary = end_number_};
}

void SceneCoefficients::pass_intervals(const Clock& clock, std::size_t count) {
  const auto next = static_cast<std::size_t>(interval_ - drawn_from_) + 1;
  double wanted = 0.0;
  for (std::size_t i = next; i < next + count; ++i) {  // without a branch, so that it can be vectorised
    wanted = drawn_[i];
    clamps_.kinetic_at_zero += wanted < 0.0 ? 1 : 0;
    clamps_.kinetic_at_static += wanted > static_friction_ ? 1 : 0;
  }
  kinetic_draws_ += count;
  kinetic_friction_ = std::max(wanted, 0.0);
  held_at_static_ = wanted > static_friction_;
  move_to_interval(clock, interval_ + static_cast<std::int64_t>(count));
}

double SceneCoefficients::restitution(double landing) {
  const auto at_edge = [&](double left) {
    return landing < 0.0 ? (1.0 + left) * laws_.right_edge.share - 1.0 + laws_.right_edge.more : left;
  };
  const bool is_one = is_alike_at_both_edges();
  if (const auto* constant = std::get_if<double>(&laws_.restitution)) return is_one ? *constant : at_edge(*constant);
  ++restitution_draws_;
  const auto index = random::paired_index(impacts_.chatters, impacts_.since++);
  const double drawn = value_at_normal(laws_.restitution, draws_.standard_normal(Source::restitution, index));
  const double value = is_one ? drawn : at_edge(drawn);
  const double clamped = std::clamp(value, laws_.restitution_reach.least, laws_.restitution_reach.largest);
  if (clamped != value) ++clamps_.restitution;
  return clamped;
}

double SceneCoefficients::amplitude(const Clock& clock) {
  if (const auto* constant = std::get_if<double>(&laws_.amplitude)) return *constant;
  const std::int64_t period = redraws_amplitude_ ? clock.now().period : 0;
  if (period != amplitude_period_) {
    amplitude_period_ = period;
    ++amplitude_draws_;
    const auto index = static_cast<std::uint64_t>(period);
    amplitude_ = value_at_normal(laws_.amplitude, draws_.standard_normal(Source::amplitude, index));
    if (amplitude_ < 0.0) {
      amplitude_ = 0.0;
      ++clamps_.amplitude_at_zero;
    }
  }
  return amplitude_;
}

void SceneCoefficients::move_to_interval(const Clock& clock, std::int64_t interval) {
  const std::int64_t ahead = interval - interval_;
  if (interval_ >= 0 && 0 < ahead && ahead < refreshes_per_period_) {
    begin_ = ahead == 1 ? end_ : boundary_after_end(clock, ahead - 1);
    end_ = boundary_after_end(clock, ahead);
    end_number_ += ahead;
    if (end_number_ >= refreshes_per_period_) end_number_ -= refreshes_per_period_;
  } else {
    begin_ = boundary(clock, interval);
    end_ = boundary(clock, interval + 1);
    end_number_ = (interval + 1) % refreshes_per_period_;
  }
  interval_ = interval;
}

/// The boundary `count` intervals after the end of the current interval; `count` is at most the number per period.
Instant SceneCoefficients::boundary_after_end(const Clock& clock, std::int64_t count) const {
  const std::int64_t per_period = refreshes_per_period_;
  const std::int64_t number = end_number_ + count;
  return number < per_period ? dynamics::grid_boundary(clock, end_.period, number, per_period)
                             : dynamics::grid_boundary(clock, end_.period + 1, number - per_period, per_period);
}

/// Instant at which an interval begins.
Instant SceneCoefficients::boundary(const Clock& clock, std::int64_t interval) const {
  const std::int64_t per_period = refreshes_per_period_;
  return dynamics::grid_boundary(clock, interval / per_period, interval % per_period, per_period);
}

/// The interval that contains the present instant. A boundary within the clock's resolution counts as reached. Usually
/// this is the interval of the last call or the next one.
std::int64_t SceneCoefficients::grid_index(const Clock& clock) const {
  const auto is_reached = [&](const Instant& instant) { return clock.until(instant) <= clock.resolution(); };
  if (interval_ >= 0 && is_reached(begin_)) {
    if (!is_reached(end_)) return interval_;
    if (!is_reached(boundary_after_end(clock, 1))) return interval_ + 1;
  }
  return searched_grid_index(clock);
}

std::int64_t SceneCoefficients::searched_grid_index(const Clock& clock) const {
  const auto count = static_cast<double>(refreshes_per_period_);
  const double local = (clock.now().time - clock.start()) / clock.period_length() * count;
  std::int64_t index = clock.now().period * refreshes_per_period_ + static_cast<std::int64_t>(std::floor(local));
  index = std::max<std::int64_t>(index - 1, 0);  // rounding may make floor one too large
  while (clock.until(boundary(clock, index + 1)) <= clock.resolution()) ++index;
  return index;
}

std::optional<Instant> SceneCoefficients::next_change(const Clock& clock, bool slipping) const {
  std::optional<Instant> next;
  if (redraws_amplitude_) next = Instant{.period = clock.now().period + 1, .time = 0.0};
  if (slipping && is_drawn(laws_.kinetic_friction) && !cells_) {
    const std::int64_t index = grid_index(clock);
    const Instant refresh = index == interval_ ? end_ : boundary(clock, index + 1);
    if (!next || clock.until(refresh) < clock.until(*next)) next = refresh;
  }
  return next;
}

void SceneCoefficients::add_to(OperationCounts& operations) const {
  operations.static_friction_draws += static_draws_;
  operations.kinetic_friction_draws += kinetic_draws_;
  operations.restitution_draws += restitution_draws_;
  operations.amplitude_draws += amplitude_draws_;
}

}  // namespace rocking
