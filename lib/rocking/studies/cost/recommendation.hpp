#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "rocking/studies/cost/curve.hpp"

namespace rocking {

/// Evidence that a tolerance is sufficient.
enum class Assurance : std::uint8_t {
  shown,           ///< so few response modes flip that it does not matter, at the confidence of the intervals
  not_told_apart,  ///< no more flip than at the floor; the sample is too small to show more
  none,            ///< neither holds for any tolerance
};

[[nodiscard]] std::string_view to_string(Assurance assurance);

/// What a share of flipped modes is compared with.
struct Yardstick {
  std::optional<double> half_width;  ///< that the experiment's intervals will have; absent if nothing is random
  bool is_everything = false;        ///< the sample is the entire experiment, so that shares are exact
};

/// Largest share of flips relative to the half-width. As bias it reduces the coverage of a 95 % interval to 94.9 %.
inline constexpr double bearable_share = 0.05;
/// Largest median error: a hundredth of the distance at which two runs count as diverged.
inline constexpr double bearable_error = 1e-4;

/// A tighter tolerance is recommended if it takes at most this many times the steps.
inline constexpr double cheap_steps = 1.1;

struct Recommendation {
  Assurance assurance = Assurance::none;
  std::optional<std::size_t> place;     ///< of the tolerance in the curve; absent with `none`
  std::optional<std::size_t> coarsest;  ///< of the coarsest that suffices; likewise
  double bearable = 0.0;                ///< share of flipped modes that is too small to matter
  double at_most = 0.0;  ///< upper bound of the share caused by the tolerance, at `place`; see share_at_most
  /// Realisations that would show it if the share of flips at the tolerance (with `none` at the floor) stays the same;
  /// absent if it is shown already, or if no number would, because that share is too large.
  std::optional<std::uint64_t> sample_needed;
};

/// Upper bound of the share of response modes that a tolerance changes: of all that flip or, if that is less, of the
/// excess over the flips at the floor. If the sample is the entire experiment, the share itself.
[[nodiscard]] double share_at_most(const Departure& departure, const Yardstick& yardstick);

/// A tolerance is shown to suffice if for it and for every tighter one the median error is at most `bearable_error` and
/// share_at_most is at most `bearable_share` of the half-width (0 if the sample is the entire experiment). If none is
/// shown to suffice, it is sufficient that for it and for every tighter one the median error is at most
/// `bearable_error`, no more modes flip than at the floor, and share_at_most is at most the half-width. Among the
/// coarsest sufficient tolerance and the tighter ones that pass and take at most `cheap_steps` times its steps, the
/// tightest is recommended.
///
/// `curve` is sorted by falling tolerance and has at least three entries; `confidence` is that of its intervals.
[[nodiscard]] Recommendation recommend(std::span<const ToleranceCost> curve, const Yardstick& yardstick,
                                       double confidence);

}  // namespace rocking
