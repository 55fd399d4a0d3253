#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/base/stop_request.hpp"
#include "rocking/realisation/start.hpp"
#include "rocking/realisation/tangent_motion.hpp"
#include "rocking/section/classify.hpp"

namespace rocking {

/// Result and cost of a run with tangent vectors.
struct ExponentRun {
  std::optional<section::ExponentEstimate> exponent;  ///< of the periods that its sign needed; absent: too few
  std::optional<section::ExponentEstimate> over_all;  ///< of all periods
  std::vector<section::StrobePoint> points;           ///< of its excitation periods
  std::vector<double> growths;  ///< ln of the growth of the vectors, for each period in which it was measured
  bool stayed_unclear = false;  ///< the longest run that is made did not decide
  bool has_ended = false;       ///< the motion ended before the periods asked for
};

/// Largest Lyapunov exponent per excitation period of a window, from the derivative of the motion in it. The random
/// numbers are held.
///
/// The motion of the window is run again with the tangent vectors of theta, w and V. From strobe point to strobe point
/// the norm of this matrix (Frobenius, in units of Theta, Theta' and V) grows by a factor; the exponent is the mean of
/// its logarithm. The standard error is that of the mean of eight successive batches. Source: Benettin, Galgani,
/// Giorgilli & Strelcyn (1980), Meccanica 15, 9-20.
///
/// The motion reports to this object, which therefore cannot be moved.
class TangentRun final : private dynamics::Observer {
 public:
  using Motion = TangentMotion<rocking::Motion, 3>;

  /// `from`: the motion at the beginning of the window. It is continued for the `periods` periods of the window, and for
  /// up to eight times as many while that may decide the classification. `recorder`: of the window, in place of the
  /// motion that would be run without vectors; it records until end_recording().
  TangentRun(const rocking::Motion& from, double shape_angle, std::int64_t periods,
             dynamics::Observer* recorder = nullptr);
  TangentRun(const TangentRun&) = delete;
  TangentRun& operator=(const TangentRun&) = delete;

  [[nodiscard]] Motion& motion() { return motion_; }

  /// From now on the motion serves the vectors only.
  void end_recording();

  /// To be called when the motion has ended. True if it continues, because that does not decide `pending` yet.
  [[nodiscard]] bool go_on(const section::PendingClassification& pending);

  /// The result, to be called when go_on() has returned false.
  [[nodiscard]] ExponentRun result();

 private:
  void event(dynamics::EventKind kind, double tau, const dynamics::State& state) override {
    if (recorder_ != nullptr) recorder_->event(kind, tau, state);
  }
  void strobe(const dynamics::State& state) override;

  double shape_angle_;
  std::int64_t window_;  ///< [periods]
  std::int64_t goal_;    ///< periods after which the exponent is next tested
  double size_;          ///< norm of the vectors at the last strobe point; 0 where nothing can change
  std::vector<section::StrobePoint> points_;
  std::vector<double> growths_;  ///< ln of its growth, for each period in which it was measured
  std::optional<section::ExponentEstimate> exponent_;
  std::optional<section::ExponentEstimate> over_all_;
  bool is_undecided_ = true;
  dynamics::Observer* recorder_;
  Motion motion_;
};

/// The exponent of a motion from all runs of its windows. Evidence adds up as long as the exponent stays the same.
class ExponentRecord {
 public:
  /// Takes a run that began with this period. Its periods that an earlier run has covered are not counted again. Where its
  /// exponent differs by more than three standard errors from that of the runs before, these are forgotten.
  void add(std::int64_t begin, const ExponentRun& run);

  /// Absent before the first run that had enough periods.
  [[nodiscard]] std::optional<section::ExponentEstimate> estimate() const;

 private:
  std::vector<double> growths_;
  std::int64_t covered_ = 0;  ///< first period that no run has covered
  int looks_ = 0;
};

/// Runs the motion on one lane to its end. Throws base::Stopped if it is asked to stop.
void run_alone(TangentRun& run, const section::PendingClassification& pending, base::StopRequest stop = {});

}  // namespace rocking
