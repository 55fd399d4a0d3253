#include "rocking/section/nearby_sums.hpp"

#include <algorithm>
#include <numbers>

#include "rocking/base/elementary.hpp"
#include "rocking/base/error.hpp"

namespace rocking::section {
namespace {

constexpr Four all_ones{1.0, 1.0, 1.0, 1.0};
constexpr std::size_t rows_at_once = 64;

void add_to(FourSums& sums, const PlanePoint& p, const FourTurns& at) {
  sums.real_x += p.x * at.cosine;
  sums.imaginary_x += p.x * at.sine;
  sums.real_y += p.y * at.cosine;
  sums.imaginary_y += p.y * at.sine;
}

void add_to(FourSums& sums, const FourSums& other, double factor) {
  sums.real_x += factor * other.real_x;
  sums.imaginary_x += factor * other.imaginary_x;
  sums.real_y += factor * other.real_y;
  sums.imaginary_y += factor * other.imaginary_y;
}

FourSums turned(const FourSums& sums, const FourTurns& by) {
  return {sums.real_x * by.cosine - sums.imaginary_x * by.sine, sums.real_x * by.sine + sums.imaginary_x * by.cosine,
          sums.real_y * by.cosine - sums.imaginary_y * by.sine, sums.real_y * by.sine + sums.imaginary_y * by.cosine};
}

}  // namespace

PowersOfTurn::PowersOfTurn(std::size_t length) {
  const auto [sine, cosine] = base::sin_cos(2.0 * std::numbers::pi / static_cast<double>(length));
  const double cosine_2 = cosine * cosine - sine * sine;
  const double sine_2 = 2.0 * sine * cosine;
  const double cosine_4 = cosine_2 * cosine_2 - sine_2 * sine_2;
  const double sine_4 = 2.0 * sine_2 * cosine_2;
  now_ = {Four{1.0, cosine, cosine_2, cosine_2 * cosine - sine_2 * sine},
          Four{0.0, sine, sine_2, sine_2 * cosine + cosine_2 * sine}};
  by_four_ = {cosine_4 * all_ones, sine_4 * all_ones};
}

FourTurns PowersOfTurn::next() {
  const FourTurns now = now_;
  now_ = now.followed_by(by_four_);
  return now;
}

NearbySums::NearbySums(std::span<const PlanePoint> points, std::size_t modulus)
    : points_(points), modulus_(modulus), row_turns_(points.size() / modulus), point_turns_(points.size()) {
  ROCKING_EXPECT(modulus <= cosines_.size() && points.size() % modulus == 0);
  const auto [sine, cosine] = base::sin_cos(2.0 * std::numbers::pi / static_cast<double>(modulus));
  double c = 1.0;
  double s = 0.0;
  for (std::size_t b = 0; b < modulus; ++b) {
    cosines_[b] = c;
    sines_[b] = s;
    const double next = c * cosine - s * sine;
    s = s * cosine + c * sine;
    c = next;
  }
}

/// By residue b: sum over a of z[Q a + b] exp(2 pi i s (Q a + b)/L). `row_turn` leads from one a to the next, by s Q/L;
/// `point_turn` from one b to the next, by s/L.
void NearbySums::sum_over_rows(const FourTurns& row_turn, const FourTurns& point_turn, FirstSums& sums) const {
  std::fill_n(sums.begin(), modulus_, FourSums{});
  const std::size_t rows = points_.size() / modulus_;
  std::array<FourTurns, rows_at_once>
      turns;  // written before it is read; setting it to 0 would cost a tenth of the time
  FourTurns row{all_ones, Four{}};
  for (std::size_t first = 0; first < rows; first += rows_at_once) {
    const std::size_t some = std::min(rows_at_once, rows - first);
    for (std::size_t a = 0; a < some; ++a) {
      turns[a] = row;
      row = row.followed_by(row_turn);
    }
    const auto points = points_.subspan(first * modulus_);
    for (std::size_t b = 0; b < modulus_; ++b) {
      FourSums sum = sums[b];
      for (std::size_t a = 0; a < some; ++a) add_to(sum, points[a * modulus_ + b], turns[a]);
      sums[b] = sum;
    }
  }
  FourTurns point{all_ones, Four{}};
  for (std::size_t b = 0; b < modulus_; ++b) {
    sums[b] = turned(sums[b], point);
    point = point.followed_by(point_turn);
  }
}

NearbySums::Sides NearbySums::at(std::size_t j, std::size_t v) {
  ROCKING_EXPECT(j < modulus_ && v < most_vectors);
  for (; vectors_ <= v; ++vectors_) sum_over_rows(row_turns_.next(), point_turns_.next(), first_sums_[vectors_]);
  // The first sums at -s are the conjugates of those at s, because the points are real.
  FourSums c{};
  FourSums s{};
  for (std::size_t b = 0, k = 0; b < modulus_; ++b) {  // k = j b mod Q
    add_to(c, first_sums_[v][b], cosines_[k]);
    add_to(s, first_sums_[v][b], sines_[k]);
    k += j;
    if (k >= modulus_) k -= modulus_;
  }
  return {
      .above = {c.real_x - s.imaginary_x, c.imaginary_x + s.real_x, c.real_y - s.imaginary_y, c.imaginary_y + s.real_y},
      .below = {c.real_x + s.imaginary_x, s.real_x - c.imaginary_x, c.real_y + s.imaginary_y,
                s.real_y - c.imaginary_y}};
}

}  // namespace rocking::section
