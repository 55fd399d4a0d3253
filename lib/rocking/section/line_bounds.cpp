#include "rocking/section/line_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "rocking/section/classification.hpp"
#include "rocking/section/nearby_sums.hpp"

namespace rocking::section {
namespace {

constexpr auto longest = static_cast<std::size_t>(longest_period);
constexpr std::size_t fewest_points = 4 * longest;                     // the bound of the errors needs L >= 40
constexpr double unit = 0.5 * std::numeric_limits<double>::epsilon();  // relative error of one rounding

/// Bound of the difference of a Fourier sum of L points here and in spectral_line.cpp, in units of the sum of the
/// absolute values of the points, divided by L.
///
/// Both multiply turns by each other. In roundings, a product of two turns adds 2.3 to the sum of their errors, and sin
/// and cos have 3.
/// spectral_line.cpp: a turn by one point has 23 (its frequency 1.75, times 2 pi; 2 pi and the product with it 6.3; sin
/// and cos; product), the turn of the last point 23 L; products and sums add L + 1. Together fewer than 25 L.
/// nearby_sums.cpp: a turn by s <= 15 steps has at most 87 with the product, made from turns by 2 and 4 steps. It is
/// multiplied L/Q times from row to row and Q times from point to point; cos and sin of 2 pi j b/Q have 5.8 Q; products
/// and sums add L/Q + Q + 6. For Q = 2 ... 12 and L >= 40 these are fewer than 50 L.
/// Both together are below 75 L; the bound leaves room for terms of second order.
constexpr double error_per_point = 128.0 * unit;

/// Sums of squares and products of Fourier sums.
struct Powers {
  Four xx{};
  Four xy{};
  Four yy{};

  /// Of those whose weight is 1, not 0.
  void add(const FourSums& sums, const Four& weight) {
    xx += weight * (sums.real_x * sums.real_x + sums.imaginary_x * sums.imaginary_x);
    xy += weight * (sums.real_x * sums.real_y + sums.imaginary_x * sums.imaginary_y);
    yy += weight * (sums.real_y * sums.real_y + sums.imaginary_y * sums.imaginary_y);
  }
  [[nodiscard]] Covariance sum() const {
    return {xx[0] + xx[1] + xx[2] + xx[3], xy[0] + xy[1] + xy[2] + xy[3], yy[0] + yy[1] + yy[2] + yy[3]};
  }
};

/// Which neighbours a line has: 1 or 0 by step.
struct Weights {
  std::array<Four, NearbySums::most_vectors> above{};
  std::array<Four, NearbySums::most_vectors> below{};

  explicit Weights(const Neighbourhood& neighbourhood) {
    for (std::size_t i = 0; i < neighbourhood.count; ++i) {
      const int step = neighbourhood.steps[i];
      const auto size = static_cast<std::size_t>(step < 0 ? -step : step);
      (step < 0 ? below : above)[size / four][size % four] = 1.0;
    }
  }
};

/// Bounds of the errors of Fourier sums of some or all points.
struct SumErrors {
  double x = 0.0;
  double y = 0.0;

  explicit SumErrors(std::span<const PlanePoint> points) {
    for (const PlanePoint& p : points) {
      x += std::abs(p.x);
      y += std::abs(p.y);
    }
    x *= error_per_point * static_cast<double>(points.size());
    y *= error_per_point * static_cast<double>(points.size());
  }
};

/// Bound of the relative error of the determinant of m, a sum of squares and products of at most `terms` pairs (a, b)
/// whose errors da and db are bounded; infinite if the sign of the determinant is not certain.
///
/// abs(sum of (a + da)(b + db) - sum of a b) <= da sqrt(terms bb) + db sqrt(terms aa) + terms da db (Cauchy-Schwarz).
/// The sums of at most 28 terms and the determinant are rounded as well.
double determinant_error(const Covariance& m, double terms, const SumErrors& errors) {
  const double root_x = std::sqrt(terms * m.xx);
  const double root_y = std::sqrt(terms * m.yy);
  const double rounding = 64.0 * unit;
  const double in_xx = errors.x * (2.0 * root_x + terms * errors.x) + rounding * m.xx;
  const double in_yy = errors.y * (2.0 * root_y + terms * errors.y) + rounding * m.yy;
  const double in_xy =
      errors.x * root_y + errors.y * root_x + terms * errors.x * errors.y + rounding * std::sqrt(m.xx * m.yy);
  const double absolute =
      m.xx * in_yy + m.yy * in_xx + in_xx * in_yy + (2.0 * std::abs(m.xy) + in_xy) * in_xy + 8.0 * unit * m.xx * m.yy;
  return m.determinant() > 0.0 ? absolute / m.determinant() : std::numeric_limits<double>::infinity();
}

/// Bounds of the chance of a line with sums of squares and products `line`, whose neighbours have `noise`.
///
/// The ratio L has half of the relative error of the determinants, r together. L^(2M-1) has (2M-1) r/2, the factor of
/// spectral_line.hpp, which is at least 1, the same. Three times 2M r also covers terms of second order, as 2M r < 0.1.
ChanceBounds bounds_from(const Covariance& noise, const Covariance& line, const Neighbourhood& neighbourhood,
                         bool at_half, const SumErrors& errors) {
  const int degrees = 2 * static_cast<int>(neighbourhood.count);
  const double terms = degrees + 2;
  Covariance both = noise;
  both.add(line);
  const double error = determinant_error(noise, terms, errors) + determinant_error(both, terms, errors);
  if (!(error * degrees < 0.1)) return {};
  const double ratio = std::sqrt(noise.determinant() / both.determinant());
  const double chance = chance_of_ratio(ratio, neighbourhood.count, at_half);
  const double share = 3.0 * degrees * error + 16.0 * degrees * unit;
  const double underflow = 1e-290;  // larger than what a product loses near the smallest number
  return {chance * (1.0 - share) - underflow, chance * (1.0 + share) + underflow};
}

/// Lines for which the series has the same length, and denominators with the same multiple.
class Group {
 public:
  Group(std::span<const PlanePoint> points, std::size_t modulus)
      : length_(points.size()), modulus_(modulus), sums_(points, modulus) {}

  [[nodiscard]] ChanceBounds bounds_of(const LineFrequency& line, int n, double resolution, const SumErrors& errors) {
    const double frequency = static_cast<double>(line.numerator) / line.denominator;
    const Neighbourhood neighbourhood = neighbourhood_of(frequency, n, length_);
    if (neighbourhood.count == 0) return {};
    const int last = neighbourhood.steps[neighbourhood.count - 1];
    const std::size_t vectors = static_cast<std::size_t>(last < 0 ? -last : last) / four + 1;
    if (vectors > NearbySums::most_vectors) return {};

    const auto j = static_cast<std::size_t>(line.numerator) * modulus_ / static_cast<std::size_t>(line.denominator);
    const Weights weights(neighbourhood);
    const bool at_half = line.denominator == 2;
    Powers powers;
    Covariance own;
    for (std::size_t v = 0; v < vectors; ++v) {
      const auto [above, below] = sums_.at(j, v);
      powers.add(above, weights.above[v]);
      powers.add(below, weights.below[v]);
      if (v > 0) continue;
      own.add(PlanePoint{above.real_x[0], above.real_y[0]});
      if (at_half) {
        own = own.scaled(0.5);  // all of the power; at other frequencies half
      } else {
        own.add(PlanePoint{above.imaginary_x[0], above.imaginary_y[0]});
      }
    }
    Covariance noise = powers.sum();
    const double floor = resolution * resolution * static_cast<double>(length_ * neighbourhood.count);
    noise.xx += floor;
    noise.yy += floor;
    return bounds_from(noise, own, neighbourhood, at_half, errors);
  }

 private:
  std::size_t length_;
  std::size_t modulus_;
  NearbySums sums_;
};

/// The largest multiple of q <= 12 for which the series has the same length as for q.
std::size_t modulus_for(std::size_t q, std::size_t points) {
  std::size_t modulus = longest - longest % q;
  while (points % modulus != points % q) modulus -= q;
  return modulus;
}

}  // namespace

std::array<ChanceBounds, line_count> chance_bounds(std::span<const PlanePoint> deviations, int n, double resolution) {
  std::array<ChanceBounds, line_count> bounds;
  if (deviations.size() < fewest_points) return bounds;
  const SumErrors errors(deviations);
  std::array<std::size_t, longest + 1> moduli{};  // by denominator; 0 if it is not tested
  for (std::size_t q = 2; q <= longest; ++q) {
    if (n % static_cast<int>(q) != 0) moduli[q] = modulus_for(q, deviations.size());
  }
  for (std::size_t modulus = 2; modulus <= longest; ++modulus) {
    if (std::ranges::count(moduli, modulus) == 0) continue;
    Group group(deviations.last(deviations.size() - deviations.size() % modulus), modulus);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      const LineFrequency& line = tested_lines()[i];
      if (moduli[static_cast<std::size_t>(line.denominator)] == modulus) {
        bounds[i] = group.bounds_of(line, n, resolution, errors);
      }
    }
  }
  return bounds;
}

}  // namespace rocking::section
