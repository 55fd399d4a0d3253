#include "rocking/section/line_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>

#include "rocking/base/elementary.hpp"
#include "rocking/section/four.hpp"
#include "rocking/section/line_neighbourhood.hpp"
#include "rocking/section/period.hpp"

namespace rocking::section {
namespace {

constexpr std::size_t most_vectors = 4;  // steps 0 ... 15; lines with farther neighbours have no bounds
constexpr auto longest = static_cast<std::size_t>(longest_period);
constexpr std::size_t fewest_points = 4 * longest;
constexpr double unit = 0.5 * std::numeric_limits<double>::epsilon();  // relative error of one rounding

/// cos and sin of an angle, by lane.
struct Turn {
  Four cosine;
  Four sine;

  [[nodiscard]] Turn followed_by(const Turn& b) const {
    return {cosine * b.cosine - sine * b.sine, sine * b.cosine + cosine * b.sine};
  }
};

constexpr Four all_ones{1.0, 1.0, 1.0, 1.0};

/// Turns by 0, 1, 2 ... times a fraction of a full turn, four at a time, from products of one sine and cosine.
class Turns {
 public:
  explicit Turns(std::size_t length) {
    const auto [sine, cosine] = base::sin_cos(2.0 * std::numbers::pi / static_cast<double>(length));
    const double cosine_2 = cosine * cosine - sine * sine;
    const double sine_2 = 2.0 * sine * cosine;
    const double cosine_4 = cosine_2 * cosine_2 - sine_2 * sine_2;
    const double sine_4 = 2.0 * sine_2 * cosine_2;
    now_ = {Four{1.0, cosine, cosine_2, cosine_2 * cosine - sine_2 * sine},
            Four{0.0, sine, sine_2, sine_2 * cosine + cosine_2 * sine}};
    by_four_ = {cosine_4 * all_ones, sine_4 * all_ones};
  }

  /// The next four.
  [[nodiscard]] Turn next() {
    const Turn now = now_;
    now_ = now.followed_by(by_four_);
    return now;
  }

 private:
  Turn now_;
  Turn by_four_;
};

/// Fourier sums of x and y of the points with the same k mod Q, at four steps.
struct FourSums {
  Four real_x;
  Four imaginary_x;
  Four real_y;
  Four imaginary_y;

  void add(const PlanePoint& p, const Turn& at) {
    real_x += p.x * at.cosine;
    imaginary_x += p.x * at.sine;
    real_y += p.y * at.cosine;
    imaginary_y += p.y * at.sine;
  }

  [[nodiscard]] FourSums turned(const Turn& by) const {
    return {real_x * by.cosine - imaginary_x * by.sine, real_x * by.sine + imaginary_x * by.cosine,
            real_y * by.cosine - imaginary_y * by.sine, real_y * by.sine + imaginary_y * by.cosine};
  }
};

/// FourSums of the points with the same k mod Q, with all turns: sum over a of z[Q a + b] exp(2 pi i s (Q a + b)/L), by
/// vector of steps s and residue b.
using FirstSums = std::array<std::array<FourSums, longest>, most_vectors>;

constexpr std::size_t rows_at_once = 64;

void add_rows(std::span<const PlanePoint> points, std::size_t modulus, std::span<const Turn> turns,
              std::span<FourSums> sums) {
  for (std::size_t b = 0; b < modulus; ++b) {
    FourSums sum = sums[b];
    for (std::size_t a = 0; a < turns.size(); ++a) sum.add(points[a * modulus + b], turns[a]);
    sums[b] = sum;
  }
}

/// `row_turn` is the turn from one row to the next, `point_turn` that from one point to the next.
void sum_vector(std::span<const PlanePoint> points, std::size_t modulus, const Turn& row_turn, const Turn& point_turn,
                std::span<FourSums> sums) {
  std::ranges::fill(sums, FourSums{});
  const std::size_t rows = points.size() / modulus;
  std::array<Turn, rows_at_once> turns;  // written before it is read; setting it to 0 would cost a tenth of the time
  Turn row{all_ones, Four{}};
  for (std::size_t first = 0; first < rows; first += rows_at_once) {
    const std::size_t some = std::min(rows_at_once, rows - first);
    for (std::size_t a = 0; a < some; ++a) {
      turns[a] = row;
      row = row.followed_by(row_turn);
    }
    add_rows(points.subspan(first * modulus), modulus, std::span(turns).first(some), sums);
  }
  Turn point{all_ones, Four{}};
  for (std::size_t b = 0; b < modulus; ++b) {
    sums[b] = sums[b].turned(point);
    point = point.followed_by(point_turn);
  }
}

/// FourSums of squares and products of Fourier sums, by lane.
struct Powers {
  Four xx{};
  Four xy{};
  Four yy{};

  void add(const Four& x, const Four& y, const Four& weight) {
    xx += weight * x * x;
    xy += weight * x * y;
    yy += weight * y * y;
  }
  [[nodiscard]] Covariance sum() const {
    return {xx[0] + xx[1] + xx[2] + xx[3], xy[0] + xy[1] + xy[2] + xy[3], yy[0] + yy[1] + yy[2] + yy[3]};
  }
};

/// Fourier sums at the frequencies j/Q + s/L and j/Q - s/L: products of the first sums with cos and sin of 2 pi j b/Q,
/// summed over b.
struct BothSides {
  FourSums with_cosine{};
  FourSums with_sine{};

  void add(const FourSums& first, double cosine, double sine) {
    with_cosine.real_x += cosine * first.real_x;
    with_cosine.imaginary_x += cosine * first.imaginary_x;
    with_cosine.real_y += cosine * first.real_y;
    with_cosine.imaginary_y += cosine * first.imaginary_y;
    with_sine.real_x += sine * first.real_x;
    with_sine.imaginary_x += sine * first.imaginary_x;
    with_sine.real_y += sine * first.real_y;
    with_sine.imaginary_y += sine * first.imaginary_y;
  }

  [[nodiscard]] FourSums above() const {
    return {with_cosine.real_x - with_sine.imaginary_x, with_cosine.imaginary_x + with_sine.real_x,
            with_cosine.real_y - with_sine.imaginary_y, with_cosine.imaginary_y + with_sine.real_y};
  }
  [[nodiscard]] FourSums below() const {
    return {with_cosine.real_x + with_sine.imaginary_x, with_sine.real_x - with_cosine.imaginary_x,
            with_cosine.real_y + with_sine.imaginary_y, with_sine.real_y - with_cosine.imaginary_y};
  }
};

/// Which neighbours a line has: 1 or 0 by step.
struct Weights {
  std::array<Four, most_vectors> above{};
  std::array<Four, most_vectors> below{};

  explicit Weights(const Neighbourhood& neighbourhood) {
    for (std::size_t i = 0; i < neighbourhood.count; ++i) {
      const int step = neighbourhood.steps[i];
      const auto size = static_cast<std::size_t>(step < 0 ? -step : step);
      (step < 0 ? below : above)[size / four][size % four] = 1.0;
    }
  }
};

/// FourSums of the absolute values of the points: what the errors of the Fourier sums are proportional to.
struct Sizes {
  double x = 0.0;
  double y = 0.0;

  explicit Sizes(std::span<const PlanePoint> points) {
    for (const PlanePoint& p : points) {
      x += std::abs(p.x);
      y += std::abs(p.y);
    }
  }
};

/// What the chance of a line is computed from.
struct Evidence {
  Covariance noise;  ///< sums over the neighbours, with the resolution
  Covariance line;   ///< the same of the line itself; at frequency 1/2 half of its real part
  std::size_t neighbours = 0;
  bool at_half = false;
};

/// Bound of the relative error of the determinant, infinite if its sign is not known, given bounds of the errors of Fourier sums in x and y, of which
/// `terms` squares were added: abs(sum of products of a and b - the same of a + da and b + db) is at most
/// da sqrt(terms bb) + db sqrt(terms aa) + terms da db (Cauchy-Schwarz).
double determinant_error(const Covariance& m, double terms, double error_x, double error_y) {
  const double root_x = std::sqrt(terms * m.xx);
  const double root_y = std::sqrt(terms * m.yy);
  const double rounding = 64.0 * unit;
  const double in_xx = error_x * (2.0 * root_x + terms * error_x) + rounding * m.xx;
  const double in_yy = error_y * (2.0 * root_y + terms * error_y) + rounding * m.yy;
  const double in_xy =
      error_x * root_y + error_y * root_x + terms * error_x * error_y + rounding * std::sqrt(m.xx * m.yy);
  const double absolute =
      m.xx * in_yy + m.yy * in_xx + in_xx * in_yy + (2.0 * std::abs(m.xy) + in_xy) * in_xy + 8.0 * unit * m.xx * m.yy;
  return m.determinant() > 0.0 ? absolute / m.determinant() : std::numeric_limits<double>::infinity();
}

/// The chance of spectral_line.hpp and bounds of its error.
///
/// spectral_line.cpp multiplies a turn by itself: its error grows by at most 18 roundings per point (2.3 of the product
/// of complex numbers, 3 of sin and cos, 6.3 each of the frequency and of 2 pi), and a sum has at most one per point.
/// Here a turn by s steps has at most 8 s roundings, s <= 15, and is multiplied L/Q times from row to row (Q >= 7) and
/// Q <= 12 times from point to point: 17 L and 30 L roundings, and fewer than 5 L from cos and sin of 2 pi j/Q. Together
/// they differ by less than 80 L roundings of the sum of the absolute values; 128 L are allowed for.
ChanceBounds bounds_from(const Evidence& evidence, const Sizes& sizes, std::size_t length) {
  const double error = 128.0 * unit * static_cast<double>(length);
  Covariance both = evidence.noise;
  both.add(evidence.line);
  const int degrees = 2 * static_cast<int>(evidence.neighbours);
  const double terms = degrees + 2;
  const double relative = determinant_error(evidence.noise, terms, error * sizes.x, error * sizes.y) +
                          determinant_error(both, terms, error * sizes.x, error * sizes.y);
  if (!(relative * degrees < 0.1)) return {};
  const double ratio = std::sqrt(evidence.noise.determinant() / both.determinant());
  const double chance = chance_of_ratio(ratio, evidence.neighbours, evidence.at_half);
  // The exponent of the ratio, its factor, and roundings of both.
  const double share = 3.0 * degrees * relative + 16.0 * degrees * unit;
  const double underflow = 1e-290;
  return {chance * (1.0 - share) - underflow, chance * (1.0 + share) + underflow};
}

/// Lines whose first sums are the same.
class Group {
 public:
  Group(std::span<const PlanePoint> points, const Sizes& sizes, std::size_t modulus, double resolution)
      : points_(points),
        sizes_(sizes),
        modulus_(modulus),
        floor_(resolution * resolution),
        row_turns_(points.size() / modulus),
        point_turns_(points.size()) {
    const auto [sine, cosine] = base::sin_cos(2.0 * std::numbers::pi / static_cast<double>(modulus));
    double c = 1.0;
    double s = 0.0;
    for (std::size_t b = 0; b < modulus; ++b) {
      cosines_[b] = c;
      sines_[b] = s;
      const double next = c * cosine - s * sine;
      s = s * cosine + c * sine;
      c = next;
    }
  }

  [[nodiscard]] ChanceBounds bounds_of(const LineFrequency& line, int n) {
    const double frequency = static_cast<double>(line.numerator) / line.denominator;
    const Neighbourhood neighbourhood = neighbourhood_of(frequency, n, points_.size());
    if (neighbourhood.count == 0) return {};
    const int last = neighbourhood.steps[neighbourhood.count - 1];
    const std::size_t vectors = static_cast<std::size_t>(last < 0 ? -last : last) / four + 1;
    if (vectors > most_vectors) return {};
    for (; vectors_ < vectors; ++vectors_) {
      sum_vector(points_, modulus_, row_turns_.next(), point_turns_.next(), sums_[vectors_]);
    }

    const auto j = static_cast<std::size_t>(line.numerator) * modulus_ / static_cast<std::size_t>(line.denominator);
    const Weights weights(neighbourhood);
    Powers noise;
    Evidence evidence{.noise = {}, .line = {}, .neighbours = neighbourhood.count, .at_half = line.denominator == 2};
    for (std::size_t v = 0; v < vectors; ++v) {
      const BothSides sides = at(j, v);
      const FourSums above = sides.above();
      const FourSums below = sides.below();
      noise.add(above.real_x, above.real_y, weights.above[v]);
      noise.add(above.imaginary_x, above.imaginary_y, weights.above[v]);
      noise.add(below.real_x, below.real_y, weights.below[v]);
      noise.add(below.imaginary_x, below.imaginary_y, weights.below[v]);
      if (v > 0) continue;
      evidence.line.add(PlanePoint{above.real_x[0], above.real_y[0]});
      if (evidence.at_half) {
        evidence.line = evidence.line.scaled(0.5);
      } else {
        evidence.line.add(PlanePoint{above.imaginary_x[0], above.imaginary_y[0]});
      }
    }
    evidence.noise = noise.sum();
    const double floor = floor_ * static_cast<double>(points_.size() * neighbourhood.count);
    evidence.noise.xx += floor;
    evidence.noise.yy += floor;
    return bounds_from(evidence, sizes_, points_.size());
  }

 private:
  [[nodiscard]] BothSides at(std::size_t j, std::size_t vector) const {
    BothSides sides;
    for (std::size_t b = 0, k = 0; b < modulus_; ++b) {
      sides.add(sums_[vector][b], cosines_[k], sines_[k]);
      k += j;
      if (k >= modulus_) k -= modulus_;
    }
    return sides;
  }

  std::span<const PlanePoint> points_;
  Sizes sizes_;
  std::size_t modulus_;
  double floor_;
  std::array<double, longest> cosines_{};
  std::array<double, longest> sines_{};
  Turns row_turns_;
  Turns point_turns_;
  FirstSums sums_;
  std::size_t vectors_ = 0;  ///< that are summed
};

/// The largest multiple of q <= 12 for which the series has the same length as for q.
std::size_t modulus_for(std::size_t q, std::size_t points) {
  std::size_t modulus = longest - longest % q;
  while (points % modulus != points % q) modulus -= q;
  return modulus;
}

constexpr std::array<LineFrequency, line_count> lines_by_denominator = [] {
  std::array<LineFrequency, line_count> lines;
  std::size_t count = 0;
  for (int q = 2; q <= longest_period; ++q) {
    for (int j = 1; 2 * j <= q; ++j) {
      if (std::gcd(j, q) == 1) lines[count++] = {j, q};
    }
  }
  return lines;
}();

}  // namespace

std::span<const LineFrequency, line_count> tested_lines() { return lines_by_denominator; }

std::array<ChanceBounds, line_count> chance_bounds(std::span<const PlanePoint> deviations, int n, double resolution) {
  std::array<ChanceBounds, line_count> bounds;
  if (deviations.size() < fewest_points) return bounds;
  const Sizes sizes(deviations);
  std::array<std::size_t, longest + 1> moduli{};  // by denominator; 0 if it is not tested
  for (std::size_t q = 2; q <= longest; ++q) {
    if (n % static_cast<int>(q) != 0) moduli[q] = modulus_for(q, deviations.size());
  }
  for (std::size_t modulus = 2; modulus <= longest; ++modulus) {
    if (std::ranges::count(moduli, modulus) == 0) continue;
    Group group(deviations.last(deviations.size() - deviations.size() % modulus), sizes, modulus, resolution);
    for (std::size_t i = 0; i < bounds.size(); ++i) {
      const LineFrequency& line = lines_by_denominator[i];
      if (moduli[static_cast<std::size_t>(line.denominator)] == modulus) bounds[i] = group.bounds_of(line, n);
    }
  }
  return bounds;
}

}  // namespace rocking::section
