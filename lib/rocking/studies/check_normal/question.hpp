#pragma once

#include <cstdint>
#include <string>

#include "rocking/api/experiment.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/stats/normal_check.hpp"

/// Random numbers against a distribution.
namespace rocking {

/// Which random numbers are compared with a distribution.
struct SamplerQuestion {
  std::uint64_t n = 20'000;            ///< how many numbers; at least 20
  stats::NormalLaw law = {0.4, 0.03};  ///< mean and standard deviation, of any distribution
  FluctuationLaw distribution = FluctuationLaw::normal;
  std::uint64_t seed = 0x2012;
  std::string sampler = "box-muller";  ///< that of simulations, `ziggurat` or `inverse-cdf`
};

/// Compares random numbers with a normal distribution: moments, tests of fit, correlations, histogram. Throws
/// base::InputError for a number out of range or an unknown sampler.
[[nodiscard]] ROCKING_API stats::NormalCheck check_normal(const SamplerQuestion& question = {});

/// The same as JSON text (`rocking.check_normal/1`).
[[nodiscard]] ROCKING_API std::string check_normal_text(const SamplerQuestion& question,
                                                        const stats::NormalCheck& found);

}  // namespace rocking
