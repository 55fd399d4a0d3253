#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/coefficients.hpp"
#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/result.hpp"
#include "rocking/random/draws.hpp"

namespace rocking::experiment {

/// Friction, restitution and amplitude of one realisation: means from the scene, deviations from its draws. A source whose
/// sigma is 0 draws nothing. Models dynamics::CoefficientSource; the rules are in lib/docs/model.md, section 5.
///
/// Kinetic friction is a function of time alone (one draw for each interval of a grid), held at the static friction in
/// force. Static friction and restitution count their draws from the last chatter's end, so that what a chatter consumes,
/// which depends on the tolerance, is not seen later: where a chatter held stops, the static friction after it is the first
/// draw of the new count.
class SceneCoefficients {
 public:
  SceneCoefficients(const Scene& scene, const random::Draws& draws);

  [[nodiscard]] bool has_friction() const { return friction_.has_value(); }
  [[nodiscard]] double static_friction() const { return static_friction_; }
  [[nodiscard]] double kinetic_friction(const dynamics::Clock& clock);
  [[nodiscard]] double restitution();
  [[nodiscard]] double amplitude(const dynamics::Clock& clock);
  void stop();
  void chatter_ended();
  [[nodiscard]] std::optional<dynamics::Instant> next_change(const dynamics::Clock& clock, bool slipping) const;
  [[nodiscard]] std::optional<double> constant_restitution() const {
    return fluctuation_.restitution == 0.0 ? std::optional(restitution_mean_) : std::nullopt;
  }
  [[nodiscard]] dynamics::FrictionForesight foresee() const;
  void pass_intervals(const dynamics::Clock& clock, std::size_t count);

  /// The same draws, counted on, about the means and with the standard deviations of another scene.
  [[nodiscard]] SceneCoefficients under(const Scene& scene) const;

  /// Draws made so far, and of them those clamped where they were used.
  void add_to(Effort& effort) const;
  [[nodiscard]] const Clamps& clamps() const { return clamps_; }

 private:
  /// Counts of what has happened, from which the indices of draws are made.
  struct Count {
    std::uint64_t chatters = 0;
    std::uint64_t since = 0;  ///< impacts or stops since the last chatter's end
  };

  void move_to_interval(const dynamics::Clock& clock, std::int64_t interval);
  [[nodiscard]] dynamics::Instant boundary_after_end(const dynamics::Clock& clock, std::int64_t count) const;
  [[nodiscard]] dynamics::Instant boundary(const dynamics::Clock& clock, std::int64_t interval) const;
  [[nodiscard]] std::int64_t grid_index(const dynamics::Clock& clock) const;
  [[nodiscard]] std::int64_t searched_grid_index(const dynamics::Clock& clock) const;
  void draw_kinetic_friction(std::int64_t interval);
  [[nodiscard]] double held_kinetic_friction(double wanted);
  void draw_static_friction();
  void look_up_static_friction();
  [[nodiscard]] double drawn_kinetic_friction(const dynamics::Clock& clock);

  std::optional<Friction> friction_;
  Fluctuation fluctuation_;
  double restitution_mean_;
  double amplitude_mean_;
  random::Draws draws_;

  double static_friction_;
  Count stops_;
  Count static_count_;  ///< of stops, when the static friction in force was drawn
  Count impacts_;
  /// Kinetic friction is drawn for as many intervals in a row.
  static constexpr std::int64_t intervals_at_once = 32;
  static constexpr std::int64_t none_drawn = -intervals_at_once;

  std::int64_t interval_ = -1;  ///< of the kinetic friction held below
  dynamics::Instant begin_;
  dynamics::Instant end_;
  std::int64_t end_number_ = 0;                    ///< of the boundary at its end, within its period
  std::int64_t drawn_from_ = none_drawn;           ///< of the first of them
  std::array<double, intervals_at_once> drawn_{};  ///< kinetic friction, before it is held between 0 and the static
  double kinetic_friction_ = 0.0;
  bool held_at_static_ = false;  ///< this interval's (or, on a constant mean, this static draw's) clamp is counted
  std::int64_t amplitude_period_ = -1;
  double amplitude_ = 0.0;

  Clamps clamps_;
  std::uint64_t static_draws_ = 0;
  std::uint64_t kinetic_draws_ = 0;
  std::uint64_t restitution_draws_ = 0;
  std::uint64_t amplitude_draws_ = 0;
};

}  // namespace rocking::experiment
