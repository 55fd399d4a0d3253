#include "rocking/section/line_neighbourhood.hpp"

#include <algorithm>
#include <numeric>

#include "rocking/section/classification.hpp"

namespace rocking::section {
namespace {

/// Number of frequencies in the neighbourhood: a twentieth of the frequency bins, between 6 and 12.
std::size_t neighbours_for(std::size_t points) { return std::clamp<std::size_t>(points / 20, 6, most_neighbours - 1); }

/// Whether removing the class centres removed this frequency: it is within one bin of a multiple of 1/n.
bool is_taken(double frequency, int n, double bin) {
  const double turns = frequency * n;
  const double off = turns - static_cast<int>(turns + 0.5);
  return std::max(off, -off) < 0.75 * bin * n;
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

Neighbourhood neighbourhood_of(double frequency, int n, std::size_t points) {
  const double bin = 1.0 / static_cast<double>(points);
  const double lowest = 0.75 * bin;
  const double highest = 0.5 - 0.25 * bin;
  const std::size_t wanted = neighbours_for(points);
  Neighbourhood found;
  const auto look_at = [&](double neighbour, int step) {
    if (neighbour < lowest || neighbour > highest || (n > 1 && is_taken(neighbour, n, bin))) return;
    found.frequencies[found.count] = neighbour;
    found.steps[found.count++] = step;
  };
  for (int step = 1; found.count < wanted && step * bin < 0.5; ++step) {
    look_at(frequency - step * bin, -step);
    look_at(frequency + step * bin, step);
  }
  return found;
}

double chance_of_ratio(double ratio, std::size_t neighbours, bool at_half) {
  const int degrees = 2 * static_cast<int>(neighbours);
  double tail = 1.0;
  for (int k = 1; k < degrees; ++k) tail *= ratio;
  return at_half ? tail : tail * (degrees - (degrees - 1) * ratio);
}

}  // namespace rocking::section
