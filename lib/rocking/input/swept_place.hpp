#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rocking/input/object_reader.hpp"
#include "rocking/input/sweep.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// Whether the JSON pointer `inner` is `outer` or leads into what stands there.
[[nodiscard]] bool is_within(std::string_view inner, std::string_view outer);

/// JSON pointers to all values of an experiment that may be set from outside of it.
[[nodiscard]] std::vector<std::string> swept_places(const Json& experiment);

/// The pointer under `parameter`, which must lead to a value of the experiment, in canonical form, that may be changed.
/// Problems are reported to `in`.
[[nodiscard]] std::string read_swept_place(ObjectReader& in, const Json& experiment);

/// The entries of `unknown`. `base` is the experiment in canonical form: each pointer must lead to a number in it that
/// no axis of the sweep and no other entry changes.
[[nodiscard]] std::vector<Unknown> read_unknowns(const Json& list, const Json& base, const std::vector<SweepAxis>& axes,
                                                 Problems& problems);

}  // namespace rocking
