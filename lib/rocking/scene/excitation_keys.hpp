#pragma once

#include "rocking/scene/keys.hpp"

namespace rocking {

/// The keys of `excitation`, kind by kind. `block`: mean block of the scene.
void keys_of(Keys& in, Excitation& excitation, const dynamics::Block& block);

}  // namespace rocking
