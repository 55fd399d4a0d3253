#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "rocking/scene/experiment.hpp"

namespace rocking {

/// A record of a suite that is likely another one once more.
struct RepeatedRecord {
  std::size_t record = 0;  ///< among those that were given
  std::string why;         ///< in a sentence without its name, with that of the other
};

/// Records whose series a former one has at some lag, with a factor, resampled, cut, padded, or backwards: the normalised
/// correlation of the accelerations below some 20 Hz is at least 0.95. Where both headers name earthquake, station and
/// component, they must be the same, and 0.6 suffices. Narrow-band and short series are not compared.
[[nodiscard]] std::vector<RepeatedRecord> repeated_records(
    const std::vector<std::shared_ptr<const GroundMotion>>& motions);

}  // namespace rocking
