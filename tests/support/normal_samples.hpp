#pragma once

// Samples to be tested, and the accuracy of the p-values of the tests. Used by the tests that good draws must pass and
// by those that bad draws must fail.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "rocking/random/draws.hpp"
#include "rocking/random/sampler.hpp"
#include "rocking/stats/normal_check.hpp"
#include "support/false_alarms.hpp"

namespace rocking::support {

using Sample = std::vector<double>;

inline constexpr std::size_t large = 1000000;

/// Upper bound of the probability that n uniform numbers have an empirical law this far from theirs: 2 exp(-2 n D^2),
/// for every n (Massart 1990, Ann. Probab. 18, 1269-1283).
inline double uniformity(std::vector<double> p_values) {
  std::sort(p_values.begin(), p_values.end());
  const auto n = static_cast<double>(p_values.size());
  double distance = 0.0;
  for (std::size_t i = 0; i < p_values.size(); ++i) {
    const auto below = static_cast<double>(i);
    distance = std::max({distance, p_values[i] - below / n, (below + 1.0) / n - p_values[i]});
  }
  return std::min(1.0, 2.0 * std::exp(-2.0 * n * distance * distance));
}

/// `n` numbers from N(0, 1), from the draws of `rocking check-normal` in a realisation.
inline Sample sample_of(random::SamplerKind kind, std::uint64_t seed, std::size_t n, std::uint64_t realisation = 0) {
  return random::standard_sample(kind, random::Draws(seed, realisation), random::Source::check_normal, n);
}

/// The check of `rocking check-normal`: a sample of a sampler, its next realisation and the next source.
inline stats::NormalCheck check_of(random::SamplerKind kind, std::uint64_t seed, std::size_t n) {
  const Sample sample = sample_of(kind, seed, n);
  const Sample of_next_realisation = sample_of(kind, seed, n, 1);
  const Sample of_next_source = random::standard_sample(kind, random::Draws(seed, 0), random::Source::slip_rate, n);
  return stats::check_normal({sample, of_next_realisation, of_next_source}, {}).value();
}

/// The check of a given sample, with good neighbours.
inline stats::NormalCheck check_of(const Sample& sample) {
  const Sample a = sample_of(random::SamplerKind::box_muller, 1, sample.size());
  const Sample b = sample_of(random::SamplerKind::box_muller, 2, sample.size());
  return stats::check_normal({sample, a, b}, {}).value();
}

/// Uniformity of each p-value over many seeds; those of the tails are omitted, because they are discrete.
inline std::vector<double> uniformities(std::uint64_t seeds,
                                        const std::function<stats::NormalCheck(std::uint64_t)>& check_of_seed) {
  std::vector<std::vector<double>> p_values;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const std::vector<double> of_seed = stats::p_values_of(check_of_seed(seed));
    p_values.resize(of_seed.size() - 3);
    for (std::size_t i = 0; i < p_values.size(); ++i) p_values[i].push_back(of_seed[i]);
  }
  std::vector<double> found;
  for (std::vector<double>& of_test : p_values) found.push_back(uniformity(of_test));
  return found;
}

}  // namespace rocking::support
