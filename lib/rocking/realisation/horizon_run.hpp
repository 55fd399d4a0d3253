#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "rocking/realisation/exponent.hpp"
#include "rocking/realisation/orbit_search.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/settling_observer.hpp"
#include "rocking/realisation/start.hpp"
#include "rocking/realisation/strobe_recorder.hpp"
#include "rocking/section/classify.hpp"

/// Runs a motion over the horizon of its condition and classifies the response.
namespace rocking {

inline void add(OperationCounts& operations, const integrate::LoopCounts& counts) {
  operations.steps += counts.steps;
  operations.root_isolations += counts.root_isolations;
}

/// Accuracy of a strobe point, in units of Theta: the tolerance of a step times about a thousand steps; at least 1e-9,
/// which is always sufficient.
inline double resolution_of(double tolerance) { return std::max(1e-9, 1e3 * tolerance); }

/// Copies the results of a motion, except the classification and the operation counts.
inline void collect(RealisationResult& result, const Motion& motion) {
  result.termination = motion.termination().value_or(dynamics::Termination::stopped);
  result.losses_of_contact = motion.losses_of_contact();
  result.losses_before_fall = motion.losses_before_fall();
  result.first_loss_of_contact = motion.first_loss_of_contact();
  result.was_past_balance = motion.was_past_balance();
  result.overturned_side = std::nullopt;
  if (result.termination == dynamics::Termination::overturned) {
    result.overturned_side = motion.state().tilt > 0.0 ? dynamics::Side::left : dynamics::Side::right;
  }
  result.contradictions = motion.contradictions();
  result.peaks = peaks_of(motion, motion.setting().block);
}

/// Copies the counts of a finished motion.
inline void collect_counts(RealisationResult& result, const Motion& motion, const StrobeRecorder& recorder) {
  result.operations.slip_steps = motion.slip_steps();
  result.operations.events = recorder.events();
  motion.coefficients().add_to(result.operations);
  result.operations.ground_motion_segments = motion.segments_looked_up();
  result.clamps += motion.coefficients().clamps();
}

/// Classification under a recorded excitation, which does not repeat: the block is at rest at the end, or it is not. One
/// that has moved without ever rocking has slid.
[[nodiscard]] inline section::Classification classification_after_shaking(const std::vector<section::Period>& periods,
                                                                          bool has_rocked) {
  if (periods.back().moved) return section::unresolved(section::Reason::not_periodic, true);
  const bool ever_moved = std::ranges::any_of(periods, [](const section::Period& period) { return period.moved; });
  const bool has_slid = ever_moved && !has_rocked;
  return {.mode = {.kind = has_slid ? section::ResponseKind::slide : section::ResponseKind::rest},
          .reason = ever_moved ? section::Reason::came_to_rest : section::Reason::never_moved,
          .in_transient = false,
          .margin = section::largest_margin};
}

/// Number of strobe points for which a motion must be scheduled before a HorizonRun: at least one precedes the copy with
/// which a window begins.
[[nodiscard]] inline std::int64_t strobes_before_window(const Condition& condition) {
  return std::max<std::int64_t>(condition.horizon.transient_periods, 1);
}

/// One realisation on its way to the horizon, and its classification at the end. The motion has a pointer to the
/// recorder, so that the object cannot be moved. A copy of the motion at the beginning of the newest window is kept for
/// the tangent vectors.
class HorizonRun {
 public:
  /// `draws`: of the realisation, which begins so. make_motion(observer) returns its motion, scheduled for
  /// strobes_before_window.
  template <class MakeMotion>
  HorizonRun(const Condition& condition, const random::Draws& draws, const Beginning& beginning,
             MakeMotion&& make_motion)
      : condition_(&condition),
        draws_(draws),
        shape_angle_(beginning.setting.block.shape_angle),
        recorder_(beginning.setting.block, condition.horizon.periods()),
        motion_(make_motion(recorder_)) {
    result_.operations.initial_draws = beginning.draws;
    result_.clamps = beginning.clamps;
    if (condition.horizon.until_classified) settling_.emplace(condition.horizon);
  }
  HorizonRun(const HorizonRun&) = delete;
  HorizonRun& operator=(const HorizonRun&) = delete;

  [[nodiscard]] Motion& motion() { return motion_; }
  [[nodiscard]] integrate::LoopCounts& counts() { return counts_; }

  /// To be called before the first step: SettlingObserver::observe_long_run.
  void observe_long_run() { settling_->observe_long_run(); }

  /// To be called when the motion has ended. True if that was only the end of the transient and the motion continues.
  [[nodiscard]] bool go_on() {
    if (at_window_) return false;
    at_window_ = motion_;
    const std::int64_t more = condition_->horizon.periods() - strobes_before_window(*condition_);
    if (more > 0) motion_.extend(more);
    return !motion_.ended();
  }

  /// After go_on() has returned true: whether the window may be run with tangent vectors from its beginning.
  [[nodiscard]] bool may_begin_with_tangents() const {
    return !settling_ && condition_->horizon.transient_periods > 0 && !motion_.excitation().has_vertical();
  }
  /// Does so. The caller runs it to the end of the window and calls take_window(), then classify().
  [[nodiscard]] TangentRun& begin_with_tangents() {
    return tangent_run_.emplace(*at_window_, shape_angle_, condition_->horizon.sampled_periods, &recorder_);
  }
  /// The motion has become that with tangent vectors, after `counts` steps.
  void take_window(const integrate::LoopCounts& counts) {
    motion_ = tangent_run_->motion();
    motion_.observe_with(recorder_);
    counts_.steps += counts.steps;
    counts_.root_isolations += counts.root_isolations;
    tangent_run_->end_recording();
  }

  /// To be called when go_on() has returned false. Classifies the response in the newest window, unless that needs the
  /// exponent. In that case returns the run of the window with tangent vectors, which the caller runs to its end.
  [[nodiscard]] TangentRun* classify();

  /// What the exponent has to decide, while there is a run with tangent vectors.
  [[nodiscard]] const section::PendingClassification& pending() const { return pending_; }

  /// To be called when the newest window has been classified. True if the motion continues for another window, after
  /// which go_on() is called again.
  [[nodiscard]] bool begin_next_window();

  /// Mode of the newest window, when it has been classified.
  [[nodiscard]] const section::ResponseMode& newest_mode() const { return newest_mode_; }

  /// The result, to be called when everything has been run.
  [[nodiscard]] RealisationResult finish();

 private:
  void keep_periods();
  [[nodiscard]] section::PendingClassification classification_without_exponent();
  [[nodiscard]] std::optional<section::NearbyOrbit> find_orbit(const section::StrobePoint& near, int periods);
  void take(const section::Classification& newest);
  void take_exponent();

  const Condition* condition_;
  random::Draws draws_;
  double shape_angle_;
  StrobeRecorder recorder_;
  integrate::LoopCounts counts_;
  Motion motion_;
  std::optional<Motion> at_window_;  ///< at the beginning of the newest window
  RealisationResult result_;
  section::PendingClassification pending_;
  std::optional<TangentRun> tangent_run_;
  std::optional<SettlingObserver> settling_;
  ExponentRecord known_exponents_;     ///< of the windows up to now, while the response is not classified
  std::optional<OrbitSearch> orbits_;  ///< once one was asked for
  section::ResponseMode newest_mode_;
};

/// Keeps the strobe points up to the fixed horizon.
inline void HorizonRun::keep_periods() {
  const std::vector<section::Period>& periods = recorder_.periods();
  if (settling_) settling_->add_periods(periods);
  if (settling_ && settling_->is_continued()) return;
  result_.strobe.reserve(periods.size());
  for (const section::Period& period : periods) result_.strobe.push_back(period.point);
}

inline TangentRun* HorizonRun::classify() {
  keep_periods();
  pending_ = classification_without_exponent();
  const bool skips_exponent = settling_ && settling_->skips_exponent();
  if (!pending_.classification && !skips_exponent) {
    if (!tangent_run_) tangent_run_.emplace(*at_window_, shape_angle_, condition_->horizon.sampled_periods);
    return &*tangent_run_;
  }
  take(pending_.classification ? *pending_.classification : pending_.with_exponent(known_exponents_.estimate(), {}));
  return nullptr;
}

inline std::optional<section::NearbyOrbit> HorizonRun::find_orbit(const section::StrobePoint& near, int periods) {
  if (!orbits_) orbits_.emplace(*condition_, draws_);
  return orbits_->find(near, periods);
}

inline section::PendingClassification HorizonRun::classification_without_exponent() {
  const auto is = [](const section::Classification& classification) {
    section::PendingClassification found;
    found.classification = classification;
    return found;
  };
  const auto termination = motion_.termination().value_or(dynamics::Termination::stopped);
  if (termination == dynamics::Termination::overturned) {
    section::Classification overturned;
    overturned.mode = {.kind = section::ResponseKind::overturned};
    return is(overturned);
  }
  if (termination != dynamics::Termination::reached_horizon) return is({});
  if (!motion_.excitation().is_periodic())
    return is(classification_after_shaking(recorder_.periods(), motion_.peaks().tilt > 0.0));
  const std::int64_t sampled = condition_->horizon.sampled_periods;
  return section::classify(
      {.periods = std::span(recorder_.periods()).last(static_cast<std::size_t>(sampled)),
       .random = is_random_along_the_way(condition_->scene),
       .resolution = resolution_of(condition_->tolerance),
       .find_orbit = [this](const section::StrobePoint& near, int periods) { return find_orbit(near, periods); },
       .unfinished = recorder_.unfinished()});
}

/// Takes the classification of the newest window.
inline void HorizonRun::take(const section::Classification& newest) {
  newest_mode_ = newest.mode;
  if (!settling_) {
    result_.classification = newest;
    return;
  }
  settling_->take(newest, motion_.termination() == dynamics::Termination::reached_horizon);
  result_.classification = settling_->classification();
}

inline void HorizonRun::take_exponent() {
  const ExponentRun run = tangent_run_->result();
  tangent_run_.reset();
  result_.operations.exponent_periods += run.points.size();
  const bool is_of_long_run = settling_ && settling_->has_only_long_run();
  auto exponent = run.exponent;
  if (settling_) {
    known_exponents_.add(settling_->window_begin(), run);
    if (settling_->is_continued()) exponent = known_exponents_.estimate();
  }
  if (exponent && !is_of_long_run) result_.exponent = exponent;
  take(pending_.with_exponent(exponent, {.points = run.points, .exponent = run.over_all, .has_ended = run.has_ended}));
  const bool is_quasi_periodic = newest_mode_.kind == section::ResponseKind::quasi_periodic;
  if (is_quasi_periodic && !is_of_long_run) result_.exponent = run.over_all;
  if (settling_ && run.stayed_unclear && !is_quasi_periodic) settling_->pause_exponents();
}

inline bool HorizonRun::begin_next_window() {
  if (tangent_run_ && !pending_.classification) take_exponent();
  tangent_run_.reset();
  if (!settling_ || motion_.termination() != dynamics::Termination::reached_horizon) return false;
  if (!settling_->wants_window()) return false;
  const bool had_only_long_run = settling_->has_only_long_run();
  settling_->begin_window();
  if (settling_->has_only_long_run() && !had_only_long_run) collect(result_, motion_);
  recorder_.forget();
  at_window_ = motion_;
  motion_.extend(condition_->horizon.sampled_periods);
  return true;
}

inline RealisationResult HorizonRun::finish() {
  add(result_.operations, counts_);
  if (!settling_ || !settling_->has_only_long_run()) collect(result_, motion_);
  collect_counts(result_, motion_, recorder_);
  if (settling_) result_.settling = settling_->finish();
  return std::move(result_);
}

/// Runs the realisation on one lane. Throws base::Stopped if it is asked to stop.
[[nodiscard]] inline RealisationResult run_alone(HorizonRun& run, base::StopRequest stop) {
  do {
    while (!run.motion().ended() || run.go_on()) {
      stop.check();
      integrate::step(run.motion(), run.counts());
    }
    if (TangentRun* tangents = run.classify()) run_alone(*tangents, run.pending(), stop);
  } while (run.begin_next_window());
  return run.finish();
}

}  // namespace rocking
