#include "rocking/section/nearby_sums.hpp"

#include <algorithm>
#include <numbers>

#include "rocking/base/elementary.hpp"
#include "rocking/base/error.hpp"

namespace rocking::section {
namespace {

constexpr std::size_t rows_at_once = 64;
constexpr auto longest_modulus = static_cast<std::size_t>(longest_period);

struct Turn {
  double cosine = 1.0;
  double sine = 0.0;
};

/// Turns by k/(2 Q) of a full turn: [Q][k].
using TurnTable = std::array<std::array<Turn, 2 * longest_modulus>, longest_modulus + 1>;

const TurnTable& turn_table() {
  static const TurnTable table = [] {
    TurnTable turns;
    for (std::size_t q = 1; q <= longest_modulus; ++q) {
      for (std::size_t k = 0; k < 2 * q; ++k) {
        const auto turn = base::sin_cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(q));
        turns[q][k] = {turn.cosine, turn.sine};
      }
    }
    return turns;
  }();
  return table;
}

FourTurns twice(const FourTurns& turn) { return turn.followed_by(turn); }

/// Turns by s/length of a full turn for s = 4 v ... 4 v + 3, as powers of the turn by 1/length.
FourTurns powers_of_turn(std::size_t length, std::size_t v) {
  const auto one = base::sin_cos(2.0 * std::numbers::pi / static_cast<double>(length));
  const FourTurns single{one.cosine * all_ones, one.sine * all_ones};
  const FourTurns two = twice(single);
  const FourTurns three = two.followed_by(single);
  const FourTurns by_four = twice(two);
  FourTurns turn{Four{1.0, one.cosine, two.cosine[0], three.cosine[0]},
                 Four{0.0, one.sine, two.sine[0], three.sine[0]}};
  for (std::size_t i = 0; i < v; ++i) turn = turn.followed_by(by_four);
  return turn;
}

/// Turns from the middle of `count` places to the places beyond it; `half` leads half of the way to the next.
struct TurnsFromMiddle {
  FourTurns now;
  FourTurns step;

  TurnsFromMiddle(std::size_t count, const FourTurns& half)
      : now(count % 2 == 0 ? half : FourTurns{all_ones, Four{}}), step(twice(half)) {}

  FourTurns next() {
    const FourTurns turn = now;
    now = now.followed_by(step);
    return turn;
  }
};

void add_to(FourSums& sums, const FourSums& other, double factor) {
  const Four each = factor * all_ones;
  sums.real_x = roughly_fused(each, other.real_x, sums.real_x);
  sums.imaginary_x = roughly_fused(each, other.imaginary_x, sums.imaginary_x);
  sums.real_y = roughly_fused(each, other.real_y, sums.real_y);
  sums.imaginary_y = roughly_fused(each, other.imaginary_y, sums.imaginary_y);
}

FourSums turned(const FourSums& sums, const FourTurns& by) {
  return {roughly_fused(sums.real_x, by.cosine, -sums.imaginary_x * by.sine),
          roughly_fused(sums.real_x, by.sine, sums.imaginary_x * by.cosine),
          roughly_fused(sums.real_y, by.cosine, -sums.imaginary_y * by.sine),
          roughly_fused(sums.real_y, by.sine, sums.imaginary_y * by.cosine)};
}

FourSums sum_of(const FourSums& a, const FourSums& b) {
  return {a.real_x + b.real_x, a.imaginary_x + b.imaginary_x, a.real_y + b.real_y, a.imaginary_y + b.imaginary_y};
}

FourSums difference_of(const FourSums& a, const FourSums& b) {
  return {a.real_x - b.real_x, a.imaginary_x - b.imaginary_x, a.real_y - b.real_y, a.imaginary_y - b.imaginary_y};
}

}  // namespace

void NearbySums::begin(std::span<const PlanePoint> points, std::size_t modulus) {
  ROCKING_EXPECT(modulus <= longest_modulus && points.size() % modulus == 0);
  modulus_ = modulus;
  length_ = points.size();
  vectors_ = 0;
  const std::size_t rows = length_ / modulus;
  rows_.resize((rows + 1) / 2 * 4 * modulus);
  double* to = rows_.data();
  for (std::size_t a = rows / 2; a < rows; ++a) {
    const std::span later = points.subspan(a * modulus, modulus);
    const std::span earlier = points.subspan((rows - 1 - a) * modulus, modulus);
    const double once = 2 * a + 1 == rows ? 0.5 : 1.0;  // the middle row is both
    for (std::size_t b = 0; b < modulus; ++b) {
      to[2 * b] = once * (later[b].x + earlier[b].x);
      to[2 * b + 1] = once * (later[b].y + earlier[b].y);
    }
    to += 2 * modulus;
    for (std::size_t b = 0; b < modulus; ++b) {
      to[2 * b] = later[b].x - earlier[b].x;
      to[2 * b + 1] = later[b].y - earlier[b].y;
    }
    to += 2 * modulus;
  }
}

/// By b: sum over a of z[Q a + b] exp(2 pi i s (a - middle) Q/L).
NearbySums::ColumnSums NearbySums::sum_over_rows(std::size_t v) const {
  ColumnSums sums;
  std::fill_n(sums.begin(), modulus_, FourSums{});
  const std::size_t rows = length_ / modulus_;
  TurnsFromMiddle from_middle(rows, powers_of_turn(2 * rows, v));
  const double* row = rows_.data();
  std::array<FourTurns, rows_at_once> turns;  // written before it is read
  for (std::size_t left = (rows + 1) / 2; left > 0;) {
    const std::size_t some = std::min(rows_at_once, left);
    for (std::size_t a = 0; a < some; ++a) turns[a] = from_middle.next();
    for (std::size_t b = 0; b < modulus_; ++b) {
      FourSums sum = sums[b];
      for (std::size_t a = 0; a < some; ++a) {
        const double* const even = row + 4 * a * modulus_ + 2 * b;
        const double* const odd = even + 2 * modulus_;
        sum.real_x = roughly_fused(even[0] * all_ones, turns[a].cosine, sum.real_x);
        sum.imaginary_x = roughly_fused(odd[0] * all_ones, turns[a].sine, sum.imaginary_x);
        sum.real_y = roughly_fused(even[1] * all_ones, turns[a].cosine, sum.real_y);
        sum.imaginary_y = roughly_fused(odd[1] * all_ones, turns[a].sine, sum.imaginary_y);
      }
      sums[b] = sum;
    }
    row += 4 * some * modulus_;
    left -= some;
  }
  return sums;
}

void NearbySums::add_columns(std::size_t v) {
  const ColumnSums sums = sum_over_rows(v);
  TurnsFromMiddle from_middle(modulus_, powers_of_turn(2 * length_, v));
  Columns& columns = columns_[v];
  for (std::size_t b = modulus_ / 2, i = 0; b < modulus_; ++b, ++i) {
    const FourTurns turn = from_middle.next();
    const FourSums later = turned(sums[b], turn);
    if (2 * b + 1 == modulus_) {  // the middle column is both
      columns.even[i] = later;
      columns.odd[i] = FourSums{};
    } else {
      const FourSums earlier = turned(sums[modulus_ - 1 - b], {turn.cosine, -turn.sine});
      columns.even[i] = sum_of(later, earlier);
      columns.odd[i] = difference_of(later, earlier);
    }
  }
}

NearbySums::Sides NearbySums::at(std::size_t j, std::size_t v) {
  ROCKING_EXPECT(j < modulus_ && v < most_vectors);
  for (; vectors_ <= v; ++vectors_) add_columns(vectors_);
  // The first sums at -s are the conjugates of those at s, because the points are real.
  const auto& turns = turn_table()[modulus_];
  FourSums c{};
  FourSums s{};
  std::size_t k = modulus_ % 2 == 0 ? j : 0;  // j times twice the distance from the middle, mod 2 Q
  for (std::size_t i = 0; i < (modulus_ + 1) / 2; ++i) {
    add_to(c, columns_[v].even[i], turns[k].cosine);
    add_to(s, columns_[v].odd[i], turns[k].sine);
    k += 2 * j;
    if (k >= 2 * modulus_) k -= 2 * modulus_;
  }
  return {
      .above = {c.real_x - s.imaginary_x, c.imaginary_x + s.real_x, c.real_y - s.imaginary_y, c.imaginary_y + s.real_y},
      .below = {c.real_x + s.imaginary_x, s.real_x - c.imaginary_x, c.real_y + s.imaginary_y,
                s.real_y - c.imaginary_y}};
}

Amplitude NearbySums::amplitude(std::size_t j, const FourSums& above) const {
  // The middle column is (Q - 1)/2; at s = 0 the rows need no turn.
  const Turn turn = turn_table()[modulus_][j * (modulus_ - 1) % (2 * modulus_)];
  const double real_x = above.real_x[0];
  const double real_y = above.real_y[0];
  const double imaginary_x = above.imaginary_x[0];
  const double imaginary_y = above.imaginary_y[0];
  return {
      .real = {real_x * turn.cosine - imaginary_x * turn.sine, real_y * turn.cosine - imaginary_y * turn.sine},
      .imaginary = {real_x * turn.sine + imaginary_x * turn.cosine, real_y * turn.sine + imaginary_y * turn.cosine}};
}

}  // namespace rocking::section
