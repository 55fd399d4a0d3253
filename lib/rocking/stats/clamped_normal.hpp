#pragma once

namespace rocking::stats {

/// Mean and standard deviation of a law.
struct MeanAndSigma {
  double mean = 0.0;
  double sigma = 0.0;
};

/// Those of a normal number that is moved to `low` or `high` where it lies beyond. sigma > 0, low < high; infinities are
/// allowed.
[[nodiscard]] MeanAndSigma clamped_normal(const MeanAndSigma& law, double low, double high);

/// Those of the smaller of two normal numbers with this correlation.
/// Source: Clark (1961), Oper. Res. 9(2) 145-162, for the larger one.
[[nodiscard]] MeanAndSigma smaller_of_normals(const MeanAndSigma& first, const MeanAndSigma& second,
                                              double correlation);

}  // namespace rocking::stats
