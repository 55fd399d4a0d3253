#include "rocking/section/closed_curves.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include "rocking/base/elementary.hpp"
#include "rocking/section/four.hpp"
#include "rocking/section/plane.hpp"

namespace rocking::section {
namespace {

constexpr std::size_t fewest_on_a_curve = 40;
constexpr std::size_t fewest_at_first = 20;  ///< for a guess
constexpr std::size_t fewest_returns = 8;    ///< after the largest number of turns that is looked at
constexpr int highest_harmonic = 3;          ///< of the rotation, that may be its strongest line

double squared_length(const PlanePoint& p) { return p.x * p.x + p.y * p.y; }

double fraction(double x) { return x - std::floor(x); }

/// Points n apart, as deviations from their mean, in units of the standard deviation of each coordinate.
class Curves {
 public:
  Curves(std::span<const StrobePoint> points, std::size_t n)
      : n_(n), length_(points.size() / n), deviations_(n * length_) {
    const auto last = points.last(deviations_.size());
    const bool rocks =
        std::ranges::any_of(last, [](const StrobePoint& p) { return p.tilt != 0.0 || p.tilt_rate != 0.0; });
    for (std::size_t k = 0; k < last.size(); ++k) {
      deviations_[k] = rocks ? PlanePoint{last[k].tilt, last[k].tilt_rate} : PlanePoint{last[k].slip_rate, 0.0};
    }
    subtract_means();
    unit_ = {rms(&PlanePoint::x), rms(&PlanePoint::y)};
    for (PlanePoint& p : deviations_) {
      p = {unit_.x > 0.0 ? p.x / unit_.x : 0.0, unit_.y > 0.0 ? p.y / unit_.y : 0.0};
    }
  }

  [[nodiscard]] std::size_t curves() const { return n_; }
  [[nodiscard]] std::size_t length() const { return length_; }  ///< points on a curve
  [[nodiscard]] const PlanePoint& at(std::size_t curve, std::size_t turn) const {
    return deviations_[turn * n_ + curve];
  }
  /// The standard deviation of the coordinate that moves less, of those that move.
  [[nodiscard]] double unit() const {
    if (unit_.x == 0.0 || unit_.y == 0.0) return std::max(unit_.x, unit_.y);
    return std::min(unit_.x, unit_.y);
  }
  [[nodiscard]] double squares() const {
    return std::accumulate(deviations_.begin(), deviations_.end(), 0.0,
                           [](double sum, const PlanePoint& p) { return sum + squared_length(p); });
  }

 private:
  void subtract_means() {
    for (std::size_t curve = 0; curve < n_; ++curve) {
      PlanePoint sum;
      for (std::size_t k = curve; k < deviations_.size(); k += n_) {
        sum = {sum.x + deviations_[k].x, sum.y + deviations_[k].y};
      }
      const PlanePoint mean = sum.scaled(1.0 / static_cast<double>(length_));
      for (std::size_t k = curve; k < deviations_.size(); k += n_) deviations_[k] = deviations_[k] - mean;
    }
  }

  [[nodiscard]] double rms(double PlanePoint::*coordinate) const {
    double sum = 0.0;
    for (const PlanePoint& p : deviations_) sum += p.*coordinate * p.*coordinate;
    return std::sqrt(sum / static_cast<double>(deviations_.size()));
  }

  std::size_t n_;
  std::size_t length_;
  std::vector<PlanePoint> deviations_;
  PlanePoint unit_;
};

/// Points first ... first + count - 1 of a curve, tapered to both ends, so that the lines of other frequencies do not leak
/// into the sums of one.
std::vector<PlanePoint> tapered(const Curves& curves, std::size_t curve, std::size_t first, std::size_t count) {
  std::vector<PlanePoint> points;
  points.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    points.push_back(curves.at(curve, first + i).scaled(t * (1.0 - t) * t * (1.0 - t)));
  }
  return points;
}

/// cos and sin of a frequency: of one, or of four side by side.
template <class Number>
struct Angle {
  Number cosine;
  Number sine;
};

Angle<double> angle_of(double frequency) {
  const auto angle = base::sin_cos(2.0 * std::numbers::pi * frequency);
  return {angle.cosine, angle.sine};
}

/// Fourier sums of the two coordinates.
template <class Number>
struct FourierSums {
  Number real_x{};
  Number real_y{};
  Number imaginary_x{};
  Number imaginary_y{};

  [[nodiscard]] Number power() const {
    return (real_x * real_x + real_y * real_y) + (imaginary_x * imaginary_x + imaginary_y * imaginary_y);
  }
};

/// The first point at the angle `start`, each further one `turn` later.
template <class Number>
FourierSums<Number> fourier_sums(std::span<const PlanePoint> points, const Angle<Number>& turn, Angle<Number> start) {
  FourierSums<Number> sums;
  for (const PlanePoint& p : points) {
    sums.real_x += p.x * start.cosine;
    sums.real_y += p.y * start.cosine;
    sums.imaginary_x -= p.x * start.sine;
    sums.imaginary_y -= p.y * start.sine;
    start = {start.cosine * turn.cosine - start.sine * turn.sine, start.sine * turn.cosine + start.cosine * turn.sine};
  }
  return sums;
}

FourierSums<double> tapered_sums(const Curves& curves, std::size_t curve, double frequency, std::size_t first,
                                 std::size_t count) {
  return fourier_sums(tapered(curves, curve, first, count), angle_of(frequency),
                      angle_of(fraction(frequency * static_cast<double>(first))));
}

/// How a line changes from the first half of the turns to the second.
struct LineChange {
  double factor = 0.0;  ///< of its amplitude
  double phase = 0.0;   ///< beyond that of its frequency [rad]; 0 from a quarter of a turn on
};

LineChange change_of_line(const Curves& curves, double frequency) {
  const std::size_t half = curves.length() / 2;
  double real = 0.0;
  double imaginary = 0.0;
  double early = 0.0;
  double late = 0.0;
  for (std::size_t curve = 0; curve < curves.curves(); ++curve) {
    const auto a = tapered_sums(curves, curve, frequency, 0, half);
    const auto b = tapered_sums(curves, curve, frequency, half, half);
    real += a.real_x * b.real_x + a.imaginary_x * b.imaginary_x + a.real_y * b.real_y + a.imaginary_y * b.imaginary_y;
    imaginary +=
        a.real_x * b.imaginary_x - a.imaginary_x * b.real_x + a.real_y * b.imaginary_y - a.imaginary_y * b.real_y;
    early += a.power();
    late += b.power();
  }
  return {std::sqrt(late / early), real > 0.0 ? base::arc_tangent(imaginary / real) : 0.0};
}

/// A line at frequency + d has in the second half of the points a phase that is larger by 2 pi d times half their number.
double refined(const Curves& curves, double frequency) {
  const double turns = static_cast<double>(curves.length() / 2);
  return frequency + change_of_line(curves, frequency).phase / (2.0 * std::numbers::pi * turns);
}

double strongest_frequency(const Curves& curves) {
  const std::size_t steps = curves.length();
  std::vector<std::vector<PlanePoint>> points;
  for (std::size_t curve = 0; curve < curves.curves(); ++curve) points.push_back(tapered(curves, curve, 0, steps));
  double strongest = 0.0;
  double most = -1.0;
  for (std::size_t first = 1; first <= steps; first += four) {  // four frequencies side by side
    Angle<Four> turn;
    const auto frequency = [&](std::size_t i) {
      return 0.5 * static_cast<double>(first + i) / static_cast<double>(steps);
    };
    for (std::size_t i = 0; i < four; ++i) {
      const Angle<double> one = angle_of(frequency(i));
      turn.cosine[i] = one.cosine;
      turn.sine[i] = one.sine;
    }
    Four power{};
    for (const auto& curve : points) power += fourier_sums<Four>(curve, turn, {all_ones, Four{}}).power();
    for (std::size_t i = 0; i < four && first + i <= steps; ++i) {
      if (!(power[i] > most)) continue;
      most = power[i];
      strongest = frequency(i);
    }
  }
  return refined(curves, refined(curves, strongest));
}

/// The turns 0, 1, ... in the order of their positions on a circle, if each advances by the rotation.
struct CircleOrder {
  std::vector<std::size_t> turns;
  std::vector<double> positions;  ///< of these, increasing

  CircleOrder(double rotation, std::size_t count) : turns(count), positions(count) {
    std::iota(turns.begin(), turns.end(), std::size_t{0});
    const auto position = [rotation](std::size_t turn) { return fraction(rotation * static_cast<double>(turn)); };
    std::ranges::sort(turns, {}, position);
    std::ranges::transform(turns, positions.begin(), position);
  }

  /// From a position to the one that follows on the circle.
  [[nodiscard]] double gap_after(std::size_t i) const {
    return i + 1 < positions.size() ? positions[i + 1] - positions[i] : positions[0] + 1.0 - positions[i];
  }
};

struct Rotation {
  double rotation = 0.0;
  double line = 0.0;  ///< the strongest frequency, in turns
  double disorder = std::numeric_limits<double>::infinity();
};

/// Mean square distance of neighbours in the order, in units of that of any two points (von Neumann's ratio): 1 for points
/// in no order.
double disorder_of(const Curves& curves, const CircleOrder& order) {
  double sum = 0.0;
  for (std::size_t curve = 0; curve < curves.curves(); ++curve) {
    const PlanePoint* before = &curves.at(curve, order.turns.back());
    for (const std::size_t turn : order.turns) {
      const PlanePoint& p = curves.at(curve, turn);
      sum += squared_length(p - *before);
      before = &p;
    }
  }
  return sum / (2.0 * curves.squares());
}

/// The rotation that puts the points in the best order. The strongest line is at it or at one of its harmonics.
Rotation best_rotation(const Curves& curves) {
  const double line = strongest_frequency(curves);
  Rotation best;
  for (int harmonic = 1; harmonic <= highest_harmonic; ++harmonic) {
    for (int j = 0; j < harmonic; ++j) {
      const double rotation = fraction((line + j) / harmonic);
      const double disorder = disorder_of(curves, {rotation, curves.length()});
      if (disorder < best.disorder) best = {std::min(rotation, 1.0 - rotation), line, disorder};
    }
  }
  return best;
}

double upper_median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Distance of a point from the chord of its two neighbours, at its position: the median. It holds noise and what the
/// curve bends between neighbours.
double scatter_about(const Curves& curves, const CircleOrder& order) {
  const std::size_t count = order.turns.size();
  std::vector<double> squares;
  squares.reserve(curves.curves() * count);
  for (std::size_t curve = 0; curve < curves.curves(); ++curve) {
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t before = (i + count - 1) % count;
      const PlanePoint& from = curves.at(curve, order.turns[before]);
      const PlanePoint chord = curves.at(curve, order.turns[(i + 1) % count]) - from;
      const double width = order.gap_after(before) + order.gap_after(i);
      const double share = width > 0.0 ? order.gap_after(before) / width : 0.5;
      squares.push_back(squared_length(curves.at(curve, order.turns[i]) - from - chord.scaled(share)));
    }
  }
  return std::sqrt(upper_median(squares));
}

/// Median distance of points so many turns apart, among the turns first ... last - 1.
double returns_after(const Curves& curves, std::size_t apart, std::size_t first, std::size_t last) {
  std::vector<double> squares;
  squares.reserve(curves.curves() * (last - first));
  for (std::size_t turn = first; turn + apart < last; ++turn) {
    for (std::size_t curve = 0; curve < curves.curves(); ++curve) {
      squares.push_back(squared_length(curves.at(curve, turn + apart) - curves.at(curve, turn)));
    }
  }
  return std::sqrt(upper_median(squares));
}

/// Whether so many positions fill the circle. n small curves far apart, or n clouds, are in order as one curve, but leave
/// it open.
bool fills_circle(double rotation, std::size_t positions, const Thresholds& thresholds) {
  const CircleOrder order(rotation, positions);
  double widest = 0.0;
  for (std::size_t i = 0; i < order.turns.size(); ++i) widest = std::max(widest, order.gap_after(i));
  return widest * static_cast<double>(order.turns.size()) <= thresholds.widest_gap;
}

/// Smallest factor by which the points miss each other after any number of turns, in units of `least_miss` scatters. A
/// period has close returns only at its multiples, so that one wide return among the multiples excludes it. 0 if the
/// closest returns become closer or wider with time.
double miss_margin(const Curves& curves, double scatter, const Thresholds& thresholds) {
  const std::size_t half = curves.length() / 2;
  std::vector<double> returns(curves.length() - fewest_returns + 1);
  double closest = std::numeric_limits<double>::infinity();
  for (std::size_t apart = 1; apart < returns.size(); ++apart) {
    returns[apart] = returns_after(curves, apart, 0, curves.length());
    if (apart > half || returns[apart] >= closest) continue;
    closest = returns[apart];
    const std::size_t middle = (curves.length() + apart) / 2;
    const double early = returns_after(curves, apart, 0, middle);
    const double late = returns_after(curves, apart, middle - apart, curves.length());
    if (std::max(early, late) > thresholds.largest_change * std::min(early, late)) return 0.0;
  }
  double margin = std::numeric_limits<double>::infinity();
  for (std::size_t period = 1; period < returns.size(); ++period) {
    double widest = 0.0;
    for (std::size_t apart = period; apart < returns.size(); apart += period) widest = std::max(widest, returns[apart]);
    margin = std::min(margin, widest / (thresholds.least_miss * scatter));
  }
  return margin;
}

/// The curves and the rotation, if the points on them are certain to turn.
std::optional<ClosedCurves> certain(const Curves& curves, const Rotation& found, double resolution,
                                    const Thresholds& thresholds) {
  const double change = change_of_line(curves, found.line).factor;
  if (!(std::max(change, 1.0 / change) <= thresholds.largest_change_of_line)) return std::nullopt;
  const double coincidence = thresholds.coincidence * resolution / curves.unit();
  const double scatter = std::max(scatter_about(curves, {found.rotation, curves.length()}), coincidence);
  const double missed = miss_margin(curves, scatter, thresholds);
  if (!(missed >= 1.0)) return std::nullopt;
  return ClosedCurves{.curves = static_cast<int>(curves.curves()),
                      .rotation = found.rotation,
                      .margin = std::min({missed, thresholds.largest_disorder / found.disorder, largest_margin})};
}

bool can_be_looked_at(std::span<const StrobePoint> points, int n, std::size_t fewest) {
  return n <= longest_period && points.size() / static_cast<std::size_t>(n) >= fewest;
}

}  // namespace

std::optional<ClosedCurves> find_closed_curves(std::span<const StrobePoint> points, double resolution,
                                               const Thresholds& thresholds) {
  for (int n = 1; can_be_looked_at(points, n, fewest_on_a_curve); ++n) {
    const Curves curves(points, static_cast<std::size_t>(n));
    if (curves.unit() <= resolution) return std::nullopt;
    const Rotation found = best_rotation(curves);
    const bool turns = found.rotation * static_cast<double>(curves.length()) >= thresholds.least_turns;
    // Half of the positions: if they did not fill it, the points might drift past those of a shorter period once.
    const bool in_order = found.disorder <= thresholds.largest_disorder;
    if (in_order && turns && fills_circle(found.rotation, curves.length() / 2, thresholds))
      return certain(curves, found, resolution, thresholds);
  }
  return std::nullopt;
}

bool may_be_closed_curves(std::span<const StrobePoint> points, double resolution, const Thresholds& thresholds) {
  for (int n = 1; can_be_looked_at(points, n, fewest_at_first); ++n) {
    const Curves curves(points, static_cast<std::size_t>(n));
    if (curves.unit() <= resolution) return false;
    const Rotation found = best_rotation(curves);
    const bool in_order = found.disorder <= thresholds.largest_first_disorder;
    if (in_order && fills_circle(found.rotation, curves.length(), thresholds)) return true;
  }
  return false;
}

}  // namespace rocking::section
