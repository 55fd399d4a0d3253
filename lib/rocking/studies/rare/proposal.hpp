#pragma once

#include <cstddef>
#include <vector>

#include "rocking/random/branched_draws.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking::rare {

/// A vector of independent standard normal numbers: what a realisation draws once.
using Point = std::vector<double>;

struct WeightedPoint {
  Point point;
  double weight = 0.0;
};

/// A law from which such vectors are drawn in place of their own, the standard normal one: with a tenth of the
/// probability that law itself, else a normal law about one of the `centres`, of a width or of 2.5 times that.
class Proposal {
 public:
  /// Their own law.
  explicit Proposal(std::size_t dimensions) : dimensions_(dimensions) {}

  /// About 0 alone.
  [[nodiscard]] static Proposal about_mean(std::size_t dimensions, double width);

  /// Fitted to points that are drawn from the law that is wanted, or weighted by their likelihood ratio to it. The
  /// width in each direction is a multiple of the standard deviation there, under which points that are left out are
  /// most likely, but no less than `least_width`. Their own law if less than two different points have a weight > 0.
  [[nodiscard]] static Proposal fitted_to(std::vector<WeightedPoint> points, std::size_t dimensions,
                                          double least_width = 0.0);

  /// Fitted to all of these points together; the multiple is the one under which the fresh ones, which are drawn
  /// independently of each other, are most likely by the others.
  [[nodiscard]] static Proposal fitted_to(std::vector<WeightedPoint> points, const std::vector<WeightedPoint>& fresh,
                                          std::size_t dimensions);

  [[nodiscard]] std::size_t dimensions() const { return dimensions_; }
  /// Uses the draws of Source::rare_choice.
  [[nodiscard]] Point draw(const random::Draws& draws) const;
  /// Density of the standard normal law over that of this one; at most 10.
  [[nodiscard]] double likelihood_ratio(const Point& point) const;

 private:
  /// To all points; the multiple from `points` and `fresh`.
  [[nodiscard]] static Proposal fitted(const std::vector<WeightedPoint>& all, const std::vector<WeightedPoint>& points,
                                       const std::vector<WeightedPoint>& fresh, std::size_t dimensions,
                                       double least_width);

  /// Mean over the centres of the normal density of this multiple of the widths, over the density of the standard
  /// normal law, at a point.
  [[nodiscard]] double density_ratio(const Point& point, double multiple) const;

  std::size_t dimensions_;
  std::vector<Point> centres_;
  Point widths_;
};

/// What of a scene is random.
struct DrawnNumbers {
  std::vector<random::Source> once;  ///< sources of numbers that a realisation draws once
  bool along_the_way = false;
};
[[nodiscard]] DrawnNumbers drawn_numbers(const Scene& scene);

/// The draws of a realisation with these numbers drawn once, each given by a standard normal number: that of a law that
/// follows from a uniform number is its probability.
[[nodiscard]] random::DrawHistory given_draws(const Scene& scene, const std::vector<random::Source>& once,
                                              const Point& point);

}  // namespace rocking::rare
