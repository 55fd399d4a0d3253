#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "rocking/dynamics/clock.hpp"
#include "rocking/dynamics/coefficients.hpp"
#include "rocking/random/branched_draws.hpp"
#include "rocking/realisation/friction_cells.hpp"
#include "rocking/realisation/measures.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/restitution.hpp"

namespace rocking {

/// What the coefficients of a realisation are drawn from along the way; of one that is not, the number.
struct CoefficientLaws {
  RedrawnQuantity static_friction = 0.0;
  RedrawnQuantity kinetic_friction = 0.0;
  double correlation = 0.0;           ///< of the normal numbers of both
  double own_share = 1.0;             ///< sqrt(1 - correlation^2): of kinetic friction's own number
  RedrawnQuantity restitution = 0.0;  ///< at the left edge
  Reach restitution_reach;            ///< at any edge
  RightEdge right_edge;
  RedrawnQuantity amplitude = 0.0;
};

/// Friction, restitution and amplitude of one realisation: means from the scene, deviations from its random numbers. If
/// the sigma of a source is 0, nothing is drawn. Models dynamics::CoefficientSource; the rules are in
/// lib/docs/model.md, section 5.
///
/// Friction belongs to the place (FrictionCells), or kinetic friction depends on time only: one draw for each interval of
/// a grid. It is limited to the static friction in force. The draws of static friction in time and of restitution are
/// counted from the end of the last chatter. The number of draws within a chatter depends on the tolerance; later draws do
/// not depend on it. If a chatter contained stops, the static friction after it is the first draw of the new count.
class SceneCoefficients {
 public:
  /// `own`: the block of the realisation, in whose units A_h and e are.
  SceneCoefficients(const Scene& scene, const random::BranchedDraws& draws, const dynamics::Geometry& own);
  /// Of the mean block.
  SceneCoefficients(const Scene& scene, const random::BranchedDraws& draws)
      : SceneCoefficients(scene, draws, dynamics::geometry_of(mean_block(scene))) {}

  [[nodiscard]] bool has_friction() const { return has_friction_; }
  [[nodiscard]] double static_friction() const { return static_friction_; }
  [[nodiscard]] double kinetic_friction(const dynamics::Clock& clock);
  /// `landing`: a number with the sign of the side whose edge lands.
  [[nodiscard]] double restitution(double landing = 1.0);
  [[nodiscard]] double amplitude(const dynamics::Clock& clock);
  void stop();
  void chatter_ended();
  [[nodiscard]] std::optional<dynamics::Instant> next_change(const dynamics::Clock& clock, bool slipping) const;
  [[nodiscard]] std::optional<double> constant_restitution() const {
    const auto* constant = std::get_if<double>(&laws_.restitution);
    return constant != nullptr && is_alike_at_both_edges() ? std::optional(*constant) : std::nullopt;
  }
  void place(double slip);
  [[nodiscard]] std::optional<double> cell_end(double direction) const;
  void enter_cell(double direction);
  [[nodiscard]] dynamics::KnownIntervals known_intervals() const;
  void pass_intervals(const dynamics::Clock& clock, std::size_t count);

  /// The same random numbers with continued counts, for the means and standard deviations of others.
  [[nodiscard]] SceneCoefficients under(const SceneCoefficients& others) const;

  /// The first index of each source that no draw up to now has used, and none before it will be used.
  [[nodiscard]] random::FirstUnused first_unused() const;
  /// From now on the draws are these, which differ from the former ones only from first_unused() on. The values in
  /// force stay.
  void continue_with(const random::BranchedDraws& draws);
  /// At the beginning of a period: its amplitude, if it has been drawn already, is drawn again.
  void draw_amplitude_again(const dynamics::Clock& clock);

  /// Adds the number of draws made so far, and of those clamped when used.
  void add_to(OperationCounts& operations) const;
  [[nodiscard]] const Clamps& clamps() const { return clamps_; }

 private:
  [[nodiscard]] bool is_alike_at_both_edges() const {
    return laws_.right_edge.share == 1.0 && laws_.right_edge.more == 0.0;
  }

  /// Counts of events, from which the indices of draws are computed.
  struct Count {
    std::uint64_t chatters = 0;
    std::uint64_t since = 0;  ///< impacts or stops since the end of the last chatter
  };

  void move_to_interval(const dynamics::Clock& clock, std::int64_t interval);
  [[nodiscard]] dynamics::Instant boundary_after_end(const dynamics::Clock& clock, std::int64_t count) const;
  [[nodiscard]] dynamics::Instant boundary(const dynamics::Clock& clock, std::int64_t interval) const;
  [[nodiscard]] std::int64_t grid_index(const dynamics::Clock& clock) const;
  [[nodiscard]] std::int64_t searched_grid_index(const dynamics::Clock& clock) const;
  void use_kinetic_friction(double wanted);
  [[nodiscard]] double with_share_of_static(double own) const;
  [[nodiscard]] double held_kinetic_friction(double wanted);
  void turn_normals_into_friction();
  void draw_static_friction();
  void draw_friction_of_cell();
  void look_up_static_friction(std::uint64_t index);
  [[nodiscard]] double drawn_kinetic_friction(const dynamics::Clock& clock);
  [[nodiscard]] std::uint64_t first_unused(random::Source source) const;

  CoefficientLaws laws_;
  bool has_friction_;
  int refreshes_per_period_;
  bool redraws_amplitude_;  ///< at each excitation period
  random::BranchedDraws draws_;

  double static_friction_;
  double static_normal_ = 0.0;          ///< the normal number from which it follows
  bool follows_former_static_ = false;  ///< the kinetic friction that was drawn is correlated with a former static one
  std::optional<FrictionCells> cells_;  ///< if friction belongs to the place
  Count stops_;
  Count static_count_;  ///< of stops, at the time when the static friction in force was drawn
  Count impacts_;
  /// Kinetic friction is drawn for this many successive intervals at once.
  static constexpr std::int64_t intervals_at_once = dynamics::most_known_intervals;
  static constexpr std::int64_t none_drawn = -intervals_at_once;

  std::int64_t interval_ = -1;  ///< of the kinetic friction below
  dynamics::Instant begin_;
  dynamics::Instant end_;
  std::int64_t end_number_ = 0;                    ///< number of the boundary at its end, within its period
  std::int64_t drawn_from_ = none_drawn;           ///< interval of the first of `drawn_`
  std::array<double, intervals_at_once> drawn_{};  ///< kinetic friction before it is limited to 0 ... static friction
  double kinetic_friction_ = 0.0;
  /// The clamp of this interval (for a constant mean: of this static draw) has been counted.
  bool held_at_static_ = false;
  std::int64_t amplitude_period_ = -1;
  double amplitude_ = 0.0;

  Clamps clamps_;
  std::uint64_t static_draws_ = 0;
  std::uint64_t kinetic_draws_ = 0;
  std::uint64_t restitution_draws_ = 0;
  std::uint64_t amplitude_draws_ = 0;
};

}  // namespace rocking
