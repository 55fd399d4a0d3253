#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "rocking/random/draws.hpp"

namespace rocking::random {

/// Method that converts uniform numbers to normal ones. Realisations use `box_muller`; the others serve comparisons.
enum class SamplerKind : std::uint8_t {
  box_muller,   ///< `box-muller`: Jeong & Yang (2012) Eq. 31, 32; the same bits on every machine
  ziggurat,     ///< `ziggurat`: Marsaglia & Tsang (2000), J. Stat. Softw. 5(8), as implemented in Boost.Random
  inverse_cdf,  ///< `inverse-cdf`: quantiles of uniform numbers, by Boost.Math; symmetric, within 8.21 sigma
};

/// Their names, in their order.
inline constexpr std::array<std::string_view, 3> sampler_names{"box-muller", "ziggurat", "inverse-cdf"};
[[nodiscard]] constexpr std::string_view to_string(SamplerKind kind) {
  return sampler_names[static_cast<std::size_t>(kind)];
}

/// The sampler with this name; absent if there is none.
[[nodiscard]] std::optional<SamplerKind> sampler_from_string(std::string_view text);

/// `n` numbers from N(0, 1), from the first draws of `source`.
///
/// The first numbers do not depend on `n`. Cost: 2 to 4 ns per number; 20 ns with `ziggurat`, 100 ns with
/// `inverse_cdf`.
[[nodiscard]] std::vector<double> standard_sample(SamplerKind kind, const Draws& draws, Source source, std::size_t n);

}  // namespace rocking::random
