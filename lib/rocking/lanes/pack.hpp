#pragma once

#include <cstdint>

#include "rocking/lanes/register.hpp"

/// Several doubles side by side in a register, as a number type.
///
/// All is in an unnamed namespace: each compiled unit has its own copy, so that code compiled for a newer processor is
/// never linked into a program that runs on an older one.
namespace rocking::lanes {
namespace {

/// A truth value for each lane.
template <int width>
struct Truth {
  typename Register<width>::Truths truths;
};

/// The doubles of one register, one a lane. Models base::Lane: each lane gets the bits that a double would get.
template <int width>
struct Pack {
  using Numbers = typename Register<width>::Numbers;
  using Bits = typename Register<width>::Bits;
  static constexpr int lanes = width;

  Numbers numbers;

  Pack() = default;
  explicit Pack(Numbers value) : numbers(value) {}
  explicit Pack(double value) : numbers(value - Numbers{}) {}  // a sum would change -0 to 0
};

template <int w>
inline Pack<w> operator+(const Pack<w>& a, const Pack<w>& b) {
  return Pack<w>(a.numbers + b.numbers);
}
template <int w>
inline Pack<w> operator-(const Pack<w>& a, const Pack<w>& b) {
  return Pack<w>(a.numbers - b.numbers);
}
template <int w>
inline Pack<w> operator*(const Pack<w>& a, const Pack<w>& b) {
  return Pack<w>(a.numbers * b.numbers);
}
template <int w>
inline Pack<w> operator/(const Pack<w>& a, const Pack<w>& b) {
  return Pack<w>(a.numbers / b.numbers);
}
template <int w>
inline Pack<w> operator-(const Pack<w>& a) {
  return Pack<w>(-a.numbers);
}
template <int w>
inline Truth<w> operator<(const Pack<w>& a, const Pack<w>& b) {
  return {is_less(a.numbers, b.numbers)};
}
template <int w>
inline Truth<w> operator==(const Pack<w>& a, const Pack<w>& b) {
  return {is_equal(a.numbers, b.numbers)};
}
template <int w>
inline Truth<w> operator&&(const Truth<w>& a, const Truth<w>& b) {
  return {both(a.truths, b.truths)};
}
template <int w>
inline Truth<w> operator||(const Truth<w>& a, const Truth<w>& b) {
  return {either(a.truths, b.truths)};
}
template <int w>
inline Truth<w> operator!(const Truth<w>& a) {
  return {opposite(a.truths)};
}

template <int w>
inline Pack<w> fused(const Pack<w>& a, const Pack<w>& b, const Pack<w>& c) {
  return Pack<w>(fused_of(a.numbers, b.numbers, c.numbers));
}
template <int w>
inline Pack<w> select(const Truth<w>& condition, const Pack<w>& a, const Pack<w>& b) {
  return Pack<w>(chosen(condition.truths, a.numbers, b.numbers));
}
template <int w>
inline Pack<w> magnitude(const Pack<w>& x) {
  constexpr std::uint64_t all_but_sign = ~std::uint64_t{0} >> 1U;
  return Pack<w>((typename Pack<w>::Numbers)((typename Pack<w>::Bits)x.numbers & all_but_sign));
}
template <int w>
inline Pack<w> smaller(const Pack<w>& a, const Pack<w>& b) {
  return Pack<w>(smaller_of(a.numbers, b.numbers));
}

/// See base::upper_word: an integer below 2^31, put into the lower bits of 2^52, is 2^52 and that integer.
template <int w>
inline Pack<w> upper_word(const Pack<w>& y) {
  constexpr std::uint64_t bits_of_2_52 = 0x4330000000000000;
  return Pack<w>((typename Pack<w>::Numbers)(((typename Pack<w>::Bits)y.numbers << 1U >> 33U) | bits_of_2_52) - 0x1p52);
}
template <int w>
inline Pack<w> from_upper_word(const Pack<w>& word) {
  return Pack<w>((typename Pack<w>::Numbers)((typename Pack<w>::Bits)(word.numbers + 0x1p52) << 32U));
}

template <int w>
inline bool in_any(const Truth<w>& truth) {
  return mask_of(truth.truths) != 0;
}

/// Bit i: the truth value of lane i.
inline std::uint32_t bits_of(bool truth) { return truth ? 1U : 0U; }
template <int w>
inline std::uint32_t bits_of(const Truth<w>& truth) {
  return mask_of(truth.truths);
}

}  // namespace
}  // namespace rocking::lanes
