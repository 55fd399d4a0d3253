// Frequency of wrong labels of noisy motions about an orbit to which they return slowly. The table is in
// reports/evidence/classification-evidence.md; this program makes it. The seeds are fixed: no false alarm.

#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstdio>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "rocking/section/classify.hpp"
#include "support/split_mix.hpp"

namespace rocking::section {
namespace {

using support::SplitMix;
using Complex = std::complex<double>;

/// z' = r exp(2 pi i f) z + noise about an orbit of n points, in N periods. The worst cells of N (1 - r) from 1 to 4 with f
/// near a fraction; and two in which windows tell.
struct Cell {
  int n;
  int count;
  double modulus;
  double turns;
};

constexpr std::array cells{Cell{1, 60, 0.983, 4.0 / 11.0},  Cell{1, 120, 0.991, 5.0 / 11.0},
                           Cell{1, 240, 0.9956, 1.0 / 8.0}, Cell{1, 480, 0.9978, 1.0 / 12.0},
                           Cell{1, 60, 0.95, 1.0 / 3.0},    Cell{1, 120, 0.98, 0.5},
                           Cell{3, 120, 0.99, 1.0 / 6.0},   Cell{3, 240, 0.995, 1.0 / 9.0},
                           Cell{3, 120, 0.94, 0.1},         Cell{1, 2000, 0.999, 1.0 / 7.0}};

constexpr StrobePoint point_of_orbit(int phase) { return {0.3 * phase - 0.3, phase == 1 ? 0.5 : -0.2, 0.0}; }

std::vector<Period> motion_in(const Cell& cell, SplitMix& draw) {
  std::vector<Period> periods;
  const Complex multiplier = std::polar(cell.modulus, 2.0 * std::numbers::pi * cell.turns);
  const double noise = 1e-3;
  Complex z = noise / std::sqrt(1.0 - cell.modulus * cell.modulus) * Complex(draw.normal(), draw.normal());
  for (int k = 0; k < cell.count; ++k) {
    const StrobePoint orbit = point_of_orbit(k % cell.n);
    periods.push_back({{orbit.tilt + z.real(), orbit.tilt_rate + z.imag(), 0.0},
                       k % cell.n == 0 ? std::uint16_t{2} : std::uint16_t{0},
                       true});
    z = multiplier * z + noise * Complex(draw.normal(), draw.normal());
  }
  return periods;
}

/// The orbit without noise, wherever it is sought from, over a multiple of its period.
OrbitSource orbit_of(const Cell& cell) {
  return [cell](const StrobePoint& near, int periods) -> std::optional<NearbyOrbit> {
    if (periods % cell.n != 0) return std::nullopt;
    int first = 0;
    for (int k = 1; k < cell.n; ++k) {
      if (distance(point_of_orbit(k), near) < distance(point_of_orbit(first), near)) first = k;
    }
    NearbyOrbit orbit{.points = {}, .impacts = 2, .moved = true, .decay = -std::log(cell.modulus)};
    for (int k = 0; k < cell.n; ++k) orbit.points.push_back(point_of_orbit((first + k) % cell.n));
    const Complex m = std::polar(std::pow(cell.modulus, cell.n), 2.0 * std::numbers::pi * cell.turns * cell.n);
    orbit.derivative = {{{m.real(), -m.imag(), 0.0}, {m.imag(), m.real(), 0.0}, {0.0, 0.0, 0.0}}};
    return orbit;
  };
}

struct Counts {
  int right = 0;
  int wrong = 0;
};

Counts counts_in(const Cell& cell, int series, const OrbitSource& source) {
  Counts counts;
  for (int i = 0; i < series; ++i) {
    SplitMix draw(static_cast<std::uint64_t>(i) + 1);
    const auto periods = motion_in(cell, draw);
    const double exponent = std::log(cell.modulus);
    const auto label =
        classify({.periods = periods, .random = true, .resolution = 1e-9, .find_orbit = source}, [exponent] {
          return std::optional(ExponentEstimate{.exponent = exponent, .standard_error = -0.1 * exponent});
        }).mode;
    if (label == periodic(1, cell.n)) {
      ++counts.right;
    } else if (label.kind != ResponseKind::unresolved) {
      ++counts.wrong;
    }
  }
  return counts;
}

TEST(SlowSpirals, AreSeldomGivenAMultipleOfTheirPeriod) {
  constexpr int series = 400;
  std::printf("  n     N       r      f   without an orbit: right wrong   with: right wrong   of %d\n", series);
  for (const Cell& cell : cells) {
    const Counts without = counts_in(cell, series, {});
    const Counts with = counts_in(cell, series, orbit_of(cell));
    std::printf("%3d %5d %7.4f %6.4f %24d %5d %13d %5d\n", cell.n, cell.count, cell.modulus, cell.turns, without.right,
                without.wrong, with.right, with.wrong);
    EXPECT_LE(without.wrong, series / 200) << cell.count << ' ' << cell.modulus;
    EXPECT_LE(with.wrong, series / 200) << cell.count << ' ' << cell.modulus;
    EXPECT_GE(with.right, without.right);
  }
}

}  // namespace
}  // namespace rocking::section
