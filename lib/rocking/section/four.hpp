#pragma once

#include <cstddef>

namespace rocking::section {

/// Four numbers in a register, if the machine has such registers; the bits are those of single numbers.
using Four = double __attribute__((vector_size(4 * sizeof(double))));

inline constexpr std::size_t four = 4;

}  // namespace rocking::section
