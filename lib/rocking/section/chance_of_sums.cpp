#include "rocking/section/chance_of_sums.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "rocking/section/four.hpp"
#include "rocking/section/line_neighbourhood.hpp"

namespace rocking::section {
namespace {

/// Sums of four lines.
struct FourLines {
  struct Matrix {
    Four xx{};
    Four xy{};
    Four yy{};

    [[nodiscard]] Four determinant() const { return xx * yy - xy * xy; }
  };
  Matrix noise;
  Matrix own;
  Four degrees{};
  Four half{};  ///< 1 for frequency 1/2, otherwise 0
  Four error_x{};
  Four error_y{};

  void set(std::size_t place, const LineSums& line) {
    noise.xx[place] = line.noise.xx + line.floor;
    noise.xy[place] = line.noise.xy;
    noise.yy[place] = line.noise.yy + line.floor;
    Covariance power;
    line.own.add_to(power);
    const double share = line.at_half ? 0.5 : 1.0;  // there H has half of the power
    own.xx[place] = share * power.xx;
    own.xy[place] = share * power.xy;
    own.yy[place] = share * power.yy;
    degrees[place] = 2.0 * static_cast<double>(line.neighbours);
    half[place] = line.at_half ? 1.0 : 0.0;
    error_x[place] = line.error_x;
    error_y[place] = line.error_y;
  }

  /// Bound of the relative error of the determinant of m, a sum of squares and products of at most `terms` pairs (a, b)
  /// whose errors da and db are bounded; negative or not finite if the sign of the determinant is not certain.
  ///
  /// abs(sum of (a + da)(b + db) - sum of a b) <= da sqrt(terms bb) + db sqrt(terms aa) + terms da db (Cauchy-Schwarz).
  /// The sums of at most 28 terms and the determinant are rounded as well.
  [[nodiscard]] Four determinant_error(const Matrix& m) const {
    const Four terms = degrees + 2.0 * all_ones;
    const Four root_x = square_root(terms * m.xx);
    const Four root_y = square_root(terms * m.yy);
    const Four rounding = 64.0 * rounding_unit * all_ones;
    const Four in_xx = error_x * (2.0 * root_x + terms * error_x) + rounding * m.xx;
    const Four in_yy = error_y * (2.0 * root_y + terms * error_y) + rounding * m.yy;
    const Four size = square_root(m.xx * m.yy);  // not less than abs(m.xy), but for rounding
    const Four in_xy = error_x * root_y + error_y * root_x + terms * error_x * error_y + rounding * size;
    const Four absolute =
        m.xx * in_yy + m.yy * in_xx + in_xx * in_yy + (2.0 * size + in_xy) * in_xy + 8.0 * rounding_unit * m.xx * m.yy;
    return absolute / m.determinant();
  }
};

/// chance_of_ratio of four lines.
Four chance_of(const Four& ratio, const Four& degrees, const Four& half) {
  Four tail = all_ones;
  for (std::size_t k = 1; k < 2 * most_neighbours; ++k) {
    const Four place = static_cast<double>(k) * all_ones;
    tail *= place < degrees ? ratio : all_ones;
  }
  const Four factor = degrees - (degrees - all_ones) * ratio;
  return tail * (half * all_ones + (all_ones - half) * factor);
}

/// Bounds of the chances of up to four lines.
///
/// The ratio L has half of the relative error of the determinants, r together. L^(2M-1) has (2M-1) r/2, the factor of
/// line_bounds.hpp, which is at least 1, the same. Three times 2M r also covers terms of second order, as 2M r < 0.1.
void set_bounds_of_four(const FourLines& lines, std::span<ChanceBounds> bounds) {
  FourLines::Matrix both = lines.noise;
  both.xx += lines.own.xx;
  both.xy += lines.own.xy;
  both.yy += lines.own.yy;
  const Four in_noise = lines.determinant_error(lines.noise);
  const Four in_both = lines.determinant_error(both);
  const Four ratio = square_root(lines.noise.determinant() / both.determinant());
  const Four chance = chance_of(ratio, lines.degrees, lines.half);
  const double underflow = 1e-290;  // larger than what a product loses near the smallest number
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const double error = in_noise[i] + in_both[i];
    if (!(in_noise[i] >= 0.0 && in_both[i] >= 0.0 && error * lines.degrees[i] < 0.1)) continue;
    const double share = lines.degrees[i] * (3.0 * error + 16.0 * rounding_unit);
    bounds[i] = {chance[i] * (1.0 - share) - underflow, chance[i] * (1.0 + share) + underflow};
  }
}

/// What spectral_line.cpp may have rounded a number to.
struct Range {
  double low = 0.0;
  double high = 0.0;

  [[nodiscard]] bool is_one_number() const { return low == high; }
  friend Range operator+(const Range& a, const Range& b) { return {a.low + b.low, a.high + b.high}; }
};

/// Of the square of a Fourier sum, times a factor.
Range square(double sum, double error, double factor) {
  const double low = std::max(std::abs(sum) - error, 0.0) * factor;
  const double high = (std::abs(sum) + error) * factor;
  return {low * low * (1.0 - 8.0 * rounding_unit), high * high * (1.0 + 8.0 * rounding_unit)};
}

/// One coordinate of a line.
struct Coordinate {
  Range noise;
  Range both;
  double products = 0.0;  ///< its square is at least the sum of squares in `both` without the floor

  Coordinate(const LineSums& line, double squares, double real, double imaginary, double error) {
    const double terms = 2.0 * static_cast<double>(line.neighbours);
    const double in_squares =
        error * (2.0 * std::sqrt(terms * squares) + terms * error) + 64.0 * rounding_unit * squares;
    noise = Range{squares - in_squares, squares + in_squares} + Range{line.floor, line.floor};
    const double factor = line.at_half ? std::numbers::sqrt2 / 2.0 : 1.0;
    const Range imaginary_part = line.at_half ? Range{} : square(imaginary, error, 1.0);
    both = noise + square(real, error, factor) + imaginary_part;
    products = std::sqrt(squares + in_squares) + std::abs(real) + std::abs(imaginary) + 2.0 * error;
  }
};

/// The chance of a line where the floor is so much larger than all sums that these are only a few units in its last
/// place: rounding is then monotonic, and what is not certain does not reach the last place. Without it the chances of
/// all lines would be computed, since their bounds overlap.
std::optional<double> chance_near_floor(const LineSums& line) {
  if (!(line.noise.xx + line.noise.yy < 1e-8 * line.floor)) return std::nullopt;
  const Coordinate x(line, line.noise.xx, line.own.real.x, line.own.imaginary.x, line.error_x);
  const Coordinate y(line, line.noise.yy, line.own.real.y, line.own.imaginary.y, line.error_y);
  const bool is_certain =
      x.noise.is_one_number() && x.both.is_one_number() && y.noise.is_one_number() && y.both.is_one_number();
  const double products = 1.01 * x.products * y.products;
  if (!is_certain || !(products < 1e-9 * line.floor)) return std::nullopt;  // its square is lost in the determinants
  const double ratio = std::sqrt((x.noise.low * y.noise.low) / (x.both.low * y.both.low));
  return chance_of_ratio(ratio, line.neighbours, line.at_half);
}

}  // namespace

void set_bounds(std::span<const LineSums> lines, std::span<ChanceBounds> bounds) {
  FourLines some;
  std::array<std::size_t, four> places{};
  std::size_t count = 0;
  const auto finish = [&] {
    std::array<ChanceBounds, four> found;
    set_bounds_of_four(some, std::span(found).first(count));
    for (std::size_t k = 0; k < count; ++k) bounds[places[k]] = found[k];
    count = 0;
  };
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (const auto chance = chance_near_floor(lines[i])) {
      bounds[i] = {*chance, *chance};
      continue;
    }
    some.set(count, lines[i]);
    places[count++] = i;
    if (count == four) finish();
  }
  if (count > 0) finish();
}

}  // namespace rocking::section
