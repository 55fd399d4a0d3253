#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "rocking/random/draws.hpp"

namespace rocking::random {

/// How uniform numbers become normal ones. Realisations use `box_muller`; the others are there to compare with.
enum class SamplerKind : std::uint8_t {
  box_muller,   ///< `box-muller`: Jeong & Yang (2012) Eq. 31, 32; the same bits on every machine
  ziggurat,     ///< `ziggurat`: Marsaglia & Tsang (2000), J. Stat. Softw. 5(8), as Boost.Random has it
  inverse_cdf,  ///< `inverse-cdf`: quantiles of uniform numbers, by Boost.Math; symmetric, within 8.21 sigma
};

[[nodiscard]] std::string_view to_string(SamplerKind kind);

/// The sampler that is spelled so; absent where none is.
[[nodiscard]] std::optional<SamplerKind> sampler_from_string(std::string_view text);

/// `n` numbers from N(0, 1), from the first draws of `source`.
///
/// A longer sample begins with the shorter one. Cost: 2 to 4 ns a number; 20 with `ziggurat`, 100 with `inverse_cdf`.
[[nodiscard]] std::vector<double> standard_sample(SamplerKind kind, const Draws& draws, Source source, std::size_t n);

/// `n` numbers from N(mean, sigma^2), sigma >= 0, from the source `check_normal` of realisation 0.
[[nodiscard]] std::vector<double> sample_normal(SamplerKind kind, std::uint64_t seed, std::size_t n, double mean,
                                                double sigma);

}  // namespace rocking::random
