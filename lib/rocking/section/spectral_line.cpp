#include "rocking/section/spectral_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <vector>

#include "rocking/base/elementary.hpp"
#include "rocking/section/period.hpp"

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

/// Four numbers in a register, if the machine has such registers; the bits are those of single numbers.
using Four = double __attribute__((vector_size(4 * sizeof(double))));
constexpr std::size_t lanes = 4;

/// Fourier sums at up to `lanes` frequencies at once.
std::array<Amplitude, lanes> amplitudes_at(std::span<const double> frequencies, std::span<const PlanePoint> points) {
  Four turn_cosine{};
  Four turn_sine{};
  for (std::size_t i = 0; i < frequencies.size(); ++i) {
    const auto turn = base::sin_cos(2.0 * std::numbers::pi * frequencies[i]);
    turn_cosine[i] = turn.cosine;
    turn_sine[i] = turn.sine;
  }
  Four cosine{1.0, 1.0, 1.0, 1.0};
  Four sine{};
  Four real_x{};
  Four real_y{};
  Four imaginary_x{};
  Four imaginary_y{};
  for (const PlanePoint& p : points) {
    real_x += p.x * cosine;
    real_y += p.y * cosine;
    imaginary_x += p.x * sine;
    imaginary_y += p.y * sine;
    const Four next = cosine * turn_cosine - sine * turn_sine;
    sine = sine * turn_cosine + cosine * turn_sine;
    cosine = next;
  }
  std::array<Amplitude, lanes> sums;
  for (std::size_t i = 0; i < lanes; ++i) sums[i] = {{real_x[i], real_y[i]}, {imaginary_x[i], imaginary_y[i]}};
  return sums;
}

/// Fourier sums at any number of frequencies.
std::vector<Amplitude> all_amplitudes_at(std::span<const double> frequencies, std::span<const PlanePoint> points) {
  std::vector<Amplitude> all;
  for (std::size_t first = 0; first < frequencies.size(); first += lanes) {
    const auto some = frequencies.subspan(first, std::min(lanes, frequencies.size() - first));
    const auto sums = amplitudes_at(some, points);
    all.insert(all.end(), sums.begin(), sums.begin() + static_cast<std::ptrdiff_t>(some.size()));
  }
  return all;
}

/// Number of frequencies in the neighbourhood: a twentieth of the frequency bins, between 6 and 12.
int neighbours_for(std::size_t points) { return std::clamp(static_cast<int>(points / 20), 6, 12); }

/// Whether removing the class centres removed this frequency: it is within one bin of a multiple of 1/n.
bool is_taken(double frequency, int n, double bin) {
  const double turns = frequency * n;
  return std::abs(turns - std::round(turns)) < 0.75 * bin * n;
}

/// The M nearest frequencies on both sides, inside (0, 1/2), that were not removed.
std::vector<double> neighbours_of(double frequency, int n, std::size_t points) {
  const double bin = 1.0 / static_cast<double>(points);
  const auto wanted = static_cast<std::size_t>(neighbours_for(points));
  std::vector<double> found;
  for (int step = 1; found.size() < wanted && step * bin < 0.5; ++step) {
    for (const double side : {-1.0, 1.0}) {
      const double neighbour = frequency + side * step * bin;
      if (neighbour < 0.75 * bin || neighbour > 0.5 - 0.25 * bin || is_taken(neighbour, n, bin)) continue;
      found.push_back(neighbour);
    }
  }
  return found;
}

double power(double base, int exponent) {
  double result = 1.0;
  for (int k = 0; k < exponent; ++k) result *= base;
  return result;
}

double chance_of(int numerator, int denominator, int n, std::span<const PlanePoint> deviations, double resolution) {
  // Only a whole number of cycles of the line is used, so that lines at other multiples of 1/denominator do not leak
  // into it.
  const std::size_t length = deviations.size() - deviations.size() % static_cast<std::size_t>(denominator);
  const auto points = deviations.last(length);
  const double frequency = static_cast<double>(numerator) / denominator;
  std::vector<double> frequencies = neighbours_of(frequency, n, length);
  const auto count = static_cast<int>(frequencies.size());
  frequencies.push_back(frequency);
  const std::vector<Amplitude> amplitudes = all_amplitudes_at(frequencies, points);
  const Amplitude& line = amplitudes.back();

  const double floor = resolution * resolution * static_cast<double>(length) * count;
  Covariance noise;
  for (const Amplitude& amplitude : std::span(amplitudes).first(amplitudes.size() - 1)) amplitude.add_to(noise);
  noise.xx += floor;
  noise.yy += floor;
  Covariance both = noise;
  if (denominator == 2) {
    both.add(line.real.scaled(std::numbers::sqrt2 / 2.0));  // all of the power; at other frequencies half
  } else {
    line.add_to(both);
  }
  const double ratio = std::sqrt(noise.determinant() / both.determinant());
  const int degrees = 2 * count;
  const double tail = power(ratio, degrees - 1);
  return denominator == 2 ? tail : tail * (degrees - (degrees - 1) * ratio);
}

}  // namespace

std::optional<Line> strongest_line(std::span<const PlanePoint> deviations, int n, double resolution) {
  std::optional<Line> strongest;
  for (int denominator = 2; denominator <= longest_period; ++denominator) {
    if (n % denominator == 0) continue;
    for (int numerator = 1; 2 * numerator <= denominator; ++numerator) {
      if (std::gcd(numerator, denominator) != 1) continue;
      const double chance = chance_of(numerator, denominator, n, deviations, resolution);
      if (!strongest || chance < strongest->chance) strongest = Line{numerator, denominator, chance};
    }
  }
  return strongest;
}

}  // namespace rocking::section
