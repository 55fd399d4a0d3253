#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "rocking/base/number_rule.hpp"
#include "rocking/dynamics/block.hpp"
#include "rocking/scene/experiment.hpp"

/// What is to be known of a law of the restitution. A law is an alternative of Restitution (experiment.hpp); restitution.cpp
/// has each of these functions for each law, so that a forgotten one does not compile.
namespace rocking {

/// Bounds of the restitution e that may be drawn.
inline constexpr double least_restitution = -0.999;
inline constexpr double largest_restitution = 1.0;

/// Mean of e for a block of this shape.
[[nodiscard]] double mean_restitution(const Restitution& law, const dynamics::Geometry& block);

/// Mean of the number as it is given: of e, or of the rate ratio.
[[nodiscard]] double mean_as_given(const Restitution& law, const dynamics::Geometry& block);

/// Change of the number as it is given for a change of e by 1.
[[nodiscard]] double unit_of(const Restitution& law, const dynamics::Geometry& block);

/// Mean that a lognormal scatter along the way may have; absent: there is none.
[[nodiscard]] std::optional<double> lognormal_mean(const Restitution& law);

/// The number that a realisation may draw once.
struct RestitutionNumber {
  std::string_view name;   ///< in words
  std::string_view place;  ///< JSON pointer into an experiment file
  const Quantity* value;   ///< null: there is none
};
[[nodiscard]] RestitutionNumber number_of(const Restitution& law);

/// Bounds of that number, as it is given, for a block of this shape.
[[nodiscard]] Reach bounds_of(const Restitution& law, const dynamics::Geometry& block);

/// Why blocks of these shapes cannot have it.
[[nodiscard]] std::optional<Refusal> refusal_of(const Restitution& law, const ShapeRange& shapes);

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
  /// `restitution`: e of the mean block.
  void add(const dynamics::Geometry& block, double restitution);

  /// A sentence with e, the ratio and Housner's: `e = 0.93: 0.868 of the tilt rate survives an impact ...`. A second one
  /// where a ratio is below 0.85 of Housner's, since e may then be a measured ratio of the rates.
  [[nodiscard]] std::string text() const;

 private:
  NumberRange restitution_;
  NumberRange ratio_;
  NumberRange housner_;
  NumberRange share_;  ///< of Housner's ratio, of blocks that go on over their other edge
};

}  // namespace rocking
