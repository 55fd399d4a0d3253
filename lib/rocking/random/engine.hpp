#pragma once

#include <cstdint>
#include <limits>

#include "rocking/random/draws.hpp"

namespace rocking::random {

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
