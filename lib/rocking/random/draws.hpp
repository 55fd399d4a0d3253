#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "rocking/base/error.hpp"
#include "rocking/random/box_muller.hpp"
#include "rocking/random/philox.hpp"
#include "rocking/random/source.hpp"

namespace rocking::random {

struct NormalKernels;

/// The layout of keys and counters, lib/docs/draws.md. Another layout gives other numbers for the same seed.
inline constexpr std::string_view draws_format = "rocking.draws/1";

/// One past the largest realisation number: its counter has 56 bits for it.
inline constexpr std::uint64_t realisation_limit = std::uint64_t{1} << 56U;

/// The index of a draw that is counted in two steps: `minor` since the `major`-th mark.
///
/// What is drawn between two marks then leaves every later draw as it is, however many there were. Both below 2^32.
[[nodiscard]] constexpr std::uint64_t paired_index(std::uint64_t major, std::uint64_t minor) {
  ROCKING_EXPECT(major >> 32U == 0);  // beyond it another pair's draw would be repeated
  ROCKING_EXPECT(minor >> 32U == 0);
  return (major << 32U) | minor;
}

/// Every random number of one realisation.
///
/// A draw is a pure function of (seed, realisation, source, index): it depends on no other draw, on no order, on no
/// thread. Nothing is stored but the two numbers, so a copy is as good as the original. Layout: lib/docs/draws.md,
/// `rocking.draws/1`. A source is used for one kind of draw; a uniform and a normal of one index share their bits.
class Draws {
 public:
  constexpr Draws(std::uint64_t seed, std::uint64_t realisation) : seed_(seed), realisation_(realisation) {
    ROCKING_EXPECT(realisation < realisation_limit);
  }

  /// 64 random bits.
  [[nodiscard]] std::uint64_t bits(Source source, std::uint64_t index) const;

  /// A number in [0, 1), a multiple of 2^-53.
  [[nodiscard]] double uniform(Source source, std::uint64_t index) const;

  /// A number from N(0, 1), no larger than `normal_tail_limit`.
  [[nodiscard]] double standard_normal(Source source, std::uint64_t index) const;

  /// Draws 2 block and 2 block + 1 at the price of one: who walks along the indices keeps the pair of index / 2 and
  /// asks it for `pair[index]`.
  [[nodiscard]] NormalPair standard_normal_pair(Source source, std::uint64_t block) const;

  /// Draws first_index, first_index + 1, ... into `numbers`: the same bits as one by one, several at a time.
  ///
  /// None may have an index of 2^64 or more. Numbers are made 16 at a time, from an even index on; what is not asked for is
  /// made in vain. Cost: 2.2 ns a number with AVX-512, 3.6 with AVX2; 3.4 and 4.4 where 16 are asked for.
  void standard_normals(Source source, std::uint64_t first_index, std::span<double> numbers) const;

  /// The same bits, by kernels other than the best.
  void standard_normals(Source source, std::uint64_t first_index, std::span<double> numbers,
                        const NormalKernels& kernels) const;

 private:
  [[nodiscard]] Words counter_of(Source source, std::uint64_t block) const;
  [[nodiscard]] Words block_at(Source source, std::uint64_t block) const;

  std::uint64_t seed_;
  std::uint64_t realisation_;
};

}  // namespace rocking::random
