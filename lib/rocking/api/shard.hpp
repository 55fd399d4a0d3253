#pragma once

#include "rocking/scene/experiment.hpp"
#include "rocking/store/realisation_key.hpp"

namespace rocking {

/// Throws base::InputError if the shard is no part of a whole, or if the experiment cannot be divided.
void check_shard(const Experiment& experiment, const Shard& shard);

}  // namespace rocking
