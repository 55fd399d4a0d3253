#pragma once

#include <optional>
#include <vector>

#include "rocking/realisation/exponent.hpp"
#include "rocking/realisation/orbit_search.hpp"
#include "rocking/realisation/strobe_recorder.hpp"
#include "rocking/section/classify.hpp"

namespace rocking::evidence {

/// Sampled periods, counted from the start of the motion.
struct Window {
  int first = 0;
  int count = 0;
};

/// A realisation of a harmonic scene, run far beyond its horizon, that can be classified by any window.
class LongRun {
 public:
  LongRun(const Condition& condition, const random::Draws& draws, int periods);

  /// Classification by a window, and by the exponent from the end of the condition's transient on, over
  /// `exponent_periods` or up to the multiple that a run allows; overturned if it overturned before the end of the
  /// window.
  section::Classification name(const Window& window, int exponent_periods, const section::Thresholds& thresholds = {});
  [[nodiscard]] const std::vector<section::Period>& periods() const { return recorder_.periods(); }

  /// Exponent from the end of the condition's transient on, over as many periods as `pending` needs.
  [[nodiscard]] ExponentRun exponent(int periods, const section::PendingClassification& pending) const;

 private:
  double shape_angle_;
  double resolution_;
  bool random_;
  OrbitSearch orbits_;
  StrobeRecorder recorder_;
  std::optional<Motion> after_transient_;
  std::optional<dynamics::Termination> termination_;
};

}  // namespace rocking::evidence
