#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>

#include "rocking/base/error.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/random/source.hpp"
#include "rocking/scene/experiment.hpp"

/// What is to be known of a law of the restitution. A law is an alternative of Restitution (experiment.hpp); restitution.cpp
/// has each of these functions for each law, so that a forgotten one does not compile.
namespace rocking {

/// Bounds of the restitution e that may be drawn.
inline constexpr double least_restitution = -0.999;
inline constexpr double largest_restitution = 1.0;
/// Largest ratio of the rates at a wall.
inline constexpr double largest_wall_ratio = 0.999;

/// Mean of e for a block of this shape where the edge of a side with the sign of `landing` lands.
[[nodiscard]] double mean_restitution(const Restitution& law, const dynamics::Geometry& block, double landing = 1.0);

/// Mean of the number as it is given: of e, or of the rate ratio, over both edges.
[[nodiscard]] double mean_as_given(const Restitution& law, const dynamics::Geometry& block);

/// Change of the number as it is given for a change of e by 1 at the left edge.
[[nodiscard]] double unit_of(const Restitution& law, const dynamics::Geometry& block);

/// Mean that a lognormal scatter along the way may have; absent: there is none.
[[nodiscard]] std::optional<double> lognormal_mean(const Restitution& law);

/// A number of a scene that may have a law, which each realisation draws once.
struct QuantityPlace : NamedPlace {
  random::Source source = {};  ///< of the draw
};

struct RestitutionNumber : QuantityPlace {
  const Quantity* value = nullptr;  ///< null: there is none
};
/// The only one or that of the left edge, and that of the right edge.
using RestitutionNumbers = std::array<RestitutionNumber, 2>;
[[nodiscard]] RestitutionNumbers numbers_of(const Restitution& law);

/// Largest e of a scene: 1. A measured ratio of the tilt rates may be less than such an impact leaves. It has no bound if
/// the block cannot slide, since an impulse with e above 1 could give energy to a block that slides, and if the ratio does
/// not scatter along the way.
[[nodiscard]] double largest_restitution_of(const Scene& scene);

/// Bounds of the number with this source, as it is given, for a block of this shape.
[[nodiscard]] Reach bounds_of(const Scene& scene, random::Source source, const dynamics::Geometry& block);

/// Bounds of e as it is drawn again along the way.
[[nodiscard]] Reach reach_along_the_way(const Restitution& law, const dynamics::Geometry& block);

/// Why the blocks of the scene cannot have the number with this place among numbers_of.
[[nodiscard]] std::optional<Refusal> refusal_of(const Scene& scene, std::size_t number);

/// How 1 + e of the right edge follows from that of the left one, where e scatters along the way: share (1 + e) + more.
struct RightEdge {
  double share = 1.0;
  double more = 0.0;
};
[[nodiscard]] RightEdge right_edge_of(const Restitution& law, const dynamics::Geometry& block);

/// Whether impacts on both edges of a block with equal edges are alike.
[[nodiscard]] bool is_alike_at_both_edges(const Restitution& law);

/// The least and the largest of some numbers.
struct NumberRange {
  double least = std::numeric_limits<double>::infinity();
  double largest = -std::numeric_limits<double>::infinity();
  void add(double number);
  /// Both in three digits, `0.18 to 0.25`; once if they are equal.
  [[nodiscard]] std::string text() const;
};

/// What impacts leave of the tilt rate, over the scenes of an experiment: dynamics::inelastic_rate_ratio beside Housner's
/// ratio, that of e = 0.
class RateRatios {
 public:
  /// Those of the mean block.
  void add(const Scene& scene);

  /// A sentence with e, the ratio and Housner's: `e = 0.93: 0.868 of the tilt rate survives an impact ...`, of both edges
  /// where they differ; with doubt() behind it.
  [[nodiscard]] std::string text() const;

  /// That a number given as e is likely a measured ratio of the rates: it lies among these, from 0.67 of Housner's ratio to
  /// 1, or what it leaves is below 0.85 of Housner's ratio. Absent: it is not.
  [[nodiscard]] std::optional<std::string> doubt() const;

 private:
  struct OfEdge {
    NumberRange restitution;
    NumberRange ratio;
    NumberRange housner;
  };
  std::array<OfEdge, 2> edges_;  ///< where the left edge lands, and the right one
  NumberRange at_wall_;          ///< of blocks at a wall, which are in none of the others
  NumberRange share_;        ///< of Housner's ratio that e leave which are given as numbers, of blocks that go on over
                             ///< their other edge
  NumberRange like_ratios_;  ///< those of these e that lie among measured ratios
};

}  // namespace rocking
