#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rocking/input/object_reader.hpp"

namespace rocking {

/// Whether the JSON pointer `inner` is `outer` or leads into what stands there.
[[nodiscard]] bool is_within(std::string_view inner, std::string_view outer);

/// JSON pointers to all values of an experiment that may be set from outside of it.
[[nodiscard]] std::vector<std::string> swept_places(const Json& experiment);

/// The pointer under `parameter`, which must lead to a value of the experiment, in canonical form, that may be changed.
/// Problems are reported to `in`.
[[nodiscard]] std::string read_swept_place(ObjectReader& in, const Json& experiment);

}  // namespace rocking
