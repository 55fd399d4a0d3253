#include "rocking/ensemble/exponent_tally.hpp"

#include <cmath>

#include "rocking/ensemble/peak_tally.hpp"
#include "rocking/stats/moments.hpp"

namespace rocking {

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
