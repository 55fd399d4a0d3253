#include "rocking/integrate/sign_loss.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "rocking/base/error.hpp"
#include "rocking/integrate/polynomial.hpp"

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

enum class Shape { nonnegative, starts_below, one_loss, unclear };

/// b[i] = sum_{k <= i} C(i,k)/C(n,k) c[k], by repeated sums of c[k]/C(n,k).
void to_bernstein(std::span<const double> c, std::array<double, max_coefficients>& b) {
  const std::size_t n = c.size() - 1;
  double binomial = 1.0;
  for (std::size_t k = 0; k <= n; ++k) {
    b[k] = c[k] / binomial;
    binomial = binomial * static_cast<double>(n - k) / static_cast<double>(k + 1);
  }
  for (std::size_t j = 1; j <= n; ++j) {
    for (std::size_t i = n; i >= j; --i) b[i] += b[i - 1];
  }
}

Shape shape_of(std::span<const double> b) {
  int changes = 0;
  double last = 0.0;
  for (const double value : b) {
    if (value == 0.0) continue;
    if (last == 0.0 && value < 0.0) return Shape::starts_below;
    if (last * value < 0.0) ++changes;
    last = value < 0.0 ? -1.0 : 1.0;
  }
  if (changes == 0) return Shape::nonnegative;
  return changes == 1 ? Shape::one_loss : Shape::unclear;
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

/// The one sign loss in [low, high], by Newton's method kept inside a shrinking bracket.
double refine(std::span<const double> c, double low, double high) {
  double t = 0.5 * (low + high);
  for (int iteration = 0; iteration < 100; ++iteration) {
    const double value = evaluate(c, t);
    (value < 0.0 ? high : low) = t;
    // At the loss p falls; where it rises Newton would run to a zero at the left end.
    const double slope = evaluate_derivative(c, t);
    double next = t - value / slope;
    if (!(slope < 0.0 && low <= next && next <= high)) next = 0.5 * (low + high);
    if (std::abs(next - t) <= std::numeric_limits<double>::epsilon() * t) return next;
    t = next;
  }
  return t;
}

}  // namespace

std::optional<double> first_sign_loss(std::span<const double> c) {
  ROCKING_EXPECT(!c.empty() && c.size() <= max_coefficients);
  const std::size_t n = c.size() - 1;
  std::array<Piece, max_depth + 2> pending;
  std::size_t count = 1;
  pending[0] = {.b = {}, .left = 0.0, .width = 1.0, .depth = 0};
  to_bernstein(c, pending[0].b);
  while (count > 0) {
    Piece& piece = pending[count - 1];
    switch (shape_of({piece.b.data(), n + 1})) {
      case Shape::nonnegative: --count; break;
      case Shape::starts_below: return piece.left;
      case Shape::one_loss: return refine(c, piece.left, piece.left + piece.width);
      case Shape::unclear:
        if (piece.depth < max_depth) {
          const Piece right = split(piece, n);
          pending[count] = piece;  // the left half is looked at first
          pending[count - 1] = right;
          ++count;
        } else {  // several roots closer together than rounding: a loss right here, or a touch
          if (piece.b[n] < 0.0) return piece.left;
          --count;
        }
        break;
    }
  }
  return std::nullopt;
}

}  // namespace rocking::integrate
