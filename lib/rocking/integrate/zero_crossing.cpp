#include "rocking/integrate/zero_crossing.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/integrate/polynomial.hpp"
#include "rocking/integrate/refine.hpp"

namespace rocking::integrate {
namespace {

/// Halvings until an interval is as short as the rounding of t.
constexpr int max_depth = 52;

/// A polynomial's Bernstein coefficients on [left, left + width].
struct Piece {
  std::array<double, max_coefficients> b;
  double left;
  double width;
  int depth;
};

enum class Shape { nonnegative, starts_below, one_crossing, unclear };

using WeightRows = std::array<std::array<double, max_coefficients>, max_coefficients>;

template <std::size_t n>
consteval WeightRows weight_rows() {
  constexpr auto weights = bernstein_weights<n>();
  WeightRows rows{};
  for (std::size_t k = 0; k <= n; ++k) {
    for (std::size_t i = 0; i <= n; ++i) rows[k][i] = weights.of[k][i];
  }
  return rows;
}

/// By degree, then by the indices of BernsteinWeights.
constexpr auto weights_of_degree = []<std::size_t... n>(std::index_sequence<n...>) {
  return std::array{weight_rows<n>()...};
}
(std::make_index_sequence<max_coefficients>{});

/// b[i] = sum_{k <= i} C(i,k)/C(n,k) c[k]; the inner loop runs over i, which compilers vectorise.
void to_bernstein(std::span<const double> c, std::array<double, max_coefficients>& b) {
  const WeightRows& weights = weights_of_degree[c.size() - 1];
  std::array<double, max_coefficients> sums{};
  for (std::size_t k = 0; k < c.size(); ++k) {
    for (std::size_t i = 0; i < max_coefficients; ++i) sums[i] = std::fma(weights[k][i], c[k], sums[i]);
  }
  b = sums;
}

/// Bit i: is(b[i]). Without a branch, because the signs are not predictable.
template <class Is>
std::uint32_t bits_where(std::span<const double> b, Is is) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < b.size(); ++i) bits |= static_cast<std::uint32_t>(is(b[i])) << i;
  return bits;
}

/// Signs of the coefficients, a zero counted with the one before it; `negative` is meaningful if the first is not zero.
struct Signs {
  std::uint32_t negative;
  Shape shape;
};

Signs signs_of(std::span<const double> b) {
  const std::uint32_t zero = bits_where(b, [](double value) { return value == 0.0; });
  std::uint32_t negative = bits_where(b, [](double value) { return value < 0.0; });
  const auto leading_zeros = static_cast<unsigned>(std::countr_one(zero));
  if (leading_zeros >= b.size()) return {negative, Shape::nonnegative};
  if ((negative >> leading_zeros & 1U) != 0) return {negative, Shape::starts_below};
  for (std::uint32_t inner = zero >> leading_zeros << leading_zeros; inner != 0; inner &= inner - 1) {
    const auto i = static_cast<unsigned>(std::countr_zero(inner));
    negative |= (negative >> (i - 1) & 1U) << i;
  }
  const std::uint32_t within = (1U << (b.size() - 1)) - 1U;
  const int changes = std::popcount((negative ^ (negative >> 1U)) & within);
  if (changes == 0) return {negative, Shape::nonnegative};
  return {negative, changes == 1 ? Shape::one_crossing : Shape::unclear};
}

/// De Casteljau at the middle: `piece` becomes its left half; the right half is returned.
Piece split(Piece& piece, std::size_t n) {
  Piece right{.b = {}, .left = piece.left + 0.5 * piece.width, .width = 0.5 * piece.width, .depth = piece.depth + 1};
  right.b[n] = piece.b[n];
  for (std::size_t j = 1; j <= n; ++j) {
    for (std::size_t i = n; i >= j; --i) piece.b[i] = 0.5 * (piece.b[i - 1] + piece.b[i]);
    right.b[n - j] = piece.b[n];
  }
  piece.width = right.width;
  piece.depth = right.depth;
  return right;
}

/// Where the polygon of the Bernstein coefficients, which change their sign once, crosses zero: near the root.
double crossing(std::span<const double> b, std::uint32_t negative) {
  const auto i = static_cast<std::size_t>(std::countr_zero(negative));
  return (static_cast<double>(i - 1) + b[i - 1] / (b[i - 1] - b[i])) / static_cast<double>(b.size() - 1);
}

}  // namespace

std::optional<double> first_zero_crossing(std::span<const double> c) {
  ROCKING_EXPECT(!c.empty() && c.size() <= max_coefficients);
  const std::size_t n = c.size() - 1;
  std::array<Piece, max_depth + 2> pending;
  std::size_t count = 1;
  pending[0] = {.b = {}, .left = 0.0, .width = 1.0, .depth = 0};
  to_bernstein(c, pending[0].b);
  while (count > 0) {
    Piece& piece = pending[count - 1];
    const std::span<const double> b(piece.b.data(), n + 1);
    const Signs signs = signs_of(b);
    switch (signs.shape) {
      case Shape::nonnegative: --count; break;
      case Shape::starts_below: return piece.left;
      case Shape::one_crossing: {
        constexpr int most_iterations = 100;
        double t = piece.left + piece.width * crossing(b, signs.negative);
        static_cast<void>(refine(c.data(), c.size(), true, piece.left, piece.left + piece.width, t, most_iterations));
        return t;
      }
      case Shape::unclear:
        if (piece.depth < max_depth) {
          const Piece right = split(piece, n);
          pending[count] = piece;  // the left half is searched first
          pending[count - 1] = right;
          ++count;
        } else {  // several roots closer together than rounding: a crossing here, or a touch
          if (piece.b[n] < 0.0) return piece.left;
          --count;
        }
        break;
    }
  }
  return std::nullopt;
}

}  // namespace rocking::integrate
