#include "rocking/section/line_bounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "rocking/base/elementary.hpp"
#include "rocking/section/four.hpp"
#include "rocking/section/nearby_sums.hpp"

namespace rocking::section {
namespace {

/// Turn by a frequency, and Fourier sums, of four frequencies.
struct TurningSums {
  Four turn_cosine{};
  Four turn_sine{};
  Four cosine{1.0, 1.0, 1.0, 1.0};
  Four sine{};
  Four real_x{};
  Four real_y{};
  Four imaginary_x{};
  Four imaginary_y{};

  explicit TurningSums(std::span<const double> frequencies) {
    for (std::size_t i = 0; i < std::min(four, frequencies.size()); ++i) {
      const auto turn = base::sin_cos(2.0 * std::numbers::pi * frequencies[i]);
      turn_cosine[i] = turn.cosine;
      turn_sine[i] = turn.sine;
    }
  }

  void add(const PlanePoint& p) {
    real_x += p.x * cosine;
    real_y += p.y * cosine;
    imaginary_x += p.x * sine;
    imaginary_y += p.y * sine;
    const Four next = cosine * turn_cosine - sine * turn_sine;
    sine = sine * turn_cosine + cosine * turn_sine;
    cosine = next;
  }

  void copy_to(std::span<Amplitude> amplitudes) const {
    for (std::size_t i = 0; i < four; ++i) amplitudes[i] = {{real_x[i], real_y[i]}, {imaginary_x[i], imaginary_y[i]}};
  }
};

/// Rounded up to two vectors.
using Amplitudes = std::array<Amplitude, (most_neighbours + 1 + 2 * four - 1) / (2 * four) * (2 * four)>;

/// Fourier sums at some frequencies. Two vectors at once fill each other's waiting times.
Amplitudes amplitudes_at(std::span<const double> frequencies, std::span<const PlanePoint> points) {
  Amplitudes all;
  for (std::size_t first = 0; first < frequencies.size(); first += 2 * four) {
    TurningSums one(frequencies.subspan(first));
    TurningSums other(frequencies.subspan(std::min(first + four, frequencies.size())));
    for (const PlanePoint& p : points) {
      one.add(p);
      other.add(p);
    }
    one.copy_to(std::span(all).subspan(first));
    other.copy_to(std::span(all).subspan(first + four));
  }
  return all;
}

/// Whether a line is tested if the means of n classes were removed.
bool is_tested(const LineFrequency& line, int n) { return n % line.denominator != 0; }

}  // namespace

double line_chance(const LineFrequency& line, std::span<const PlanePoint> deviations, int n, double resolution) {
  // Only a whole number of cycles of the line is used, so that lines at other multiples of 1/denominator do not leak
  // into it.
  const std::size_t length = deviations.size() - deviations.size() % static_cast<std::size_t>(line.denominator);
  const auto points = deviations.last(length);
  const double frequency = static_cast<double>(line.numerator) / line.denominator;
  const Neighbourhood neighbourhood = neighbourhood_of(frequency, n, length);
  std::array<double, most_neighbours + 1> frequencies{};
  std::ranges::copy(neighbourhood.frequencies, frequencies.begin());
  frequencies[neighbourhood.count] = frequency;
  const Amplitudes amplitudes = amplitudes_at(std::span(frequencies).first(neighbourhood.count + 1), points);
  const Amplitude& own = amplitudes[neighbourhood.count];

  const double floor = squares_of_resolution(resolution, length, neighbourhood.count);
  Covariance noise;
  for (const Amplitude& amplitude : std::span(amplitudes).first(neighbourhood.count)) amplitude.add_to(noise);
  noise.xx += floor;
  noise.yy += floor;
  Covariance both = noise;
  if (line.denominator == 2) {
    both.add(own.real.scaled(std::numbers::sqrt2 / 2.0));  // all of the power; at other frequencies half
  } else {
    own.add_to(both);
  }
  const double ratio = std::sqrt(noise.determinant() / both.determinant());
  return chance_of_ratio(ratio, neighbourhood.count, line.denominator == 2);
}

double least_chance(const AllChanceBounds& bounds, int n) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    if (is_tested(tested_lines()[i], n)) least = std::min(least, bounds[i].least);
  }
  return least;
}

std::optional<LineFrequency> certain_line(const AllChanceBounds& bounds, int n, double limit) {
  std::size_t strongest = 0;
  for (std::size_t i = 1; i < bounds.size(); ++i) {
    if (bounds[i].most < bounds[strongest].most) strongest = i;
  }
  if (!(bounds[strongest].most < limit)) return std::nullopt;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const bool may_be_stronger = is_tested(tested_lines()[i], n) && bounds[i].least <= bounds[strongest].most;
    if (may_be_stronger && i != strongest) return std::nullopt;
  }
  return tested_lines()[strongest];
}

std::optional<Line> strongest_line(std::span<const PlanePoint> deviations, int n, double resolution,
                                   const AllChanceBounds& bounds) {
  double least_most = std::numeric_limits<double>::infinity();  // the least chance is at most this
  for (const ChanceBounds& b : bounds) least_most = std::min(least_most, b.most);
  std::optional<Line> strongest;
  bool is_first = true;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const LineFrequency& line = tested_lines()[i];
    if (!is_tested(line, n)) continue;
    const bool first = std::exchange(is_first, false);
    if (bounds[i].least > least_most || (strongest && bounds[i].least >= strongest->chance)) continue;
    const bool is_known = bounds[i].least == bounds[i].most;
    const double chance = is_known ? bounds[i].most : line_chance(line, deviations, n, resolution);
    // Rounding makes the chance NaN where both coordinates are proportional. Such a line is the strongest if it is the
    // first, and is passed over if it is not.
    const bool is_stronger = strongest ? chance < strongest->chance : first || !std::isnan(chance);
    if (is_stronger) strongest = Line{line, chance};
  }
  return strongest;
}

}  // namespace rocking::section
