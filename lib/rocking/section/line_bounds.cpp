#include "rocking/section/line_bounds.hpp"

#include <bit>
#include <cmath>
#include <cstddef>

namespace rocking::section {
namespace {

constexpr std::size_t fewest_points =
    4 * static_cast<std::size_t>(longest_period);  // the bound of the errors needs L >= 40

/// Bound of the difference of a Fourier sum of L points here and in spectral_line.cpp, in units of the sum of the
/// absolute values of the points, divided by L.
///
/// Both multiply turns by each other. In roundings, a product of two turns adds 2.3 to the sum of their errors, and sin
/// and cos have 3.
/// spectral_line.cpp: a turn by one point has 23 (its frequency 1.75, times 2 pi; 2 pi and the product with it 6.3; sin
/// and cos; product), the turn of the last point 23 L; products and sums add L + 1. Together fewer than 25 L.
/// nearby_sums.cpp: a turn by s <= 15 half steps has at most 87 with the product, made from turns by 1, 2 and 4; a turn
/// by s steps 177. From the middle row it is multiplied at most L/(2 Q) times, from the middle column at most Q/2 times;
/// cos and sin of pi k/Q have 10; products and sums add L/(2 Q) + Q/2 + 8. For Q = 2 ... 12 and L >= 40 these are fewer
/// than 50 L.
/// Both together are below 75 L; the bound leaves room for terms of second order, and for the 2 of deviations from
/// different centres. The medians of classes have the least sum of absolute deviations, so that the sum of any other
/// deviations is not smaller.
constexpr double error_per_point = 128.0 * rounding_unit;

/// The largest multiple of q <= 12 for which the series has the same length as for q.
std::size_t modulus_for(std::size_t q, std::size_t points) {
  const auto longest = static_cast<std::size_t>(longest_period);
  std::size_t modulus = longest - longest % q;
  while (points % modulus != points % q) modulus -= q;
  return modulus;
}

/// 1 or 0 for each of four steps, by its bits.
constexpr std::array<std::array<double, four>, 16> weights = [] {
  std::array<std::array<double, four>, 16> table{};
  for (std::size_t bits = 0; bits < table.size(); ++bits) {
    for (std::size_t s = 0; s < four; ++s) table[bits][s] = (bits >> s & 1U) != 0 ? 1.0 : 0.0;
  }
  return table;
}();

Four weights_of(unsigned steps, std::size_t v) {
  const auto& w = weights[steps >> (four * v) & 15U];
  return Four{w[0], w[1], w[2], w[3]};
}

/// Which neighbours a line has, as bits by step.
struct NeighbourSteps {
  unsigned above = 0;
  unsigned below = 0;
  std::size_t count = 0;

  NeighbourSteps() = default;
  explicit NeighbourSteps(const Neighbourhood& neighbourhood) : count(neighbourhood.count) {
    for (std::size_t i = 0; i < count; ++i) {
      const int step = neighbourhood.steps[i];
      (step < 0 ? below : above) |= 1U << static_cast<unsigned>(step < 0 ? -step : step);
    }
  }
};

/// Those of line i in a series of `points` points, for n classes; found once for each thread, n and number of points.
const NeighbourSteps& neighbours_of(std::size_t i, int n, std::size_t points) {
  struct Known {
    std::size_t points = 0;
    std::array<NeighbourSteps, line_count> lines;
  };
  thread_local std::array<Known, static_cast<std::size_t>(longest_period) + 1> known;
  Known& of_n = known[static_cast<std::size_t>(n)];
  if (of_n.points != points) {
    for (std::size_t k = 0; k < of_n.lines.size(); ++k) {
      const LineFrequency& line = tested_lines()[k];
      const double frequency = static_cast<double>(line.numerator) / line.denominator;
      const std::size_t length = points - points % static_cast<std::size_t>(line.denominator);
      of_n.lines[k] = NeighbourSteps(neighbourhood_of(frequency, n, length));
    }
    of_n.points = points;
  }
  return of_n.lines[i];
}

/// Sums of the absolute values of the coordinates.
PlanePoint size_of(std::span<const PlanePoint> points) {
  Four sum{};
  std::size_t k = 0;
  for (; k + 2 <= points.size(); k += 2) {
    const Four two{points[k].x, points[k].y, points[k + 1].x, points[k + 1].y};
    sum += two < -two ? -two : two;
  }
  PlanePoint size{sum[0] + sum[2], sum[1] + sum[3]};
  if (k < points.size()) size = {size.x + std::abs(points[k].x), size.y + std::abs(points[k].y)};
  return size;
}

}  // namespace

LineSearch::LineSearch(std::span<const PlanePoint> deviations, int n, double resolution)
    : deviations_(deviations), size_(size_of(deviations)), n_(n), resolution_(resolution) {}

void LineSearch::remove_classes(std::span<const PlanePoint> deviations, int n) {
  deviations_ = deviations;
  size_ = size_of(deviations);
  n_ = n;
  for (std::size_t modulus = 2; modulus < groups_.size(); ++modulus) {
    const std::size_t length = deviations.size() - deviations.size() % modulus;
    if (length % static_cast<std::size_t>(n) != 0) forget_group(modulus);
  }
}

void LineSearch::forget_group(std::size_t modulus) {
  groups_[modulus].n = 0;
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const auto q = static_cast<std::size_t>(tested_lines()[i].denominator);
    if (modulus_for(q, deviations_.size()) == modulus) lines_[i].vectors = 0;
  }
}

/// Of the sums for deviations from other centres. Returns whether there were any.
bool LineSearch::forget_older_groups() {
  bool any = false;
  for (std::size_t modulus = 2; modulus < groups_.size(); ++modulus) {
    if (groups_[modulus].n == 0 || groups_[modulus].n == n_) continue;
    forget_group(modulus);
    any = true;
  }
  return any;
}

LineSearch::Group& LineSearch::group_for(std::size_t modulus) {
  Group& group = groups_[modulus];
  if (group.n == 0) {
    const std::size_t length = deviations_.size() - deviations_.size() % modulus;
    group.sums.begin(deviations_.last(length), modulus);
    group.n = n_;
    group.error = size_.scaled(error_per_point * static_cast<double>(length));
  }
  return group;
}

const LineSearch::KnownLine& LineSearch::known_line(std::size_t i, std::size_t vectors) {
  KnownLine& known = lines_[i];
  if (known.vectors >= vectors) return known;
  const LineFrequency& line = tested_lines()[i];
  const auto q = static_cast<std::size_t>(line.denominator);
  const std::size_t modulus = modulus_for(q, deviations_.size());
  const std::size_t j = static_cast<std::size_t>(line.numerator) * modulus / q;
  NearbySums& sums = group_for(modulus).sums;
  const auto powers = [](const FourSums& s) -> Powers {
    return {s.real_x * s.real_x + s.imaginary_x * s.imaginary_x, s.real_x * s.real_y + s.imaginary_x * s.imaginary_y,
            s.real_y * s.real_y + s.imaginary_y * s.imaginary_y};
  };
  for (; known.vectors < vectors; ++known.vectors) {
    const auto [above, below] = sums.at(j, known.vectors);
    if (known.vectors == 0) known.own = sums.amplitude(j, above);
    known.sides[known.vectors] = {powers(above), powers(below)};
  }
  return known;
}

/// Nothing if the neighbourhood is empty, or larger than the nearby sums.
std::optional<LineSums> LineSearch::sums_of(std::size_t i) {
  const NeighbourSteps& neighbours = neighbours_of(i, n_, deviations_.size());
  const std::size_t vectors =
      (static_cast<std::size_t>(std::bit_width(neighbours.above | neighbours.below)) + 3) / four;
  if (neighbours.count == 0 || vectors > NearbySums::most_vectors) return std::nullopt;
  const KnownLine& known = known_line(i, vectors);
  Powers sum{};
  for (std::size_t v = 0; v < vectors; ++v) {
    const Sides& sides = known.sides[v];
    const Four above = weights_of(neighbours.above, v);
    const Four below = weights_of(neighbours.below, v);
    sum.xx = roughly_fused(above, sides.above.xx, roughly_fused(below, sides.below.xx, sum.xx));
    sum.xy = roughly_fused(above, sides.above.xy, roughly_fused(below, sides.below.xy, sum.xy));
    sum.yy = roughly_fused(above, sides.above.yy, roughly_fused(below, sides.below.yy, sum.yy));
  }
  const auto q = static_cast<std::size_t>(tested_lines()[i].denominator);
  const Group& group = group_for(modulus_for(q, deviations_.size()));
  return LineSums{
      .noise = {sum_of(sum.xx), sum_of(sum.xy), sum_of(sum.yy)},
      .floor = squares_of_resolution(resolution_, deviations_.size() - deviations_.size() % q, neighbours.count),
      .own = known.own,
      .neighbours = neighbours.count,
      .at_half = q == 2,
      .error_x = group.error.x,
      .error_y = group.error.y};
}

AllChanceBounds LineSearch::bounds_of_known_sums() {
  std::array<std::size_t, line_count> places{};
  std::array<LineSums, line_count> sums;
  std::size_t count = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (n_ % tested_lines()[i].denominator == 0) continue;
    const auto found = sums_of(i);
    if (!found) continue;
    places[count] = i;
    sums[count++] = *found;
  }
  std::array<ChanceBounds, line_count> of_tested;
  set_bounds(std::span(sums).first(count), of_tested);
  AllChanceBounds bounds;
  for (std::size_t k = 0; k < count; ++k) bounds[places[k]] = of_tested[k];
  return bounds;
}

AllChanceBounds LineSearch::bounds() {
  if (deviations_.size() < fewest_points) return {};
  const AllChanceBounds bounds = bounds_of_known_sums();
  const auto is_uncertain = [&](std::size_t i) {
    return n_ % tested_lines()[i].denominator != 0 && std::isinf(bounds[i].most);
  };
  // Sums for other deviations have larger errors.
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    if (is_uncertain(i) && forget_older_groups()) return bounds_of_known_sums();
  }
  return bounds;
}

}  // namespace rocking::section
