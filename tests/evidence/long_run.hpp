#pragma once

#include <optional>
#include <vector>

#include "rocking/experiment/exponent.hpp"
#include "rocking/experiment/strobe_recorder.hpp"
#include "rocking/section/classify.hpp"

namespace rocking::evidence {

/// Sampled periods, counted from the start of the motion.
struct Window {
  int first = 0;
  int count = 0;
};

/// A realisation of a harmonic scene, run on far beyond its horizon, that can be named by any window of it.
class LongRun {
 public:
  using Motion = experiment::Motion;

  LongRun(const experiment::Condition& condition, const random::Draws& draws, int periods);

  /// The name by a window, and by the exponent from the end of the condition's transient on, of `exponent_periods` or as
  /// many times more as a run takes; overturned if it did so before the window's end.
  section::Verdict name(const Window& window, int exponent_periods, const section::Thresholds& thresholds = {});
  [[nodiscard]] const std::vector<section::Period>& periods() const { return recorder_.periods(); }

  /// From the end of the condition's transient on. Computed once for each number of periods.
  [[nodiscard]] const experiment::CompanionRun& exponent(int periods);

 private:
  double shape_angle_;
  double resolution_;
  bool random_;
  experiment::StrobeRecorder recorder_;
  std::optional<Motion> after_transient_;
  std::optional<dynamics::Termination> termination_;
  std::vector<std::pair<int, experiment::CompanionRun>> exponents_;  ///< by the periods asked for
};

}  // namespace rocking::evidence
