#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <span>

namespace rocking::support {

/// Number of points at which a polynomial is evaluated, both ends included.
inline constexpr std::size_t points_of_look = 256;

/// Values at these points of [low, low + width], by Horner's rule for 32 points at once.
inline std::array<double, points_of_look> values_over(std::span<const double> c, double low, double width) {
  using Four [[gnu::vector_size(32)]] = double;
  constexpr std::size_t in_turns = 8;
  constexpr Four ascending{0.0, 1.0, 2.0, 3.0};
  const double spacing = 1.0 / static_cast<double>(points_of_look - 1);
  std::array<double, points_of_look> values;
  for (std::size_t first = 0; first < points_of_look; first += 4 * in_turns) {
    Four t[in_turns];
    Four value[in_turns];
#pragma GCC unroll 8
    for (std::size_t i = 0; i < in_turns; ++i) {
      t[i] = (ascending + static_cast<double>(first + 4 * i)) * spacing * width + low;
      value[i] = Four{} + c.back();
    }
    for (std::size_t k = c.size() - 1; k-- > 0;) {
#pragma GCC unroll 8
      for (std::size_t i = 0; i < in_turns; ++i) value[i] = value[i] * t[i] + c[k];
    }
    std::memcpy(&values[first], value, sizeof value);
  }
  return values;
}

/// Lowest value of sum c[k] t^k on [0, 1] that dense evaluation finds: at evenly spaced points, then around each
/// minimum that is small compared with the distance to its neighbours, and around the lowest of these, down to the
/// rounding of t.
///
/// Uses no Bernstein coefficients and no derivatives: a value below zero that it finds is certain.
inline double lowest_value(std::span<const double> c) {
  constexpr double step = 1.0 / static_cast<double>(points_of_look - 1);
  double lowest = std::numeric_limits<double>::infinity();
  const auto at_places = [&lowest](const auto& values, auto&& use) {
    for (std::size_t i = 0; i < points_of_look; ++i) {
      const double before = i == 0 ? values[1] : values[i - 1];
      const double after = i + 1 == points_of_look ? values[i - 1] : values[i + 1];
      lowest = std::min(lowest, values[i]);
      if (values[i] <= before && values[i] <= after && values[i] < std::max(before, after) - values[i]) use(i);
    }
  };
  at_places(values_over(c, 0.0, 1.0), [&](std::size_t place) {
    double low = 0.0;
    double width = 1.0;
    while (width > 0x1p-44) {
      const std::size_t from = place == 0 ? 0 : place - 1;
      const std::size_t to = std::min(place + 1, points_of_look - 1);
      low += width * step * static_cast<double>(from);
      width *= step * static_cast<double>(to - from);
      const auto closer = values_over(c, low, width);
      place = static_cast<std::size_t>(std::ranges::min_element(closer) - closer.begin());
      lowest = std::min(lowest, closer[place]);
    }
  });
  return lowest;
}

}  // namespace rocking::support
