#pragma once

#include <cstdint>

#include "rocking/base/digest.hpp"
#include "rocking/realisation/realisation_result.hpp"

namespace rocking {

/// SHA-256 over the bits of a result: realisation number, termination, response mode, strobe points, counts of events.
[[nodiscard]] base::Sha256 digest_of(const RealisationResult& result, std::uint64_t realisation);

}  // namespace rocking
