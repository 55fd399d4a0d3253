#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "rocking/section/classification.hpp"
#include "rocking/section/clouds.hpp"
#include "rocking/section/four.hpp"
#include "rocking/section/order_statistics.hpp"

namespace rocking::section {
namespace {

// Median of the squared distance from the centre, in units of the scatter, for a normal law in the plane: 2 ln 2.
constexpr double median_of_squares = 2.0 * std::numbers::ln2;

/// Smallest variance of `a` in units of that of `b` over all directions: the smaller root of det(A - z B) = 0.
double least_ratio(const Covariance& a, const Covariance& b) {
  const double half_trace = 0.5 * (a.xx * b.yy - 2.0 * a.xy * b.xy + a.yy * b.xx) / b.determinant();
  const double product = a.determinant() / b.determinant();
  return half_trace - std::sqrt(std::max(half_trace * half_trace - product, 0.0));
}

/// Differences of deviations `lag` apart.
std::vector<PlanePoint> steps_of(std::span<const PlanePoint> deviations, std::size_t lag) {
  std::vector<PlanePoint> steps;
  steps.reserve(deviations.size() - lag);
  for (std::size_t k = lag; k < deviations.size(); ++k) steps.push_back(deviations[k] - deviations[k - lag]);
  return steps;
}

/// Largest correlation of deviations whose differences are `steps`. `memory` has room for two numbers per step.
double memory_of(std::span<const PlanePoint> steps, const Covariance& scatter, double resolution,
                 std::span<double> memory) {
  const double unknown = 2.0 * resolution * resolution;  // resolution of the difference of two points
  double limit = 2.0 * expected_limit;
  Covariance step = trimmed_covariance(steps, scatter, memory, limit);
  step.xx += unknown;
  step.yy += unknown;
  const double least = least_ratio(step, scatter);
  const auto squares = memory.first(steps.size());  // trimmed_covariance leaves them here
  const double median = median_of(squares, memory.subspan(steps.size()));
  return std::max({0.0, 1.0 - 0.5 * least, 1.0 - 0.5 * median / median_of_squares});  // not NaN if one of them is
}

/// What is_memory_surely_below needs of the steps: numbers of squared distances, and sums.
struct NearSteps {
  Covariance sum;       ///< over squares below 0.999 `near`
  double within = 0.0;  ///< number of squares that are at most `near`
  double low = 0.0;     ///< number of squares that are at most `low_square`
  double total = 0.0;   ///< sum of all squares
};

/// Differences of deviations, by coordinate.
struct Steps {
  std::vector<double> x;  ///< filled up with 0 to a multiple of four
  std::vector<double> y;
  std::size_t count = 0;

  void set(std::span<const PlanePoint> deviations, std::size_t lag) {
    count = deviations.size() - lag;
    x.assign((count + four - 1) / four * four, 0.0);
    y.assign(x.size(), 0.0);
    for (std::size_t k = 0; k < count; ++k) {
      x[k] = deviations[k + lag].x - deviations[k].x;
      y[k] = deviations[k + lag].y - deviations[k].y;
    }
  }

  [[nodiscard]] NearSteps look_at(const Covariance& scatter, double near, double low_square) const {
    const double scale = 1.0 / scatter.determinant();
    Four xx{};
    Four xy{};
    Four yy{};
    Four within{};
    Four low{};
    Four total{};
    for (std::size_t k = 0; k < x.size(); k += four) {
      const Four dx = four_from(x.data() + k);
      const Four dy = four_from(y.data() + k);
      const Four square =
          dx * dx * (scale * scatter.yy) - dx * dy * (2.0 * scale * scatter.xy) + dy * dy * (scale * scatter.xx);
      const auto is_summed = square <= 0.999 * near * all_ones;
      xx += is_summed ? dx * dx : Four{};
      xy += is_summed ? dx * dy : Four{};
      yy += is_summed ? dy * dy : Four{};
      within += square <= near * all_ones ? all_ones : Four{};
      low += square <= low_square * all_ones ? all_ones : Four{};
      total += square;
    }
    const auto filled = static_cast<double>(x.size() - count);
    return {{sum_of(xx), sum_of(xy), sum_of(yy)}, sum_of(within) - filled, sum_of(low) - filled, sum_of(total)};
  }
};

/// Whether a bound that takes a fraction of the time of memory_of shows that it does not exceed `limit`.
///
/// If no more than `last_kept` squared distances are at most `near`, the trimmed covariance keeps all of these. Its
/// least variance is then at least that of their sum, divided by the number of all. The median is at least any value
/// that fewer than half of the squares are below. Sums go over squares below 0.999 `near`, and limits are exceeded by 1
/// %, because both computations round: the conditions on the scatter and on the mean square make that less than 1e-6.
bool is_memory_surely_below(double limit, const Steps& steps, const Covariance& scatter) {
  const double least_variance = 1.01 * 2.0 * (1.0 - limit);
  if (!(least_variance > 1e-3) || !(scatter.determinant() > 1e-4 * scatter.xx * scatter.yy)) return false;
  const auto count = static_cast<double>(steps.count);
  for (const double near : {4.0, 1.0}) {
    const NearSteps found = steps.look_at(scatter, near, least_variance * median_of_squares);
    if (!(found.total < 1e6 * count) || !(2.0 * found.low < count - 2.0)) return false;
    if (found.within > static_cast<double>(last_kept(steps.count))) continue;
    return least_ratio(found.sum.scaled(trimming_correction / count), scatter) > least_variance;
  }
  return false;
}

}  // namespace

double longest_memory(const Clouds& clouds, double resolution) {
  std::vector<double> memory(2 * clouds.deviations.size());
  double longest = 0.0;
  for (std::size_t lag = 1; lag <= static_cast<std::size_t>(longest_period); ++lag) {
    longest = std::max(longest, memory_of(steps_of(clouds.deviations, lag), clouds.scatter, resolution, memory));
  }
  return longest;
}

bool has_longer_memory(const Clouds& clouds, double resolution, double limit) {
  Steps steps;
  std::vector<double> memory(2 * clouds.deviations.size());
  for (std::size_t lag = 1; lag <= static_cast<std::size_t>(longest_period); ++lag) {
    steps.set(clouds.deviations, lag);
    if (is_memory_surely_below(limit, steps, clouds.scatter)) continue;
    if (memory_of(steps_of(clouds.deviations, lag), clouds.scatter, resolution, memory) > limit) return true;
  }
  return false;
}

}  // namespace rocking::section
