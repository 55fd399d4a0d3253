#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "rocking/dynamics/observer.hpp"
#include "rocking/section/period.hpp"

namespace rocking::experiment {

/// Observer of a realisation that keeps what its response mode depends on: a strobe point and the counted impacts for each
/// excitation period.
///
/// Impacts that put the block back over the same edge are not counted. A chatter, the run of impacts at ever shorter
/// intervals that leads to full contact, counts once.
class StrobeRecorder final : public dynamics::Observer {
 public:
  StrobeRecorder(double shape_angle, std::int64_t periods);

  void event(dynamics::EventKind kind, double tau, const dynamics::State& state) override;
  void strobe(const dynamics::State& state) override;

  [[nodiscard]] const std::vector<section::Period>& periods() const { return periods_; }
  [[nodiscard]] const std::array<std::uint64_t, dynamics::event_kind_count>& events() const { return events_; }

 private:
  void count_impact(double tau, double side);
  void merge_chatter();

  double shape_angle_;
  std::vector<section::Period> periods_;  ///< complete ones
  section::Period current_;
  std::array<std::uint64_t, dynamics::event_kind_count> events_{};
  double side_ = 0.0;  ///< over which the block stood before the coming impact; 0: not known yet
  double last_impact_ = 0.0;
  double last_interval_ = 0.0;
  std::vector<std::size_t> run_;  ///< periods of the counted impacts at ever shorter intervals
};

}  // namespace rocking::experiment
