#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "rocking/dynamics/observer.hpp"
#include "rocking/section/period.hpp"

namespace rocking::experiment {

/// Observer of a realisation that keeps what its response mode depends on: a strobe point and the counted impacts for each
/// excitation period.
///
/// Impacts that put the block back over the same edge are not counted. A chatter counts once: the run of impacts that
/// leads to full contact, each weaker than the one before on its own edge (the two edges may take turns, one weaker than
/// the other).
class StrobeRecorder final : public dynamics::Observer {
 public:
  StrobeRecorder(double shape_angle, std::int64_t periods);

  void event(dynamics::EventKind kind, double tau, const dynamics::State& state) override;
  void strobe(const dynamics::State& state) override;

  [[nodiscard]] const std::vector<section::Period>& periods() const { return periods_; }
  [[nodiscard]] const std::array<std::uint64_t, dynamics::event_kind_count>& events() const { return events_; }

 private:
  static constexpr std::array<double, 2> no_rates{std::numeric_limits<double>::infinity(),
                                                  std::numeric_limits<double>::infinity()};

  void count_impact(const dynamics::State& after);
  void merge_chatter();

  double shape_angle_;
  std::vector<section::Period> periods_;  ///< complete ones
  section::Period current_;
  std::array<std::uint64_t, dynamics::event_kind_count> events_{};
  double side_ = 0.0;  ///< over which the block stood before the coming impact; 0: not known yet
  /// Sizes of the tilt rate after the last impact and the one before it; infinite before there was one.
  std::array<double, 2> last_rates_ = no_rates;
  std::vector<std::size_t> run_;  ///< periods of the counted impacts of the run that may become a chatter
};

}  // namespace rocking::experiment
