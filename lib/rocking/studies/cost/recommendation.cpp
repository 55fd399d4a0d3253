#include "rocking/studies/cost/cost.hpp"

#include <algorithm>
#include <cmath>

#include "rocking/base/error.hpp"

namespace rocking {
namespace {

double bearable_of(const Yardstick& yardstick) {
  return yardstick.is_everything ? 0.0 : bearable_share * yardstick.half_width.value_or(0.0);
}

bool has_bearable_error(const Departure& departure) { return departure.median_error.value_or(0.0) <= bearable_error; }

/// The coarsest place that passes if all tighter ones pass too; the floor is exempt.
template <class Passes>
std::optional<std::size_t> coarsest(std::span<const ToleranceCost> curve, Passes passes) {
  const std::size_t floor = curve.size() - 2;
  std::optional<std::size_t> found;
  for (std::size_t i = floor + 1; i-- > 0;) {
    if (passes(*curve[i].departure)) {
      found = i;
    } else if (i != floor) {
      break;
    }
  }
  return found;
}

/// The tightest place from `coarsest` on that passes and takes few more steps.
template <class Passes>
std::size_t tightest_cheap(std::span<const ToleranceCost> curve, std::size_t coarsest, Passes passes) {
  const auto steps = [&](std::size_t i) { return static_cast<double>(curve[i].steps); };
  const auto periods = [&](std::size_t i) { return static_cast<double>(curve[i].periods); };
  for (std::size_t i = curve.size() - 2; i > coarsest; --i) {
    const bool is_cheap = steps(i) * periods(coarsest) <= cheap_steps * steps(coarsest) * periods(i);
    if (is_cheap && passes(*curve[i].departure)) return i;
  }
  return coarsest;
}

/// Approximately the smallest n at which the same proportion has an upper end of at most `bearable`.
std::optional<std::uint64_t> sample_for(const stats::Proportion& flips, double bearable, double confidence) {
  const double share = static_cast<double>(flips.successes) / static_cast<double>(flips.trials);
  if (share >= bearable) return std::nullopt;
  const auto is_enough = [&](std::uint64_t n) {
    const double count = std::ceil(share * static_cast<double>(n));
    const stats::Proportion expected{.successes = static_cast<std::uint64_t>(count), .trials = n};
    return stats::clopper_pearson(expected, confidence).high <= bearable;
  };
  constexpr std::uint64_t most = std::uint64_t{1} << 40U;
  std::uint64_t too_few = 0;
  std::uint64_t enough = 1;
  while (enough < most && !is_enough(enough)) {
    too_few = enough;
    enough *= 2;
  }
  while (enough - too_few > 1) {
    const std::uint64_t middle = too_few + (enough - too_few) / 2;
    (is_enough(middle) ? enough : too_few) = middle;
  }
  return enough;
}

}  // namespace

double share_at_most(const Departure& departure, const Yardstick& yardstick) {
  if (yardstick.is_everything) {
    const auto& floor = departure.beside_tolerance_sensitivity;
    const std::uint64_t blamed =
        floor ? std::min(floor->first_only, departure.flips.successes) : departure.flips.successes;
    return static_cast<double>(blamed) / static_cast<double>(departure.flips.trials);
  }
  const double all = departure.flips_interval.high;
  return departure.beyond_floor ? std::min(all, departure.beyond_floor->high) : all;
}

Recommendation recommend(std::span<const ToleranceCost> curve, const Yardstick& yardstick, double confidence) {
  ROCKING_EXPECT(curve.size() >= 3);
  Recommendation found;
  found.bearable = bearable_of(yardstick);
  const auto is_shown = [&](const Departure& departure) {
    if (!yardstick.half_width && !yardstick.is_everything) return false;
    return has_bearable_error(departure) && share_at_most(departure, yardstick) <= found.bearable;
  };
  const std::uint64_t at_floor = curve[curve.size() - 2].departure->flips.successes;
  const auto is_blameless = [&](const Departure& departure) {
    return yardstick.half_width && has_bearable_error(departure) && departure.flips.successes <= at_floor &&
           share_at_most(departure, yardstick) <= *yardstick.half_width;
  };
  const auto choose = [&](const auto& passes, Assurance assurance) {
    found.coarsest = coarsest(curve, passes);
    if (!found.coarsest) return;
    found.assurance = assurance;
    found.place = tightest_cheap(curve, *found.coarsest, passes);
    found.at_most = share_at_most(*curve[*found.place].departure, yardstick);
  };
  choose(is_shown, Assurance::shown);
  if (found.place) return found;
  choose(is_blameless, Assurance::not_told_apart);
  const std::size_t place = found.place.value_or(curve.size() - 2);
  found.sample_needed = sample_for(curve[place].departure->flips, found.bearable, confidence);
  return found;
}

}  // namespace rocking
