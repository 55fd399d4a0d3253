#include "rocking/ensemble/quantile_tallies.hpp"

#include <algorithm>
#include <cmath>

#include "rocking/stats/moments.hpp"

namespace rocking {

Quantiles quantiles_of(std::vector<double> values, std::uint64_t beyond, double confidence) {
  std::ranges::sort(values);
  Quantiles quantiles{.realisations = values.size() + beyond, .beyond = beyond, .levels = {}};
  for (const double level : quantile_levels) {
    quantiles.levels.push_back(stats::quantile_estimate(values, beyond, level, confidence));
  }
  return quantiles;
}

void PeakTally::add(const Summary& summary) {
  if (summary.termination != dynamics::Termination::reached_horizon) {
    ++ended_before_;
    return;
  }
  tilt_.push_back(summary.peaks.tilt);
  tilt_rate_.push_back(summary.peaks.tilt_rate);
  slip_.push_back(summary.peaks.slip);
  slip_m_.push_back(summary.peaks.slip_m);
  final_slip_.push_back(summary.peaks.final_slip);
  final_slip_m_.push_back(summary.peaks.final_slip_m);
}

PeakQuantiles PeakTally::quantiles(const Condition& condition) const {
  const double confidence = condition.confidence;
  PeakQuantiles result{.tilt = quantiles_of(tilt_, ended_before_, confidence),
                       .tilt_rate = quantiles_of(tilt_rate_, ended_before_, confidence),
                       .slip = {},
                       .final_slip = {}};
  if (!condition.scene.friction) return result;
  result.slip = {.over_half_diagonal = quantiles_of(slip_, ended_before_, confidence),
                 .metres = quantiles_of(slip_m_, ended_before_, confidence).levels};
  result.final_slip = {.over_half_diagonal = quantiles_of(final_slip_, 0, confidence),
                       .metres = quantiles_of(final_slip_m_, 0, confidence).levels};
  return result;
}

void ExponentTally::add(const Summary& summary) {
  if (!summary.exponent || !summary.exponent_error) return;
  exponents_.push_back(*summary.exponent);
  errors_.push_back(*summary.exponent_error);
}

std::optional<Exponents> ExponentTally::exponents(double confidence) const {
  if (exponents_.empty()) return std::nullopt;
  const stats::CentralMoments moments = stats::central_moments(exponents_);
  const stats::CentralMoments errors = stats::central_moments(errors_);
  const auto n = static_cast<double>(exponents_.size());
  Exponents found{.mean = moments.mean,
                  .standard_error = {},
                  .error_of_one = std::sqrt(errors.second + errors.mean * errors.mean),
                  .quantiles = quantiles_of(exponents_, 0, confidence)};
  if (exponents_.size() > 1) found.standard_error = std::sqrt(moments.second / (n - 1.0));
  return found;
}

}  // namespace rocking
