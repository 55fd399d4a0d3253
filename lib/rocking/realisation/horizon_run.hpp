#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "rocking/realisation/exponent.hpp"
#include "rocking/realisation/realisation_result.hpp"
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

/// Copies the results of a finished motion, except the classification.
inline void collect(RealisationResult& result, const Motion& motion, const StrobeRecorder& recorder) {
  result.termination = motion.termination().value_or(dynamics::Termination::stopped);
  result.losses_of_contact = motion.losses_of_contact();
  result.losses_before_fall = motion.losses_before_fall();
  result.first_loss_of_contact = motion.first_loss_of_contact();
  result.was_past_balance = motion.was_past_balance();
  result.contradictions = motion.contradictions();
  result.peaks = peaks_of(motion, motion.setting().block);
  result.operations.slip_steps = motion.slip_steps();
  result.operations.events = recorder.events();
  motion.coefficients().add_to(result.operations);
  result.operations.ground_motion_segments = motion.segments_looked_up();
  result.clamps += motion.coefficients().clamps();
}

/// Classification under a recorded excitation, which does not repeat: the block is at rest at the end, or it is not.
[[nodiscard]] inline section::Classification classification_after_shaking(const std::vector<section::Period>& periods) {
  if (periods.back().moved) return section::unresolved(section::Reason::not_periodic, true);
  const bool ever_moved = std::ranges::any_of(periods, [](const section::Period& period) { return period.moved; });
  return {.mode = {.kind = section::ResponseKind::rest},
          .reason = ever_moved ? section::Reason::came_to_rest : section::Reason::never_moved,
          .in_transient = false,
          .margin = section::largest_margin};
}

/// Number of strobe points for which a motion must be scheduled before a HorizonRun: at least one precedes the copy for
/// the perturbed trajectory.
[[nodiscard]] inline std::int64_t strobes_before_copy(const Condition& condition) {
  return std::max<std::int64_t>(condition.horizon.transient_periods, 1);
}

/// Whether the realisation is observed up to the limit of UntilClassified.
[[nodiscard]] inline bool has_long_run(const Condition& condition, std::uint64_t realisation) {
  const auto& until = condition.horizon.until_classified;
  return until && until->long_run_every > 0 && realisation % until->long_run_every == 0;
}

/// Windows in the second half of `at_most_periods`, in which the modes of a long run are counted; at least the last one.
struct CountedWindows {
  std::int64_t first = 0;   ///< earliest period with which a counted window may begin
  std::int64_t last = 0;    ///< period with which the last window begins
  std::int64_t length = 1;  ///< of a window, in periods

  /// Number of counted windows among that which begins with this period and all later ones.
  [[nodiscard]] std::uint64_t from(std::int64_t begin) const {
    if (begin < first) begin += (first - begin + length - 1) / length * length;
    return begin > last ? 0 : static_cast<std::uint64_t>((last - begin) / length + 1);
  }
};

/// Precondition: the condition has UntilClassified.
[[nodiscard]] inline CountedWindows counted_windows(const Horizon& horizon) {
  const std::int64_t length = horizon.sampled_periods;
  const std::int64_t limit = horizon.until_classified->at_most_periods;
  const std::int64_t last = horizon.transient_periods + (limit - horizon.transient_periods - length) / length * length;
  return {.first = std::min(limit / 2, last), .last = last, .length = length};
}

/// One realisation on its way to the horizon, and its classification at the end. The motion has a pointer to the
/// recorder, so that the object cannot be moved. A copy of the motion at the end of the transient is kept for the
/// reference and the perturbed trajectory.
class HorizonRun {
 public:
  /// make_motion(observer) returns the motion of the realisation that begins so, scheduled for strobes_before_copy.
  template <class MakeMotion>
  HorizonRun(const Condition& condition, const Beginning& beginning, MakeMotion&& make_motion)
      : condition_(&condition),
        shape_angle_(beginning.setting.block.shape_angle),
        recorder_(shape_angle_, condition.horizon.transient_periods + condition.horizon.sampled_periods),
        motion_(make_motion(recorder_)) {
    result_.operations.initial_draws = beginning.draws;
    result_.clamps = beginning.clamps;
    window_begin_ = condition.horizon.transient_periods;
  }
  HorizonRun(const HorizonRun&) = delete;
  HorizonRun& operator=(const HorizonRun&) = delete;

  [[nodiscard]] Motion& motion() { return motion_; }
  [[nodiscard]] integrate::LoopCounts& counts() { return counts_; }

  /// To be called before the first step. The windows of the realisation are counted by mode up to the limit. The rest
  /// of the result, without operation counts, clamps and the digest of the motion, is what it is without this.
  void observe_long_run() { result_.settling.emplace().long_run.emplace(); }

  /// To be called when the motion has ended. True if that was only the end of the transient and the motion continues.
  [[nodiscard]] bool go_on() {
    if (after_transient_) return false;
    after_transient_ = motion_;
    const Horizon& horizon = condition_->horizon;
    const std::int64_t more = horizon.transient_periods + horizon.sampled_periods - strobes_before_copy(*condition_);
    if (more > 0) motion_.extend(more);
    return !motion_.ended();
  }

  /// To be called when go_on() has returned false. Classifies the response in the newest window, unless that needs the
  /// exponent. In that case returns the pair of trajectories, which the caller runs to its end.
  [[nodiscard]] PerturbedPair* classify();

  /// To be called when the newest window has been classified. True if the motion continues for another window, after
  /// which go_on() is called again.
  [[nodiscard]] bool begin_next_window();
  /// Mode of the newest window, when it has been classified.
  [[nodiscard]] const section::ResponseMode& newest_mode() const { return newest_mode_; }

  /// The result, to be called when everything has been run.
  [[nodiscard]] RealisationResult finish();

 private:
  void keep_periods();
  [[nodiscard]] std::optional<section::Classification> classification_without_exponent();
  void take(const section::Classification& newest);
  void settle(const section::Classification& newest);
  void watch(const section::ResponseMode& newest);
  [[nodiscard]] bool is_observed() const;
  void count_window();
  void keep_observed();

  const Condition* condition_;
  double shape_angle_;
  StrobeRecorder recorder_;
  integrate::LoopCounts counts_;
  Motion motion_;
  std::optional<Motion> after_transient_;  ///< later: at the beginning of the newest window
  RealisationResult result_;
  section::PendingClassification classification_;
  std::optional<PerturbedPair> perturbed_pair_;
  // Only used with `until_classified`.
  std::int64_t observed_ = 0;                     ///< strobe points before the newest window, later with those in it
  std::optional<base::Sha256Builder> continued_;  ///< of the strobe points after the fixed horizon, if there are any
  section::ResponseMode candidate_;               ///< of the newest windows
  std::int64_t candidate_since_ = 0;              ///< end of the first of these windows
  int candidate_held_ = 0;                        ///< number of these windows
  int watched_ = 0;                               ///< windows since the response has settled
  int exponent_pause_ = 0;                        ///< next windows in which the exponent counts as unclear
  section::ResponseMode newest_mode_;
  std::int64_t window_begin_ = 0;                     ///< of the newest window, if windows are counted
  std::optional<RealisationResult> observed_result_;  ///< when only the long run was left to observe
};

/// Keeps the strobe points up to the fixed horizon and the digest of the later ones.
inline void HorizonRun::keep_periods() {
  observed_ += static_cast<std::int64_t>(recorder_.periods().size());
  if (!continued_) result_.strobe.reserve(recorder_.periods().size());
  for (const section::Period& period : recorder_.periods()) {
    if (continued_) {
      continued_->add(period.point.tilt);
      continued_->add(period.point.tilt_rate);
      continued_->add(period.point.slip_rate);
    } else {
      result_.strobe.push_back(period.point);
    }
  }
}

inline PerturbedPair* HorizonRun::classify() {
  keep_periods();
  perturbed_pair_.reset();
  const auto classification = classification_without_exponent();
  const bool pauses = exponent_pause_ > 0;
  if (pauses) --exponent_pause_;
  if (!classification && pauses) {
    take(classification_.with_exponent(std::nullopt));
    return nullptr;
  }
  if (!classification) {
    return &perturbed_pair_.emplace(*after_transient_, shape_angle_, condition_->horizon.sampled_periods);
  }
  take(*classification);
  return nullptr;
}

inline std::optional<section::Classification> HorizonRun::classification_without_exponent() {
  const auto termination = motion_.termination().value_or(dynamics::Termination::stopped);
  if (termination == dynamics::Termination::overturned) {
    section::Classification overturned;
    overturned.mode = {.kind = section::ResponseKind::overturned};
    return overturned;
  }
  if (termination != dynamics::Termination::reached_horizon) return section::Classification{};
  if (!motion_.excitation().is_periodic()) return classification_after_shaking(recorder_.periods());
  const std::int64_t sampled = condition_->horizon.sampled_periods;
  classification_ =
      section::classify({.periods = std::span(recorder_.periods()).last(static_cast<std::size_t>(sampled)),
                         .random = is_random(condition_->scene),
                         .resolution = resolution_of(condition_->tolerance)});
  return classification_.classification;
}

/// Takes the classification of the newest window.
inline void HorizonRun::take(const section::Classification& newest) {
  newest_mode_ = newest.mode;
  if (observed_result_) return;
  if (!condition_->horizon.until_classified) {
    result_.classification = newest;
    return;
  }
  if (!result_.settling) result_.settling.emplace();
  Settling& settling = *result_.settling;
  if (!continued_) settling.horizon_mode = newest.mode;
  const bool is_overturned = newest.mode.kind == section::ResponseKind::overturned;
  settling.observed_periods = observed_ + (is_overturned ? 1 : 0);
  if (settling.settling_period) {
    ++watched_;
    watch(newest.mode);
  } else {
    settle(newest);
  }
}

/// The response has settled if the newest `held_windows` windows gave one mode. Before that it is unresolved.
inline void HorizonRun::settle(const section::Classification& newest) {
  Settling& settling = *result_.settling;
  const bool is_classified = newest.mode.kind != section::ResponseKind::unresolved;
  const bool is_overturned = newest.mode.kind == section::ResponseKind::overturned;
  if (candidate_held_ == 0 || newest.mode != candidate_) {
    candidate_ = newest.mode;
    candidate_since_ = settling.observed_periods;
    candidate_held_ = 0;
  }
  ++candidate_held_;
  const bool has_settled =
      is_classified && (is_overturned || candidate_held_ >= condition_->horizon.until_classified->held_windows);
  if (has_settled) settling.settling_period = candidate_since_;
  result_.classification =
      has_settled || !is_classified ? newest : section::unresolved(section::Reason::not_stationary, true);
}

/// A settled response is left by a window that gives another mode. A window that gives none leaves the question open.
inline void HorizonRun::watch(const section::ResponseMode& newest) {
  if (newest.kind == section::ResponseKind::unresolved || newest == result_.classification.mode) return;
  result_.settling->left_period = result_.settling->observed_periods;
  result_.settling->left_to = newest;
}

/// Whether the observation has ended, except for a long run.
inline bool HorizonRun::is_observed() const {
  const Settling& settling = *result_.settling;
  return settling.settling_period &&
         (watched_ >= condition_->horizon.until_classified->watch_windows || settling.left_to);
}

/// Counts the newest window. If the motion has ended in it, all later ones have the mode of this end.
inline void HorizonRun::count_window() {
  const CountedWindows counted = counted_windows(condition_->horizon);
  const std::uint64_t all = counted.from(window_begin_);
  window_begin_ += counted.length;
  const bool goes_on = motion_.termination() == dynamics::Termination::reached_horizon;
  const std::uint64_t count = goes_on ? all - counted.from(window_begin_) : all;
  if (count > 0) (*result_.settling->long_run)[newest_mode_] += count;
}

inline void HorizonRun::keep_observed() {
  observed_result_ = result_;
  collect(*observed_result_, motion_, recorder_);
}

inline bool HorizonRun::begin_next_window() {
  if (perturbed_pair_) {
    const ExponentRun run = perturbed_pair_->result();
    result_.operations.perturbed_pair_periods += run.periods;
    perturbed_pair_.reset();
    take(classification_.with_exponent(run.exponent));
    const auto& until = condition_->horizon.until_classified;
    if (until && run.stayed_unclear) exponent_pause_ = until->exponent_pause;
  }
  const Horizon& horizon = condition_->horizon;
  if (!horizon.until_classified) return false;
  const bool has_long_run = result_.settling->long_run.has_value();
  if (has_long_run) count_window();
  if (motion_.termination() != dynamics::Termination::reached_horizon) return false;
  if (is_observed() && !has_long_run) return false;
  if (observed_ + horizon.sampled_periods > horizon.until_classified->at_most_periods) return false;
  if (is_observed() && !observed_result_) keep_observed();
  if (!continued_) continued_.emplace();
  recorder_.forget();
  after_transient_ = motion_;
  motion_.extend(horizon.sampled_periods);
  return true;
}

inline RealisationResult HorizonRun::finish() {
  add(result_.operations, counts_);
  collect(result_, motion_, recorder_);
  if (observed_result_) {
    observed_result_->operations = result_.operations;
    observed_result_->clamps = result_.clamps;
    observed_result_->settling->long_run = std::move(result_.settling->long_run);
    result_ = std::move(*observed_result_);
  }
  if (continued_) result_.settling->continued = continued_->finish();
  return std::move(result_);
}

/// Runs the realisation on one lane. Throws base::Stopped if it is asked to stop.
[[nodiscard]] inline RealisationResult run_alone(HorizonRun& run, base::StopRequest stop) {
  do {
    while (!run.motion().ended() || run.go_on()) {
      stop.check();
      integrate::step(run.motion(), run.counts());
    }
    if (PerturbedPair* perturbed_pair = run.classify()) run_alone(*perturbed_pair, stop);
  } while (run.begin_next_window());
  return run.finish();
}

}  // namespace rocking
