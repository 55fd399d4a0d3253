#pragma once

#include <limits>
#include <string>

#include "rocking/dynamics/block.hpp"

namespace rocking {

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
