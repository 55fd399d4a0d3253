#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/ensemble/result.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/store/summary.hpp"

namespace rocking {

/// Quantiles at quantile_levels of some values and of `beyond` others above all of them.
[[nodiscard]] Quantiles quantiles_of(std::vector<double> values, std::uint64_t beyond, double confidence);

/// Collects the peaks of the realisations of a condition: 48 bytes for each.
class PeakTally {
 public:
  void add(const Summary& summary);

  [[nodiscard]] PeakQuantiles quantiles(const Condition& condition) const;

 private:
  std::vector<double> tilt_, tilt_rate_, slip_, slip_m_, final_slip_, final_slip_m_;
  std::uint64_t ended_before_ = 0;  ///< realisations that did not reach the horizon
};

/// Collects the Lyapunov exponents of the realisations of a condition: 16 bytes for each that has one.
class ExponentTally {
 public:
  void add(const Summary& summary);

  /// Absent where no realisation has one.
  [[nodiscard]] std::optional<Exponents> exponents(double confidence) const;

 private:
  std::vector<double> exponents_, errors_;
};

}  // namespace rocking
