#pragma once

#include "rocking/input/object_reader.hpp"
#include "rocking/scene/experiment.hpp"

namespace rocking {

/// The key `fluctuation`; `scene` already holds the means.
void read_fluctuation(ObjectReader& in, Scene& scene);

}  // namespace rocking
