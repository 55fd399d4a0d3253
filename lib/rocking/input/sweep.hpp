#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rocking/fields/field_reader.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// One entry of `sweep`: a place in the experiment file and the values it takes.
struct SweepAxis {
  std::string pointer;
  std::vector<Json> values;
  bool evenly_spaced = false;           ///< given by from, to and step
  std::vector<std::string> names = {};  ///< of the values, for readers; none, or one each, of which some may be empty
  std::vector<Json> canonical_values = {};  ///< as a condition reads them; filled while conditions are built

  /// Of one of the values.
  [[nodiscard]] std::string name_of(const Json* value) const {
    return names.empty() ? "" : names[static_cast<std::size_t>(value - values.data())];
  }
};

/// The key, beside the values of a condition, of the names that some of them have.
inline constexpr const char* names_of_values = "names";

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

/// JSON pointers to all values of an experiment that may be set from outside of it.
[[nodiscard]] std::vector<std::string> swept_places(const Json& experiment);

/// The pointer under `parameter`, which must lead to a value of the experiment, in canonical form, that may be changed.
/// Problems are reported to `in`.
[[nodiscard]] std::string read_swept_place(FieldReader& in, const Json& experiment);

/// The entries of `unknown`. `base` is the experiment in canonical form: each pointer must lead to a number in it that
/// no axis of the sweep and no other entry changes.
[[nodiscard]] std::vector<Unknown> read_unknowns(const Json& list, const Json& base, const std::vector<SweepAxis>& axes,
                                                 Problems& problems);

}  // namespace rocking
