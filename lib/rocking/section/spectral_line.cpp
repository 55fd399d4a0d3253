#include "rocking/section/spectral_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "rocking/base/elementary.hpp"
#include "rocking/section/four.hpp"
#include "rocking/section/line_bounds.hpp"

namespace rocking::section {
namespace {

/// Real and imaginary parts of the Fourier sum of the points at a frequency.
struct Amplitude {
  PlanePoint real;
  PlanePoint imaginary;

  void add_to(Covariance& sum) const {
    sum.add(real);
    sum.add(imaginary);
  }
};

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
  const auto count = static_cast<int>(neighbourhood.count);
  std::array<double, most_neighbours + 1> frequencies{};
  std::ranges::copy(neighbourhood.frequencies, frequencies.begin());
  frequencies[neighbourhood.count] = frequency;
  const Amplitudes amplitudes = amplitudes_at(std::span(frequencies).first(neighbourhood.count + 1), points);
  const Amplitude& own = amplitudes[neighbourhood.count];

  const double floor = resolution * resolution * static_cast<double>(length) * count;
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

std::optional<Line> strongest_line(std::span<const PlanePoint> deviations, int n, double resolution,
                                   double needed_from) {
  const std::array<ChanceBounds, line_count> bounds = chance_bounds(deviations, n, resolution);
  const auto lines = tested_lines();
  std::array<std::size_t, line_count> tested{};
  std::size_t count = 0;
  double least_most = std::numeric_limits<double>::infinity();  // the least chance is at most this
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    if (!is_tested(lines[i], n)) continue;
    tested[count++] = i;
    least_most = std::min(least_most, bounds[i].most);
  }
  const auto all = std::span(tested).first(count);
  const auto may_be_least = [&](std::size_t i) { return bounds[i].least <= least_most; };
  if (least_most < needed_from && std::ranges::count_if(all, may_be_least) == 1) {
    return Line{lines[*std::ranges::find_if(all, may_be_least)], least_most};
  }
  std::optional<Line> strongest;
  for (const std::size_t i : all) {
    if (!may_be_least(i) || (strongest && bounds[i].least >= strongest->chance)) continue;
    const double chance = line_chance(lines[i], deviations, n, resolution);
    // Rounding makes the chance NaN where both coordinates are proportional. Such a line is the strongest if it is the
    // first, and is passed over if it is not.
    const bool is_stronger = strongest ? chance < strongest->chance : i == all.front() || !std::isnan(chance);
    if (is_stronger) strongest = Line{lines[i], chance};
  }
  return strongest;
}

}  // namespace rocking::section
