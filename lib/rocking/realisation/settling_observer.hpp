#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>

#include "rocking/base/digest.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/section/classification.hpp"

namespace rocking {

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

/// Observes a realisation window by window until its response is classified (UntilClassified), watches whether it stays,
/// and counts the modes of a long run.
class SettlingObserver {
 public:
  /// Precondition: the horizon has UntilClassified.
  explicit SettlingObserver(const Horizon& horizon) : horizon_(&horizon), window_begin_(horizon.transient_periods) {}

  /// To be called before the first window. The windows are counted by mode up to the limit. The rest of the observation
  /// is what it is without this.
  void observe_long_run() { settling_.long_run.emplace(); }

  /// Takes the periods of the transient and the first window, later those of the newest window.
  void add_periods(std::span<const section::Period> periods) {
    observed_ += static_cast<std::int64_t>(periods.size());
    if (!continued_) return;
    for (const section::Period& period : periods) {
      continued_->add(period.point.tilt);
      continued_->add(period.point.tilt_rate);
      continued_->add(period.point.slip_rate);
    }
  }

  /// Whether the exponent of the newest window counts as unclear without being computed. To be called once a window.
  [[nodiscard]] bool skips_exponent() { return exponent_pause_ > 0 && exponent_pause_-- > 0; }
  /// The exponent of the newest window has stayed unclear.
  void pause_exponents() { exponent_pause_ = rules().exponent_pause; }

  /// Takes the classification of the newest window; `goes_on`: the motion has not ended in it.
  void take(const section::Classification& newest, bool goes_on) {
    if (!has_only_long_run_) observe(newest);
    if (settling_.long_run) count_window(newest.mode, goes_on);
  }

  /// Whether another window is observed, if the motion can go on.
  [[nodiscard]] bool wants_window() const {
    if (is_observed() && !settling_.long_run) return false;
    return observed_ + horizon_->sampled_periods <= rules().at_most_periods;
  }

  void begin_window() {
    has_only_long_run_ = is_observed();
    if (!continued_) continued_.emplace();
  }

  /// Whether the newest window is observed for the long run alone. The classification and the values of the motion are
  /// those from before it.
  [[nodiscard]] bool has_only_long_run() const { return has_only_long_run_; }
  /// The first period of the newest window.
  [[nodiscard]] std::int64_t window_begin() const { return observed_ - horizon_->sampled_periods; }
  /// Whether the newest window lies after the fixed horizon.
  [[nodiscard]] bool is_continued() const { return continued_.has_value(); }
  [[nodiscard]] const section::Classification& classification() const { return classification_; }

  [[nodiscard]] Settling finish() {
    if (continued_) settling_.continued = continued_->finish();
    return std::move(settling_);
  }

 private:
  [[nodiscard]] const UntilClassified& rules() const { return *horizon_->until_classified; }

  void observe(const section::Classification& newest) {
    if (!continued_) settling_.horizon_mode = newest.mode;
    const bool is_overturned = newest.mode.kind == section::ResponseKind::overturned;
    settling_.observed_periods = observed_ + (is_overturned ? 1 : 0);
    if (settling_.settling_period) {
      ++watched_;
      watch(newest.mode);
    } else {
      settle(newest);
    }
  }

  /// The response has settled if the newest `held_windows` windows gave one mode. Before that it is unresolved.
  void settle(const section::Classification& newest) {
    const bool is_classified = newest.mode.kind != section::ResponseKind::unresolved;
    const bool is_overturned = newest.mode.kind == section::ResponseKind::overturned;
    if (candidate_held_ == 0 || newest.mode != candidate_) {
      candidate_ = newest.mode;
      candidate_since_ = settling_.observed_periods;
      candidate_held_ = 0;
    }
    ++candidate_held_;
    const bool has_settled = is_classified && (is_overturned || candidate_held_ >= rules().held_windows);
    if (has_settled) settling_.settling_period = candidate_since_;
    classification_ =
        has_settled || !is_classified ? newest : section::unresolved(section::Reason::not_stationary, true);
  }

  /// A settled response is left by a window that gives another mode. A window that gives none leaves the question open.
  void watch(const section::ResponseMode& newest) {
    if (newest.kind == section::ResponseKind::unresolved || newest == classification_.mode) return;
    settling_.left_period = settling_.observed_periods;
    settling_.left_to = newest;
  }

  /// Whether the observation has ended, except for a long run.
  [[nodiscard]] bool is_observed() const {
    return settling_.settling_period && (watched_ >= rules().watch_windows || settling_.left_to);
  }

  /// If the motion has ended in the newest window, all later ones have the mode of this end.
  void count_window(const section::ResponseMode& mode, bool goes_on) {
    const CountedWindows counted = counted_windows(*horizon_);
    const std::uint64_t all = counted.from(window_begin_);
    window_begin_ += counted.length;
    const std::uint64_t count = goes_on ? all - counted.from(window_begin_) : all;
    if (count > 0) (*settling_.long_run)[mode] += count;
  }

  const Horizon* horizon_;
  Settling settling_;
  section::Classification classification_;
  std::int64_t observed_ = 0;                     ///< strobe points, with those of the newest window
  std::optional<base::Sha256Builder> continued_;  ///< of the strobe points after the fixed horizon, if there are any
  section::ResponseMode candidate_;               ///< of the newest windows
  std::int64_t candidate_since_ = 0;              ///< end of the first of these windows
  int candidate_held_ = 0;                        ///< number of these windows
  int watched_ = 0;                               ///< windows since the response has settled
  int exponent_pause_ = 0;                        ///< next windows in which the exponent counts as unclear
  std::int64_t window_begin_;                     ///< of the newest window, if windows are counted
  bool has_only_long_run_ = false;
};

}  // namespace rocking
