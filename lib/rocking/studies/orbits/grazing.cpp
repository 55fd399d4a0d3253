#include "rocking/studies/orbits/trace.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Dense>

#include "rocking/realisation/fixed_point.hpp"

namespace rocking {
namespace {

/// The margins of the orbits cover a factor of 2^11: below, rounding hides the derivatives; above, the polynomial ends at
/// the next grazing, or bends. Four are the fewest whose polynomial, a cubic, can be compared with one of two parameters.
constexpr int most_orbits = 12;
constexpr std::size_t least_orbits = 4;
/// Newton's method from the neighbouring orbits needs about five steps; where the differences are inaccurate, more.
constexpr int most_newton_steps = 25;
/// A step of Newton's method that still leaves the changes of contact after 2^-8 of it leads elsewhere.
constexpr int most_grazing_halvings = 8;
/// Guards that a curve may come to graze: reached at the largest rate of the orbits, 2^-5, or a little faster; passed at a
/// distance of a tenth in Theta over an acceleration of order 1, since a passage lasts a tenth of the unit of time.
constexpr double largest_rate = 0.05;
constexpr double largest_distance = 0.01;
/// Of the share of the range: that of a bracket. A worse limit is none.
constexpr double largest_error = 1e-9;
/// Between a point of the curve and the polynomial, and of the residual beside the grazing: far below the distance of two
/// curves, and above what is left of 1e-12 at a rate of 1e-6.
constexpr double same_curve = 1e-5;
/// Below it Newton's steps shrink until rounding.
constexpr double settled_step = 1e-8;
/// Of an orbit: rounding times multipliers of 1e7. Where they are larger, it cannot be known.
constexpr double largest_miss = 1e-8;
/// The steps of Newton's method at rounding differ by a few times their size.
constexpr double step_to_error = 4.0;
/// Of an image, in units of 1: a hundred steps of the series, each with a few roundings that partly cancel.
constexpr double map_rounding = 0x1p-49;
/// Differences are taken over this part of the level: the root in the map bends by as much. At most 1e-6: rounding of a
/// central difference is then 1e-10.
constexpr double part_of_level = 1e-3;
constexpr double longest_difference = 1e-6;

/// The guard that is grazed.
struct GrazedGuard {
  dynamics::Guard guard;
  std::optional<std::size_t> crossing;  ///< its place among the guards reached; absent where the motion passes it

  /// Of the orbit nearest to the grazing.
  [[nodiscard]] double least_margin() const { return crossing ? 0x1p-16 : 0x1p-30; }
  /// Of a point of the curve from which the orbits are sought: close to the grazing rounding hides the derivatives.
  [[nodiscard]] double margin_of_start() const { return crossing ? 0x1p-12 : 0x1p-22; }
  /// Of an orbit listed as that beside the grazing: rounding of the guard is far below it.
  [[nodiscard]] double margin_beside() const { return crossing ? 1e-6 : 1e-12; }
  /// What is smooth over the state and the parameter.
  [[nodiscard]] double level(double margin) const { return crossing ? margin * margin : margin; }
};

std::optional<double> margin_of(const GrazedGuard& grazed, const PoincareImage& image) {
  if (grazed.crossing) {
    if (*grazed.crossing >= image.crossings.size()) return std::nullopt;
    const GuardCrossing& crossing = image.crossings[*grazed.crossing];
    return crossing.guard == grazed.guard ? std::optional(std::abs(crossing.rate)) : std::nullopt;
  }
  std::optional<double> least;
  for (const GuardMinimum& minimum : image.minima) {
    if (minimum.guard != grazed.guard || !(minimum.value > 0.0)) continue;
    if (!least || minimum.value < *least) least = minimum.value;
  }
  return least;
}

/// The guards that may be grazed next to an orbit.
std::vector<GrazedGuard> guards_near(const PoincareImage& image) {
  std::vector<GrazedGuard> guards;
  for (std::size_t i = 0; i < image.crossings.size(); ++i) {
    const GuardCrossing& crossing = image.crossings[i];
    if (std::abs(crossing.rate) < largest_rate) guards.push_back({.guard = crossing.guard, .crossing = i});
  }
  for (const dynamics::Guard guard : {dynamics::Guard::tilt, dynamics::Guard::slip, dynamics::Guard::friction_inward,
                                      dynamics::Guard::friction_outward}) {
    const GrazedGuard passed{.guard = guard, .crossing = std::nullopt};
    const auto distance = margin_of(passed, image);
    if (distance && *distance < largest_distance) guards.push_back(passed);
  }
  return guards;
}

struct Evaluation {
  PoincareImage image;
  double margin = 0.0;
  Eigen::Vector4d value;  ///< H - z and the level
};

/// An orbit at a margin.
struct OrbitAtMargin {
  double margin = 0.0;
  Eigen::Vector4d at;
  double error = 0.0;  ///< of the parameter
};

/// The orbits of a family next to one grazing.
class OrbitsNearGrazing {
 public:
  OrbitsNearGrazing(const MapFamily& family, const GrazedGuard& grazed, ContactSequence sequence,
                    base::StopRequest stop)
      : family_(&family), grazed_(grazed), sequence_(std::move(sequence)), stop_(stop) {}

  /// Absent where the motion has other changes of contact.
  [[nodiscard]] std::optional<Evaluation> evaluate(const Eigen::Vector4d& at) const {
    auto image = family_->image({at[0], at[1], at[2], at[3]});
    if (!image || image->not_differentiable.any() || image->sequence != sequence_) return std::nullopt;
    const auto margin = margin_of(grazed_, *image);
    if (!margin) return std::nullopt;
    const section::StrobePoint& end = image->end();
    const Eigen::Vector4d value{end.tilt - at[0], end.tilt_rate - at[1], end.slip_rate - at[2], grazed_.level(*margin)};
    return Evaluation{.image = std::move(*image), .margin = *margin, .value = value};
  }

  /// By Newton's method until its steps are those of rounding.
  [[nodiscard]] std::optional<OrbitAtMargin> orbit_at(double margin, Eigen::Vector4d at) const {
    auto here = evaluate(at);
    double last = 0.0;
    for (int i = 0; here && i < most_newton_steps; ++i) {
      stop_.check();
      const auto matrix = derivative(at, *here);
      if (!matrix) return std::nullopt;
      Eigen::Vector4d right = -here->value;
      right[3] += grazed_.level(margin);
      const Eigen::Matrix4d inverse = matrix->inverse();
      const Eigen::Vector4d step = inverse * right;
      if (!step.allFinite()) return std::nullopt;
      const double size = step.norm();
      if (i > 0 && last < settled_step && !(size < 0.5 * last)) {
        if (!(here->value.head<3>().cwiseAbs().maxCoeff() < largest_miss)) return std::nullopt;
        const double rounding = map_rounding * inverse.row(3).head<3>().cwiseAbs().sum();
        return OrbitAtMargin{.margin = margin, .at = at, .error = step_to_error * std::abs(step[3]) + rounding};
      }
      here = take(at, step);
      last = size;
    }
    return std::nullopt;
  }

 private:
  /// The step, or a part of it that keeps the changes of contact.
  std::optional<Evaluation> take(Eigen::Vector4d& at, const Eigen::Vector4d& step) const {
    double share = 1.0;
    for (int i = 0; i < most_grazing_halvings; ++i, share *= 0.5) {
      auto found = evaluate(at + share * step);
      if (!found) continue;
      at += share * step;
      return found;
    }
    return std::nullopt;
  }

  /// Of (H - z, level): by the state from the tangent flow where that has it, else differences over a small part of the
  /// level, within which the changes of contact stay.
  [[nodiscard]] std::optional<Eigen::Matrix4d> derivative(const Eigen::Vector4d& at, const Evaluation& here) const {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      const auto column = static_cast<int>(i);
      if (i < 3 && is_fixed(here.image, i)) {
        matrix(column, column) = -1.0;
        continue;
      }
      const auto slope = slope_along(column, at, here);
      if (!slope) return std::nullopt;
      matrix.col(column) = *slope;
      if (i == 3) continue;
      for (std::size_t row = 0; row < 3; ++row) {
        matrix(static_cast<int>(row), column) = here.image.derivative[row][i] - (row == i ? 1.0 : 0.0);
      }
    }
    return matrix;
  }

  [[nodiscard]] std::optional<Eigen::Vector4d> slope_along(int unknown, const Eigen::Vector4d& at,
                                                           const Evaluation& here) const {
    double step = std::min(longest_difference, part_of_level * here.value[3]);
    for (int i = 0; i < 3; ++i, step *= 0.1) {
      const Eigen::Vector4d away = step * Eigen::Vector4d::Unit(unknown);
      const auto above = evaluate(at + away);
      const auto below = evaluate(at - away);
      if (above && below) return (above->value - below->value) / (2.0 * step);
      if (above) return (above->value - here.value) / step;
      if (below) return (here.value - below->value) / step;
    }
    return std::nullopt;
  }

  const MapFamily* family_;
  GrazedGuard grazed_;
  ContactSequence sequence_;
  base::StopRequest stop_;
};

Eigen::Vector4d vector_of(const Unknowns& at) { return Eigen::Vector4d(at.data()); }

/// Adds orbits to the last one of a list, each at `factor` times the margin of that before, within the margins s_k.
void add_orbits(const OrbitsNearGrazing& near, double factor, double last, std::vector<OrbitAtMargin>& orbits) {
  while (orbits.back().margin != last) {
    const OrbitAtMargin& at = orbits.back();
    Eigen::Vector4d sought = at.at;
    if (orbits.size() > 1) {
      const OrbitAtMargin& before = orbits[orbits.size() - 2];
      sought += (factor - 1.0) * at.margin / (at.margin - before.margin) * (at.at - before.at);
    }
    const auto next = near.orbit_at(factor * at.margin, sought);
    if (!next) return;
    orbits.push_back(*next);
  }
}

/// The orbits at the margins s_k by increasing margin, from that of a point of the curve on in both directions.
std::vector<OrbitAtMargin> orbits_near(const OrbitsNearGrazing& near, const GrazedGuard& grazed,
                                       const CurvePoint& from) {
  const auto margin = margin_of(grazed, from.image);
  if (!margin) return {};
  const double least = grazed.least_margin();
  const double largest = std::ldexp(least, most_orbits - 1);
  const double nearest = std::exp2(std::round(std::log2(*margin)));
  const double first = std::clamp(nearest, least, largest);
  std::optional<OrbitAtMargin> at{{.margin = *margin, .at = vector_of(from.at)}};
  while (at && at->margin != first) {
    at = near.orbit_at(at->margin < first ? std::min(4.0 * at->margin, first) : std::max(0.5 * at->margin, first),
                       at->at);
  }
  if (!at) return {};
  std::vector<OrbitAtMargin> orbits{*at};
  add_orbits(near, 2.0, largest, orbits);
  std::ranges::reverse(orbits);
  add_orbits(near, 0.5, least, orbits);
  std::ranges::reverse(orbits);
  return orbits;
}

using Orbits = std::span<const OrbitAtMargin>;

/// Weights of the polynomial through orbits.
std::vector<double> weights_at(double margin, Orbits orbits) {
  std::vector<double> weights(orbits.size(), 1.0);
  for (std::size_t i = 0; i < orbits.size(); ++i) {
    for (std::size_t k = 0; k < orbits.size(); ++k) {
      if (k != i) weights[i] *= (margin - orbits[k].margin) / (orbits[i].margin - orbits[k].margin);
    }
  }
  return weights;
}

Eigen::Vector4d polynomial_at(double margin, Orbits orbits) {
  const std::vector<double> weights = weights_at(margin, orbits);
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (std::size_t i = 0; i < orbits.size(); ++i) sum += weights[i] * orbits[i].at;
  return sum;
}

/// Of the parameter at margin 0.
double limit_error(Orbits orbits) {
  const std::vector<double> weights = weights_at(0.0, orbits);
  double rounding = 0.0;
  for (std::size_t i = 0; i < orbits.size(); ++i) rounding += std::abs(weights[i]) * orbits[i].error;
  const Eigen::Vector4d change = polynomial_at(0.0, orbits) - polynomial_at(0.0, orbits.first(orbits.size() - 1));
  return std::abs(change[3]) + rounding;
}

/// Those successive orbits whose polynomial has the smallest error; none if there are too few. Very close to the grazing
/// rounding is too large, far from it the polynomial.
Orbits best_of(const std::vector<OrbitAtMargin>& all) {
  Orbits best;
  for (std::size_t first = 0; first + least_orbits <= all.size(); ++first) {
    for (std::size_t count = least_orbits; first + count <= all.size(); ++count) {
      const Orbits some = Orbits(all).subspan(first, count);
      if (best.empty() || limit_error(some) < limit_error(best)) best = some;
    }
  }
  return best;
}

std::optional<Grazing> graze_guard(const MapFamily& family, const GrazedGuard& grazed,
                                   std::span<const CurvePoint> curve, base::StopRequest stop) {
  const CurvePoint* from = &curve.back();
  for (auto point = curve.rbegin(); point != curve.rend(); ++point) {
    if (point->image.sequence != curve.back().image.sequence) break;
    const auto margin = margin_of(grazed, point->image);
    if (!margin) break;
    from = &*point;
    if (*margin >= grazed.margin_of_start()) break;
  }
  const OrbitsNearGrazing near(family, grazed, curve.back().image.sequence, stop);
  const std::vector<OrbitAtMargin> all = orbits_near(near, grazed, *from);
  const Orbits orbits = best_of(all);
  if (orbits.empty() || !(limit_error(orbits) <= largest_error)) return std::nullopt;
  const double last = *margin_of(grazed, curve.back().image);
  const double away = (polynomial_at(last, orbits) - vector_of(curve.back().at)).norm();
  if (last <= orbits.back().margin && away > same_curve) return std::nullopt;
  const Eigen::Vector4d beside = polynomial_at(grazed.margin_beside(), orbits);
  auto found = near.evaluate(beside);
  if (!found || found->value.head<3>().cwiseAbs().maxCoeff() > same_curve) return std::nullopt;
  Grazing grazing{.beside = curve.back(), .share = polynomial_at(0.0, orbits)[3], .error = limit_error(orbits)};
  grazing.beside.at = {beside[0], beside[1], beside[2], beside[3]};
  grazing.beside.residual = found->value.head<3>().cwiseAbs().maxCoeff();
  grazing.beside.image = std::move(found->image);
  return grazing;
}

}  // namespace

std::optional<Grazing> graze(const MapFamily& family, std::span<const CurvePoint> curve, base::StopRequest stop) {
  std::optional<Grazing> nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const GrazedGuard& grazed : guards_near(curve.back().image)) {
    auto found = graze_guard(family, grazed, curve, stop);
    if (!found) continue;
    const double away = norm(plus(found->beside.at, -1.0, curve.back().at));
    if (away < least) least = away, nearest = std::move(found);
  }
  return nearest;
}

}  // namespace rocking
