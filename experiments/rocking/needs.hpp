#pragma once

#include <cstdint>

namespace rocking::program {

/// Throws std::system_error if this process cannot have that much memory.
void expect_memory(std::uint64_t bytes);

}  // namespace rocking::program
