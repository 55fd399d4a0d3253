#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "rocking/scene/experiment.hpp"
#include "rocking/stats/normal_check.hpp"

namespace rocking {

/// Which random numbers are compared with a distribution.
struct SamplerQuestion {
  std::uint64_t n = 20'000;            ///< how many numbers; at least 20
  stats::NormalLaw law = {0.4, 0.03};  ///< mean and standard deviation, of any distribution
  FluctuationLaw distribution = FluctuationLaw::normal;
  std::uint64_t seed = 0x2012;
  std::string sampler = "box-muller";  ///< that of simulations, `ziggurat` or `inverse-cdf`
};

/// Whether a sampler has this name.
[[nodiscard]] bool is_sampler(std::string_view name);

/// The numbers that a simulation would draw, scaled to the law, and their neighbours. Absent if sigma is too small to give
/// two different numbers. Precondition: is_sampler, n >= 20, and a positive mean
/// of a lognormal distribution.
[[nodiscard]] std::optional<stats::NormalCheck> check_sampler(const SamplerQuestion& question);

}  // namespace rocking
