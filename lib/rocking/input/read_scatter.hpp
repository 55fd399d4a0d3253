#pragma once

#include <initializer_list>

#include "rocking/input/object_reader.hpp"
#include "rocking/scene/keys.hpp"

namespace rocking {

/// Reads `sigma`, in the unit of the mean, or `relative_sigma`, a fraction of each mean.
void read_scatter(ObjectReader& in, std::initializer_list<Scatter> of);

}  // namespace rocking
