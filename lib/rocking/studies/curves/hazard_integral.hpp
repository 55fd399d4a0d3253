#pragma once

#include <optional>
#include <vector>

#include "rocking/scene/hazard.hpp"

namespace rocking {

/// A part of a hazard curve on which the rate of exceedance is H(y) = rate_low exp(-exponent (y - low)), y = ln x.
struct HazardPiece {
  double low = 0.0;
  double high = 0.0;  ///< infinite beyond the last point, unless the rate is 0 there
  double rate_low = 0.0;
  double rate_high = 0.0;
  double exponent = 0.0;  ///< >= 0; infinite where the rate falls at one intensity

  [[nodiscard]] double rate_at(double y) const;
};

/// The part of a hazard curve between two intensities; absent `to`: without an end. Nothing lies below its first point.
/// Empty where `from` is not below `to`.
[[nodiscard]] std::vector<HazardPiece> pieces_between(const HazardCurve& hazard, double from,
                                                      std::optional<double> to = std::nullopt);

/// The intensity that is exceeded at this rate [1/year], within the points of a curve; absent: none of them is.
[[nodiscard]] std::optional<double> intensity_at(const HazardCurve& hazard, double rate);

/// The parts of pieces between two values of y = ln x.
[[nodiscard]] std::vector<HazardPiece> pieces_within(const std::vector<HazardPiece>& pieces, double low, double high);

/// ln of the median of a lognormal capacity, and its dispersion, > 0.
struct LognormalCapacity {
  double centre = 0.0;
  double dispersion = 1.0;

  /// P(capacity <= x).
  [[nodiscard]] double probability(double y) const;
};

/// Integral of P |dH| over the pieces, in closed form. With z = (y - centre)/dispersion, P = Phi(z) and integration by
/// parts,
///
///     integral P |dH| = P H at the lower end - P H at the upper end + integral H dP,
///     integral H dP over a piece = H phi(z) M(u) at the lower end - the same at the upper end,
///     u = z + exponent dispersion,   M(u) = (1 - Phi(u))/phi(u) (Mills' ratio).
///
/// With one piece without ends it is H(median) exp(exponent^2 dispersion^2/2) (Cornell 1996).
[[nodiscard]] double rate_of(const LognormalCapacity& capacity, const std::vector<HazardPiece>& pieces);

/// A probability that is known at some intensities, and how it goes on between and beyond them.
struct KnownProbabilities {
  enum class Between : std::uint8_t {
    linear,      ///< in ln x; beyond the ends as at the ends
    last_known,  ///< that of the next lower intensity; 0 below the lowest
    next_known,  ///< that of the next higher intensity; 1 above the highest
  };
  std::vector<double> y;  ///< ln x, rising
  std::vector<double> probabilities;
  Between between = Between::linear;

  [[nodiscard]] double probability(double y_there) const;
};

/// The same integral, exact up to rounding.
[[nodiscard]] double rate_of(const KnownProbabilities& known, const std::vector<HazardPiece>& pieces);

}  // namespace rocking
