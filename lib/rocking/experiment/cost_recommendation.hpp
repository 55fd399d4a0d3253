#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "rocking/experiment/cost_curve.hpp"

namespace rocking::experiment {

/// How sure it is that a tolerance does not matter.
enum class Assurance : std::uint8_t {
  shown,           ///< too few response modes flip to matter, to the confidence asked for
  not_told_apart,  ///< no more flip than at the two tightest tolerances; that few enough do is not shown
  none,            ///< neither can be said of any tolerance
};

[[nodiscard]] std::string_view to_string(Assurance assurance);

/// What a share of flipped modes is measured by.
struct Yardstick {
  std::optional<double> half_width;  ///< that the experiment's intervals will have; absent: nothing is drawn
  bool is_everything = false;        ///< the sample holds all that there is, and a share is exact
};

/// Of a half-width that flips may take: their bias then leaves a 95 % interval its 94.9 %.
inline constexpr double bearable_share = 0.05;
/// A hundredth of the distance at which two runs are said to have parted.
inline constexpr double bearable_error = 1e-4;

struct Recommendation {
  Assurance assurance = Assurance::none;
  std::optional<std::size_t> place;  ///< of the tolerance in the curve; absent with `none`
  double bearable = 0.0;             ///< share of flipped modes that is too small to matter
  double at_most = 0.0;              ///< upper bound of the share that matters, there; see share_at_most
  /// Realisations, none of which flips, that would show it; absent where it is shown, or cannot be by a sample.
  std::optional<std::uint64_t> sample_needed;
};

/// Upper bound of the share of response modes for which a tolerance is to blame: all that flip or, if that is less, those
/// that flip beyond the floor's. Of a sample that is everything the share itself.
[[nodiscard]] double share_at_most(const Departure& departure, const Yardstick& yardstick);

/// The coarsest tolerance of which it is shown that it does not matter, it and every tighter one: the median error is
/// bearable and share_at_most is at most `bearable_share` of the half-width (of a sample that is everything: 0). Where none
/// is, the coarsest of which nothing speaks against it, it and every tighter one: bearable error, no more flips than at the
/// floor, and share_at_most no larger than the half-width.
///
/// `curve` by falling tolerance, at least three; `confidence` that of its intervals.
[[nodiscard]] Recommendation recommend(std::span<const ToleranceCost> curve, const Yardstick& yardstick,
                                       double confidence);

}  // namespace rocking::experiment
