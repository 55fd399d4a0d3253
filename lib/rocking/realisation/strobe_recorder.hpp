#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "rocking/dynamics/block.hpp"
#include "rocking/dynamics/observer.hpp"
#include "rocking/section/classification.hpp"

namespace rocking {

/// Observer of a realisation that keeps what determines its response mode: a strobe point and the number of impacts for
/// each excitation period.
///
/// Impacts after which the block turns about the same edge are not counted. A chatter counts once. It is the sequence
/// of impacts that leads to full contact, in which each impact is weaker than the one before on the same edge (the
/// edges may alternate, one being weaker than the other). At a wall every impact counts as two: it ends a rock.
class StrobeRecorder final : public dynamics::Observer {
 public:
  StrobeRecorder(const dynamics::Geometry& block, std::int64_t periods);

  void event(dynamics::EventKind kind, double tau, const dynamics::State& state) override;
  void strobe(const dynamics::State& state) override;

  /// The complete periods since the last forget().
  [[nodiscard]] const std::vector<section::Period>& periods() const { return periods_; }
  /// So many of the last ones have impacts of a run that may turn out to be a chatter, which would count once.
  [[nodiscard]] std::size_t unfinished() const;
  /// Drops the complete periods, so that memory stays bounded. A chatter that ends later does not change them.
  void forget();
  [[nodiscard]] const std::array<std::uint64_t, dynamics::event_kind_count>& events() const { return events_; }

 private:
  static constexpr std::array<double, 2> no_rates{std::numeric_limits<double>::infinity(),
                                                  std::numeric_limits<double>::infinity()};

  void count_impact(const dynamics::State& after);
  void merge_chatter();
  [[nodiscard]] std::uint16_t impacts_of_one() const { return is_at_wall_ ? 2 : 1; }

  std::array<double, 2> shape_angles_;  ///< of the left and the right edge
  bool is_at_wall_;
  std::vector<section::Period> periods_;  ///< complete ones
  std::size_t forgotten_ = 0;             ///< number of periods before these
  section::Period current_;
  std::array<std::uint64_t, dynamics::event_kind_count> events_{};
  double side_ = 0.0;  ///< edge about which the block turned before the next impact; 0: not known yet
  /// Absolute tilt rates after the last impact and the one before it; infinite if there was none.
  std::array<double, 2> last_rates_ = no_rates;
  std::vector<std::size_t> run_;  ///< periods of the counted impacts that may turn out to be a chatter
};

}  // namespace rocking
