#pragma once

#include <string_view>

#include "rocking/input/object_reader.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// A number or a law: `0.1`, `{"uniform": [a, b]}` or `{"normal": {"mean": m, "sigma": s}}`. `rule` bounds the number,
/// both ends of the interval, and the mean; its default is that of the number.
[[nodiscard]] Quantity read_quantity(ObjectReader& in, std::string_view key, const NumberRule& rule);

}  // namespace rocking
