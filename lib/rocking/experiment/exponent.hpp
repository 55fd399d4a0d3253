#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/base/stop_request.hpp"
#include "rocking/experiment/realisation.hpp"
#include "rocking/section/classify.hpp"

namespace rocking::experiment {

/// What two copies under the same draws tell, and what it cost.
struct CompanionRun {
  std::optional<section::ExponentEstimate> exponent;  ///< absent: the run ended too early
  std::uint64_t periods = 0;                          ///< run, both copies together
};

/// Largest Lyapunov exponent per excitation period, from a companion displaced by 1e-7 under the same draws and put back
/// to that distance at every strobe point. The companion passes through events of its own, so that the saltation at them
/// is in its distance. The standard error is that of the mean of eight batches in a row.
/// Source: Benettin, Galgani, Giorgilli & Strelcyn (1980), Meccanica 15, 9-20.
///
/// Leader and companion are advanced by others, from one strobe point to the next. Stays where it is: they tell it of these.
class CompanionPair {
 public:
  /// `from`: a realisation at the end of its transient; it is run on over `periods` more, and over up to eight times as
  /// many while the exponent is not clear of zero.
  CompanionPair(const Motion& from, double shape_angle, std::int64_t periods);
  CompanionPair(const CompanionPair&) = delete;
  CompanionPair& operator=(const CompanionPair&) = delete;

  [[nodiscard]] Motion& leader() { return leader_; }
  [[nodiscard]] Motion& companion() { return companion_; }

  /// Once both have ended: true if that was only the end of a period, and both go on.
  [[nodiscard]] bool go_on();

  /// Once they do not go on.
  [[nodiscard]] CompanionRun result() const;

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

  Motion leader_;
  Motion companion_;
  LastStrobe leader_strobe_;
  LastStrobe companion_strobe_;
  double shape_angle_;
  std::int64_t longest_;  ///< [periods]
  std::int64_t goal_;     ///< periods after which the exponent is looked at
  std::int64_t done_ = 0;
  dynamics::Displacement direction_;
  double distance_ = 0.0;        ///< at the beginning of the period
  std::vector<double> growths_;  ///< ln of the growth of the distance, over each period in which there was one
  std::optional<section::ExponentEstimate> exponent_;
};

/// Runs both on one lane, until they do not go on. Throws base::Stopped once it is asked to stop.
void run_alone(CompanionPair& pair, base::StopRequest stop = {});

}  // namespace rocking::experiment
