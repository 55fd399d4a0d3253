#pragma once

#include <cstdint>
#include <map>

#include "rocking/section/response_mode.hpp"

namespace rocking {

/// Number of realisations of a condition, by response mode.
using ModeTally = std::map<section::ResponseMode, std::uint64_t>;

}  // namespace rocking
