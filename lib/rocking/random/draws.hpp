#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "rocking/base/error.hpp"
#include "rocking/random/box_muller.hpp"
#include "rocking/random/philox.hpp"
#include "rocking/random/source.hpp"

namespace rocking::random {

struct NormalKernels;

/// Name of the layout of keys and counters, lib/docs/draws.md. Another layout gives other numbers for the same seed.
inline constexpr std::string_view draws_format = "rocking.draws/1";

/// One more than the largest realisation number: the counter has 56 bits for it.
inline constexpr std::uint64_t realisation_limit = std::uint64_t{1} << 56U;

/// Index of a draw that is counted in two steps: number `minor` after event number `major`. Both below 2^32.
///
/// The number of draws between two events does not change the index of any later draw.
[[nodiscard]] constexpr std::uint64_t paired_index(std::uint64_t major, std::uint64_t minor) {
  ROCKING_EXPECT(major >> 32U == 0);  // a larger one would have the index of another pair
  ROCKING_EXPECT(minor >> 32U == 0);
  return (major << 32U) | minor;
}

/// Every random number of one realisation.
///
/// A draw is a pure function of (seed, realisation, source, index). It does not depend on other draws, on their order
/// or on threads. Only the seed and the realisation number are stored, so that copies are equivalent. Layout:
/// lib/docs/draws.md, `rocking.draws/1`. Use a source for one kind of draw only: a uniform and a normal draw with the
/// same index share their bits.
class Draws {
 public:
  constexpr Draws(std::uint64_t seed, std::uint64_t realisation) : seed_(seed), realisation_(realisation) {
    ROCKING_EXPECT(realisation < realisation_limit);
  }

  /// The numbers of another realisation under the same seed.
  [[nodiscard]] constexpr Draws of(std::uint64_t realisation) const { return {seed_, realisation}; }

  /// 64 random bits.
  [[nodiscard]] std::uint64_t bits(Source source, std::uint64_t index) const;

  /// A number in [0, 1), a multiple of 2^-53.
  [[nodiscard]] double uniform(Source source, std::uint64_t index) const;

  /// A number from N(0, 1); its absolute value is at most `normal_tail_limit`.
  [[nodiscard]] double standard_normal(Source source, std::uint64_t index) const;

  /// Draws 2 block and 2 block + 1 at the cost of one. To read successive indices, keep the pair of index / 2 and use
  /// `pair[index]`.
  [[nodiscard]] NormalPair standard_normal_pair(Source source, std::uint64_t block) const;

  /// Draws first_index, first_index + 1, ... into `numbers`: the same bits as one by one, several at a time.
  ///
  /// No index may reach 2^64. Numbers are computed 16 at a time, from an even index on; unrequested ones are discarded.
  /// Cost: 2.2 ns per number with AVX-512, 3.6 ns with AVX2; 3.4 and 4.4 ns if 16 are requested.
  void standard_normals(Source source, std::uint64_t first_index, std::span<double> numbers) const;

  /// The same bits, computed by the given kernels.
  void standard_normals(Source source, std::uint64_t first_index, std::span<double> numbers,
                        const NormalKernels& kernels) const;

 private:
  [[nodiscard]] Words counter_of(Source source, std::uint64_t block) const;
  [[nodiscard]] Words block_at(Source source, std::uint64_t block) const;

  std::uint64_t seed_;
  std::uint64_t realisation_;
};

/// The bits of one source in the order of their indices, as a uniform random bit generator. It serves algorithms, such
/// as those of Boost.Random, that do not know in advance how many draws they need.
class PhiloxEngine {
 public:
  using result_type = std::uint64_t;

  constexpr PhiloxEngine(Draws draws, Source source) : draws_(draws), source_(source) {}

  [[nodiscard]] static constexpr result_type min() { return 0; }
  [[nodiscard]] static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }

  result_type operator()() { return draws_.bits(source_, index_++); }

  /// Sets the index of the next number.
  constexpr void seek(std::uint64_t index) { index_ = index; }
  [[nodiscard]] constexpr std::uint64_t index() const { return index_; }

 private:
  Draws draws_;
  Source source_;
  std::uint64_t index_ = 0;
};

}  // namespace rocking::random
