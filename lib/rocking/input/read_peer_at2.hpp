#pragma once

#include <optional>
#include <string_view>

#include "rocking/input/read_ground_motion.hpp"

namespace rocking {

/// The format `peer_at2`: a header whose last line has NPTS and DT, in any of the wordings of the PEER databases, and
/// evenly spaced accelerations in g. As read_ground_motion.
[[nodiscard]] std::optional<GroundMotion> read_peer_at2(std::string_view text, const GroundMotionReading& how,
                                                        Problems& problems);

}  // namespace rocking
