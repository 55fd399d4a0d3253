#include "rocking/section/spectral_line.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include "rocking/base/elementary.hpp"
#include "rocking/section/period.hpp"

namespace rocking::section {
namespace {

/// Real and imaginary part of the Fourier sum of the points at a frequency.
struct Amplitude {
  PlanePoint real;
  PlanePoint imaginary;

  void add_to(Covariance& sum) const {
    sum.add(real);
    sum.add(imaginary);
  }
};

Amplitude amplitude_at(double frequency, std::span<const PlanePoint> points) {
  const auto turn = base::sin_cos(2.0 * std::numbers::pi * frequency);
  double cosine = 1.0;
  double sine = 0.0;
  Amplitude sum;
  for (const PlanePoint& p : points) {
    sum.real.x += p.x * cosine;
    sum.real.y += p.y * cosine;
    sum.imaginary.x += p.x * sine;
    sum.imaginary.y += p.y * sine;
    const double next = cosine * turn.cosine - sine * turn.sine;
    sine = sine * turn.cosine + cosine * turn.sine;
    cosine = next;
  }
  return sum;
}

/// Frequencies of the neighbourhood: a twentieth of the bins there are, but enough for a usable matrix.
int neighbours_for(std::size_t points) { return std::clamp(static_cast<int>(points / 20), 6, 12); }

/// Whether the class centres took this frequency away: it is within a bin of a multiple of 1/n.
bool is_taken(double frequency, int n, double bin) {
  const double turns = frequency * n;
  return std::abs(turns - std::round(turns)) < 0.75 * bin * n;
}

/// Sum over the M nearest frequencies on both sides, inside (0, 1/2), that nothing was taken from.
struct Neighbourhood {
  Covariance sum;
  int count = 0;
};

Neighbourhood neighbourhood_of(double frequency, int n, std::span<const PlanePoint> points) {
  const double bin = 1.0 / static_cast<double>(points.size());
  const int wanted = neighbours_for(points.size());
  Neighbourhood found;
  for (int step = 1; found.count < wanted && step * bin < 0.5; ++step) {
    for (const double side : {-1.0, 1.0}) {
      const double neighbour = frequency + side * step * bin;
      if (neighbour < 0.75 * bin || neighbour > 0.5 - 0.25 * bin || is_taken(neighbour, n, bin)) continue;
      amplitude_at(neighbour, points).add_to(found.sum);
      ++found.count;
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
  // Whole turns of the line only, so that a line at any other multiple of 1/denominator does not leak into this one.
  const std::size_t length = deviations.size() - deviations.size() % static_cast<std::size_t>(denominator);
  const auto points = deviations.last(length);
  const double frequency = static_cast<double>(numerator) / denominator;
  auto [noise, count] = neighbourhood_of(frequency, n, points);
  const double floor = resolution * resolution * static_cast<double>(length) * count;
  noise.xx += floor;
  noise.yy += floor;

  const Amplitude line = amplitude_at(frequency, points);
  Covariance both = noise;
  if (denominator == 2) {
    both.add(line.real.scaled(std::numbers::sqrt2 / 2.0));  // all of the power is in the real part, else half of it
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
