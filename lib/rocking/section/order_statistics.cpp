#include "rocking/section/order_statistics.hpp"

#include <algorithm>
#include <limits>

#include "rocking/base/error.hpp"
#include "rocking/section/four.hpp"

namespace rocking::section {
namespace {

constexpr std::size_t few = 24;  // values for which comparing all pairs takes less time than counting several times
constexpr int most_counts = 24;  // of one rank; values of very different sizes would need more

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Integers of the size of four numbers: -1 where a comparison is true, otherwise 0.
using FourTruths = decltype(Four{} < Four{});

double least_of(const Four& a) { return std::min(std::min(a[0], a[1]), std::min(a[2], a[3])); }
double most_of(const Four& a) { return std::max(std::max(a[0], a[1]), std::max(a[2], a[3])); }
std::size_t count_of(const FourTruths& a) { return static_cast<std::size_t>(-(a[0] + a[1] + a[2] + a[3])); }

/// use(four values) for all values; the last four are filled up with `other`.
template <class Use>
void for_each_four(std::span<const double> values, double other, Use use) {
  std::size_t k = 0;
  for (; k + four <= values.size(); k += four) use(four_from(values.data() + k));
  if (k == values.size()) return;
  Four rest = other * all_ones;
  for (std::size_t i = 0; k < values.size(); ++i, ++k) rest[i] = values[k];
  use(rest);
}

/// The values of two ranks.
struct Pair {
  double lower = 0.0;
  double upper = 0.0;
};

/// Those of `rank` and of the one before: the largest values that so many values are less than, or fewer.
Pair values_among_few(std::span<const double> values, std::size_t rank) {
  const Four upper_rank = static_cast<double>(rank) * all_ones;
  const Four lower_rank = upper_rank - all_ones;
  Four upper = -infinity * all_ones;
  Four lower = upper;
  for_each_four(values, infinity, [&](const Four& some) {
    FourTruths less{};
    for (const double value : values) less += value * all_ones < some;
    const Four below = -__builtin_convertvector(less, Four);
    upper = below <= upper_rank && some > upper ? some : upper;
    lower = below <= lower_rank && some > lower ? some : lower;
  });
  return {most_of(lower), most_of(upper)};
}

struct Extremes {
  double least = 0.0;
  double most = 0.0;
  bool has_nan = false;
};

Extremes extremes_of(std::span<const double> values) {
  Four least = values.front() * all_ones;
  Four most = least;
  FourTruths nan{};
  for_each_four(values, values.front(), [&](const Four& some) {
    least = some < least ? some : least;
    most = some > most ? some : most;
    nan |= some != some;
  });
  return {least_of(least), most_of(most), count_of(nan) > 0};
}

/// The values beside a pivot.
struct Cut {
  std::size_t below = 0;  ///< number of values less than the pivot
  double last_below = 0.0;
  double first_from = 0.0;  ///< the least value that is not less
};

Cut cut_at(double pivot, std::span<const double> values) {
  const Four at = pivot * all_ones;
  FourTruths below{};
  Four last = -infinity * all_ones;
  Four first = infinity * all_ones;
  for_each_four(values, infinity, [&](const Four& some) {
    const auto is_below = some < at;
    below += is_below;
    const Four lower = is_below ? some : last;
    const Four upper = is_below ? first : some;
    last = lower > last ? lower : last;
    first = upper < first ? upper : first;
  });
  return {count_of(below), most_of(last), least_of(first)};
}

/// After sorting, the value of the rank is in [first, end); these values are from `low` to `high`.
struct Bracket {
  std::size_t first = 0;
  std::size_t end = 0;
  double low = 0.0;
  double high = 0.0;
  double stride = 1.0;  ///< less where the same end was moved before: it is then far from the rank
  bool was_lowered = false;

  void narrow(const Cut& cut, std::size_t rank) {
    const bool lowered = rank < cut.below;
    stride = lowered == was_lowered ? 0.5 * stride : 1.0;
    was_lowered = lowered;
    (lowered ? end : first) = cut.below;
    (lowered ? high : low) = lowered ? cut.last_below : cut.first_from;
  }
  [[nodiscard]] double pivot_for(std::size_t rank) const {
    const double share = (static_cast<double>(rank - first) + 0.5) / static_cast<double>(end - first);
    return was_lowered ? low + stride * share * (high - low) : high - stride * (1.0 - share) * (high - low);
  }
};

/// Makes the order that std::nth_element makes of these values; it matters where comparisons with NaN are involved.
double rank_as_library(std::span<const double> values, std::size_t rank, Scratch scratch) {
  std::ranges::copy(values, scratch.begin());
  const auto used = scratch.first(values.size());
  const auto place = used.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(used.begin(), place, used.end());
  return *place;
}

/// How a value is looked for.
struct Search {
  Scratch scratch;
  double guess;
};

/// value_of_rank of values that are no NaN.
double value_within(const Extremes& extremes, std::span<const double> values, std::size_t rank, Search search) {
  Bracket bracket{.end = values.size(), .low = extremes.least, .high = extremes.most};
  double pivot = search.guess == search.guess ? search.guess : bracket.pivot_for(rank);
  for (int counts = 0; bracket.first < rank && rank + 1 < bracket.end && bracket.low < bracket.high; ++counts) {
    if (counts == most_counts) return rank_as_library(values, rank, search.scratch);
    if (!(bracket.low < pivot && pivot <= bracket.high)) pivot = bracket.high;
    bracket.narrow(cut_at(pivot, values), rank);
    pivot = bracket.pivot_for(rank);
  }
  return rank == bracket.first ? bracket.low : bracket.high;
}

}  // namespace

double value_of_rank(std::span<const double> values, std::size_t rank, Scratch scratch, double guess) {
  ROCKING_EXPECT(rank < values.size() && scratch.size() >= values.size());
  const Extremes extremes = extremes_of(values);
  if (extremes.has_nan) return rank_as_library(values, rank, scratch);
  if (values.size() <= few) return values_among_few(values, rank).upper;
  return value_within(extremes, values, rank, {scratch, guess});
}

double median_of(std::span<const double> values, Scratch scratch) {
  if (values.empty()) return 0.0;
  const std::size_t half = values.size() / 2;
  const bool is_odd = values.size() % 2 == 1;
  const Extremes extremes = extremes_of(values);
  if (extremes.has_nan) {
    const double upper = rank_as_library(values, half, scratch);
    if (is_odd) return upper;  // otherwise the lower values are before it
    return 0.5 * (upper + *std::max_element(scratch.begin(), scratch.begin() + static_cast<std::ptrdiff_t>(half)));
  }
  if (values.size() <= few) {
    const auto [lower, upper] = values_among_few(values, half);
    return is_odd ? upper : 0.5 * (upper + lower);
  }
  const double upper = value_within(extremes, values, half, {scratch, no_guess});
  if (is_odd) return upper;
  // The next lower value, or the same one if it occurs more than once.
  const Cut cut = cut_at(upper, values);
  return 0.5 * (upper + (cut.below == half ? cut.last_below : upper));
}

}  // namespace rocking::section
