#pragma once

#include <vector>

namespace rocking::stats {

/// A probability at one intensity.
struct KnownProbability {
  double intensity = 0.0;  ///< > 0
  double probability = 0.0;
};

/// A probability between intensities at which it is known: its probit is interpolated linearly in the logarithm of the
/// intensity, which is exact for a lognormal law. Outside the intensities the nearest piece is continued.
class ProbitInterpolation {
 public:
  /// At least two points, by increasing intensity.
  explicit ProbitInterpolation(const std::vector<KnownProbability>& points);

  [[nodiscard]] double probability(double intensity) const;

 private:
  struct Node {
    double logarithm, probit;
  };
  std::vector<Node> nodes_;
};

}  // namespace rocking::stats
