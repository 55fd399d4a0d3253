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

/// So many more steps are a price for digits that nobody has to think about.
inline constexpr double cheap_steps = 1.1;

struct Recommendation {
  Assurance assurance = Assurance::none;
  std::optional<std::size_t> place;     ///< of the tolerance in the curve; absent with `none`
  std::optional<std::size_t> coarsest;  ///< of the coarsest that will do; likewise
  double bearable = 0.0;                ///< share of flipped modes that is too small to matter
  double at_most = 0.0;                 ///< upper bound of the share that matters, at `place`; see share_at_most
  /// Realisations that would show it, if the tolerance (or with `none` the floor) keeps its share of flips; absent where it is
  /// shown, and where that share is not bearable, so that none would.
  std::optional<std::uint64_t> sample_needed;
};

/// Upper bound of the share of response modes for which a tolerance is to blame: all that flip or, if that is less, those
/// that flip beyond the floor's. Of a sample that is everything the share itself.
[[nodiscard]] double share_at_most(const Departure& departure, const Yardstick& yardstick);

/// A tolerance will do if that is shown of it and of every tighter one: the median error is bearable, and share_at_most is
/// at most `bearable_share` of the half-width (of a sample that is everything: 0). Where it is shown of none: if nothing
/// speaks against it and against any tighter one: bearable error, no more flips than at the floor, and share_at_most no
/// larger than the half-width. Of the coarsest that will do and those tighter that take at most `cheap_steps` times its
/// steps the tightest is recommended.
///
/// `curve` by falling tolerance, at least three; `confidence` that of its intervals.
[[nodiscard]] Recommendation recommend(std::span<const ToleranceCost> curve, const Yardstick& yardstick,
                                       double confidence);

}  // namespace rocking::experiment
