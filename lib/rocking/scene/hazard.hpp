#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rocking {

/// A point of a hazard curve.
struct HazardPoint {
  double intensity = 0.0;  ///< > 0, in the unit of the fragility function
  double rate = 0.0;       ///< annual rate at which this intensity is exceeded [1/year], > 0
};

/// A hazard curve: the logarithm of the rate is linear in that of the intensity between points, and continues the last
/// two beyond the last. Nothing is known below the first point. At least two points; intensities rise and rates fall.
struct HazardCurve {
  std::string name;             ///< of its file
  std::string intensity;        ///< measure that its header names; empty: it has no header
  std::size_t header_line = 0;  ///< of the file, from 1
  std::vector<HazardPoint> points;
};

/// What is known of the earthquake of a record.
struct RecordMetadata {
  std::string file;                   ///< as in the experiment, or its last part
  std::optional<double> magnitude;    ///< moment magnitude [-]
  std::optional<double> distance_km;  ///< > 0
};

}  // namespace rocking
