#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/input/object_reader.hpp"

namespace rocking {

/// One entry of `sweep`: a place in the experiment file and the values it takes.
struct SweepAxis {
  std::string pointer;
  std::vector<Json> values;
  bool evenly_spaced = false;               ///< given by from, to and step
  std::vector<Json> canonical_values = {};  ///< as a condition reads them; filled while conditions are built
};

/// Most conditions that one experiment may have.
inline constexpr std::size_t most_conditions = 1'000'000;

/// The entries of `sweep`. `base` is the experiment in canonical form: a pointer must lead to something in it.
/// Points are from + i step, i = 0, 1, ..., never a running sum, rounded to 12 significant decimal digits; the two ends
/// are as they were written. `most`: conditions, all entries together.
[[nodiscard]] std::vector<SweepAxis> read_sweep(const Json& sweep, const Json& base, std::size_t most,
                                                Problems& problems);

/// Number of points of the grid; 1 without axes. Saturates above `most_conditions`.
[[nodiscard]] std::size_t grid_size(const std::vector<SweepAxis>& axes);

/// The value of each axis at point `index` of the grid; the last axis varies fastest.
[[nodiscard]] std::vector<const Json*> grid_point(const std::vector<SweepAxis>& axes, std::size_t index);

}  // namespace rocking
