#include "rocking/section/order_statistics.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "rocking/base/error.hpp"

namespace rocking::section {
namespace {

constexpr std::size_t few = 24;  // values for which comparing all pairs takes less time than another pivot

struct Ranks {
  std::size_t below = 0;    ///< number of values less than one value
  std::size_t at_most = 0;  ///< and of those that are not greater

  [[nodiscard]] bool contain(std::size_t rank) const { return below <= rank && rank < at_most; }
};

Ranks ranks_of(double value, std::span<const double> values) {
  // Integers of the size of the values, so that the comparisons of several values fit one register.
  std::int64_t below = 0;
  std::int64_t at_most = 0;
  for (const double other : values) {
    below += other < value ? 1 : 0;
    at_most += other <= value ? 1 : 0;
  }
  return {static_cast<std::size_t>(below), static_cast<std::size_t>(at_most)};
}

double value_among_few(std::span<const double> values, std::size_t rank) {
  for (const double value : values) {
    if (ranks_of(value, values).contain(rank)) return value;
  }
  return values.front();  // only if the values are not finite
}

/// A value whose rank is probably near `rank`: one of five values, by rank.
double pivot_for(std::span<const double> values, std::size_t rank) {
  std::array<double, 5> sample{};
  const std::size_t step = values.size() / sample.size();
  for (std::size_t i = 0; i < sample.size(); ++i) sample[i] = values[i * step + step / 2];
  return value_among_few(sample, sample.size() * rank / values.size());
}

/// Copies the values for which keep(value), in order; returns their number. `to` may be where the values are.
template <class Keep>
std::size_t copy_where(std::span<const double> values, double* to, Keep keep) {
  std::size_t count = 0;
  for (const double value : values) {
    to[count] = value;
    count += keep(value) ? 1U : 0U;
  }
  return count;
}

bool has_nan(std::span<const double> values) {
  std::int64_t count = 0;
  for (const double value : values) count += value != value ? 1 : 0;
  return count > 0;
}

/// Makes the order that std::nth_element makes of these values; it matters where comparisons with NaN are involved.
double rank_as_library(std::span<const double> values, std::size_t rank, Scratch scratch) {
  std::ranges::copy(values, scratch.begin());
  const auto used = scratch.first(values.size());
  const auto place = used.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(used.begin(), place, used.end());
  return *place;
}

}  // namespace

double value_of_rank(std::span<const double> values, std::size_t rank, Scratch scratch) {
  ROCKING_EXPECT(rank < values.size() && scratch.size() >= values.size());
  if (has_nan(values)) return rank_as_library(values, rank, scratch);
  while (values.size() > few) {
    const double pivot = pivot_for(values, rank);
    const Ranks ranks = ranks_of(pivot, values);
    if (ranks.contain(rank) || ranks.at_most == ranks.below) return pivot;
    std::size_t count = 0;
    if (rank < ranks.below) {
      count = copy_where(values, scratch.data(), [pivot](double value) { return value < pivot; });
    } else {
      count = copy_where(values, scratch.data(), [pivot](double value) { return value > pivot; });
      rank -= ranks.at_most;
    }
    values = scratch.first(count);
  }
  return value_among_few(values, rank);
}

double median_of(std::span<const double> values, Scratch scratch) {
  if (values.empty()) return 0.0;
  const std::size_t half = values.size() / 2;
  const double upper = value_of_rank(values, half, scratch);
  if (values.size() % 2 == 1) return upper;
  if (has_nan(values)) {  // the lower values are where value_of_rank put them
    return 0.5 * (upper + *std::max_element(scratch.begin(), scratch.begin() + static_cast<std::ptrdiff_t>(half)));
  }
  // The next lower value, or the same one if it occurs more than once.
  double lower = -std::numeric_limits<double>::infinity();
  std::int64_t below = 0;
  for (const double value : values) {
    below += value < upper ? 1 : 0;
    lower = std::max(lower, value < upper ? value : lower);
  }
  return 0.5 * (upper + (static_cast<std::size_t>(below) == half ? lower : upper));
}

}  // namespace rocking::section
