#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/base/stop_request.hpp"
#include "rocking/realisation/start.hpp"
#include "rocking/section/classify.hpp"

namespace rocking {

/// Result and cost of a pair of trajectories with common random numbers.
struct ExponentRun {
  std::optional<section::ExponentEstimate> exponent;  ///< absent if the run ended too early
  std::uint64_t periods = 0;                          ///< excitation periods, of both trajectories together
  bool stayed_unclear = false;  ///< it did not differ clearly from zero in the longest run that is made
};

/// Largest Lyapunov exponent per excitation period, from a reference trajectory and a perturbed one with common random
/// numbers. The perturbation is 1e-7; it is reset to that distance at every strobe point. The perturbed trajectory
/// passes through its own events, so that its distance includes the saltation at them. The standard error is that of
/// the mean of eight successive batches. Source: Benettin, Galgani, Giorgilli & Strelcyn (1980), Meccanica 15, 9-20.
///
/// The caller advances the two trajectories from one strobe point to the next. They report to this object, which
/// therefore cannot be moved.
class PerturbedPair {
 public:
  /// `from`: a realisation at the end of its transient. It is continued for `periods` periods, and for up to eight
  /// times as many while the exponent does not differ clearly from zero.
  PerturbedPair(const Motion& from, double shape_angle, std::int64_t periods);
  PerturbedPair(const PerturbedPair&) = delete;
  PerturbedPair& operator=(const PerturbedPair&) = delete;

  [[nodiscard]] Motion& reference() { return reference_; }
  [[nodiscard]] Motion& perturbed() { return perturbed_; }

  /// To be called when both trajectories have ended. True if that was only the end of a period and both continue.
  [[nodiscard]] bool go_on();

  /// The result, to be called when go_on() has returned false.
  [[nodiscard]] ExponentRun result() const;

 private:
  /// Keeps the last strobe state.
  class LastStrobe final : public dynamics::Observer {
   public:
    void event(dynamics::EventKind, double, const dynamics::State&) override {}
    void strobe(const dynamics::State& state) override { state_ = state; }
    [[nodiscard]] const dynamics::State& state() const { return state_; }

   private:
    dynamics::State state_;
  };

  void begin_period();
  void measure_growth();

  Motion reference_;
  Motion perturbed_;
  LastStrobe reference_strobe_;
  LastStrobe perturbed_strobe_;
  double shape_angle_;
  std::int64_t longest_;  ///< [periods]
  std::int64_t goal_;     ///< periods after which the exponent is next tested
  std::int64_t done_ = 0;
  dynamics::Displacement direction_;
  double distance_ = 0.0;        ///< at the beginning of the period
  std::vector<double> growths_;  ///< ln of the growth of the distance, for each period in which it was measured
  std::optional<section::ExponentEstimate> exponent_;
};

/// Runs both trajectories on one lane to their end. Throws base::Stopped if it is asked to stop.
void run_alone(PerturbedPair& pair, base::StopRequest stop = {});

}  // namespace rocking
