#pragma once

#include <vector>

#include "rocking/input/object_reader.hpp"
#include "rocking/input/sweep.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// The entries of `unknown`. `base` is the experiment in canonical form: each pointer must lead to a number in it that
/// no axis of the sweep and no other entry changes.
[[nodiscard]] std::vector<Unknown> read_unknowns(const Json& list, const Json& base, const std::vector<SweepAxis>& axes,
                                                 Problems& problems);

}  // namespace rocking
