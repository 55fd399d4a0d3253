#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rocking/api/experiment.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/stats/normal_check.hpp"

/// Random numbers against a distribution.
namespace rocking {

/// Which random numbers are compared with a distribution.
struct SamplerQuestion {
  std::optional<std::string> file = std::nullopt;    ///< with numbers of the user; absent: they are drawn
  std::optional<std::string> column = std::nullopt;  ///< of the file, as its first line names it
  std::uint64_t n = 20'000;                          ///< how many numbers are drawn; at least 20
  std::optional<double> mean = std::nullopt;   ///< of any distribution; absent: 0.4, or that of the numbers in the file
  std::optional<double> sigma = std::nullopt;  ///< standard deviation; absent: 0.03, or likewise
  FluctuationLaw distribution = FluctuationLaw::normal;
  std::uint64_t seed = 0x2012;
  std::string sampler = "box-muller";  ///< that of simulations, `ziggurat` or `inverse-cdf`
};

/// Compares random numbers with a normal distribution: moments, tests of fit, correlations, histogram. Numbers of a file
/// are compared with that of mean and sigma, or, without both, with that of their own, whose p-values take this into
/// account. Throws base::InputError for a number out of range, an unknown sampler, or a file that has no such numbers, and
/// std::system_error if it cannot be read.
[[nodiscard]] ROCKING_API stats::NormalCheck check_normal(const SamplerQuestion& question = {});

}  // namespace rocking
