#include "rocking/studies/rare/proposal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "rocking/base/elementary.hpp"
#include "rocking/base/natural_logarithm.hpp"
#include "rocking/base/normal_law.hpp"
#include "rocking/scene/drawn_quantities.hpp"

namespace rocking::rare {
namespace {

constexpr double own_share = 0.1;
constexpr double wide_share = 0.3;
constexpr double wide = 2.5;
constexpr std::size_t most_centres = 512;

/// e^x, 0 where that is too small for a normal number.
double exponential(double x) { return x < -700.0 ? 0.0 : base::exponential(std::min(x, 700.0)); }

/// Systematic choice of `count` points by their weights; each has the same weight then.
std::vector<Point> chosen(const std::vector<WeightedPoint>& points, std::size_t count) {
  double total = 0.0;
  for (const WeightedPoint& point : points) total += point.weight;
  std::vector<Point> centres;
  double sum = 0.0;
  for (const WeightedPoint& point : points) {
    sum += point.weight;
    while (centres.size() < count &&
           (static_cast<double>(centres.size()) + 0.5) * total < sum * static_cast<double>(count)) {
      centres.push_back(point.point);
    }
  }
  return centres;
}

/// Equal points as one, with the sum of their weights; without those of weight 0.
void merge_equal(std::vector<WeightedPoint>& points) {
  std::erase_if(points, [](const WeightedPoint& point) { return !(point.weight > 0.0); });
  std::ranges::sort(points, {}, &WeightedPoint::point);
  std::vector<WeightedPoint> merged;
  for (WeightedPoint& point : points) {
    if (!merged.empty() && merged.back().point == point.point) {
      merged.back().weight += point.weight;
    } else {
      merged.push_back(std::move(point));
    }
  }
  points = std::move(merged);
}

Point standard_deviations(const std::vector<WeightedPoint>& points, std::size_t dimensions) {
  double total = 0.0;
  for (const WeightedPoint& point : points) total += point.weight;
  Point deviations(dimensions);
  for (std::size_t d = 0; d < dimensions; ++d) {
    double mean = 0.0;
    for (const WeightedPoint& point : points) mean += point.weight / total * point.point[d];
    double square = 0.0;
    for (const WeightedPoint& point : points) {
      square += point.weight / total * (point.point[d] - mean) * (point.point[d] - mean);
    }
    constexpr double least = 1e-6;
    deviations[d] = std::max(std::sqrt(square), least);
  }
  return deviations;
}

/// Mean over the centres of exp(-distance^2/2), with lengths over the widths.
double mean_kernel(const std::vector<Point>& centres, const Point& widths, const Point& at) {
  double sum = 0.0;
  for (const Point& centre : centres) {
    double square = 0.0;
    for (std::size_t d = 0; d < at.size(); ++d) {
      const double distance = (at[d] - centre[d]) / widths[d];
      square += distance * distance;
    }
    sum += exponential(-0.5 * square);
  }
  return sum / static_cast<double>(centres.size());
}

/// The multiple of the deviations under which the fresh points are most likely by the others.
double best_multiple(const std::vector<WeightedPoint>& points, const std::vector<WeightedPoint>& fresh,
                     const Point& deviations) {
  const std::vector<Point> centres = chosen(points, most_centres / 2);
  double best = 1.0;
  double highest = -std::numeric_limits<double>::infinity();
  for (const double multiple : {1.0, 0.7, 0.5, 0.35, 0.25, 0.18, 0.125, 0.09, 0.06}) {
    Point widths = deviations;
    for (double& width : widths) width *= multiple;
    double likelihood = 0.0;
    double total = 0.0;
    for (const WeightedPoint& point : fresh) {
      const double least = std::numeric_limits<double>::min();
      const double kernel = std::max(mean_kernel(centres, widths, point.point), least);
      likelihood += point.weight * (base::natural_logarithm(kernel) -
                                    static_cast<double>(widths.size()) * base::natural_logarithm(multiple));
      total += point.weight;
    }
    if (likelihood / total > highest) {
      highest = likelihood / total;
      best = multiple;
    }
  }
  return best;
}

}  // namespace

Proposal Proposal::about_mean(std::size_t dimensions, double width) {
  Proposal proposal(dimensions);
  proposal.widths_.assign(dimensions, width);
  proposal.centres_.emplace_back(dimensions, 0.0);
  return proposal;
}

Proposal Proposal::fitted_to(std::vector<WeightedPoint> points, std::size_t dimensions, double least_width) {
  merge_equal(points);
  std::array<std::vector<WeightedPoint>, 2> halves;
  for (std::size_t i = 0; i < points.size(); ++i) halves[i % 2].push_back(points[i]);
  return fitted(points, halves[0], halves[1], dimensions, least_width);
}

Proposal Proposal::fitted_to(std::vector<WeightedPoint> points, const std::vector<WeightedPoint>& fresh,
                             std::size_t dimensions) {
  merge_equal(points);
  std::vector<WeightedPoint> all = points;
  all.insert(all.end(), fresh.begin(), fresh.end());
  merge_equal(all);
  return fitted(all, points, fresh, dimensions, 0.0);
}

Proposal Proposal::fitted(const std::vector<WeightedPoint>& all, const std::vector<WeightedPoint>& points,
                          const std::vector<WeightedPoint>& fresh, std::size_t dimensions, double least_width) {
  Proposal proposal(dimensions);
  if (all.size() < 2 || dimensions == 0) return proposal;
  proposal.widths_ = standard_deviations(all, dimensions);
  const double multiple = best_multiple(points, fresh, proposal.widths_);
  for (double& width : proposal.widths_) width = std::max(least_width, multiple * width);
  proposal.centres_ = chosen(all, most_centres);
  return proposal;
}

Point Proposal::draw(const random::Draws& draws) const {
  constexpr auto source = random::Source::rare_choice;
  Point point(dimensions_);
  draws.standard_normals(source, 2, point);
  if (centres_.empty()) return point;
  const double u = draws.uniform(source, 0);
  if (u < own_share) return point;
  const double multiple = u < own_share + wide_share ? wide : 1.0;
  const auto count = static_cast<double>(centres_.size());
  const Point& centre = centres_[static_cast<std::size_t>(draws.uniform(source, 1) * count)];
  for (std::size_t d = 0; d < dimensions_; ++d) point[d] = centre[d] + multiple * widths_[d] * point[d];
  return point;
}

double Proposal::likelihood_ratio(const Point& point) const {
  if (centres_.empty()) return 1.0;
  return 1.0 / (own_share + wide_share * density_ratio(point, wide) +
                (1.0 - own_share - wide_share) * density_ratio(point, 1.0));
}

double Proposal::density_ratio(const Point& point, double multiple) const {
  Point widths = widths_;
  double volume = 1.0;
  double square = 0.0;
  for (std::size_t d = 0; d < dimensions_; ++d) {
    widths[d] *= multiple;
    volume *= widths[d];
    square += point[d] * point[d];
  }
  return mean_kernel(centres_, widths, point) / volume * exponential(0.5 * square);
}

using random::Source;

DrawnNumbers drawn_numbers(const Scene& scene) {
  DrawnNumbers drawn;
  for_each_quantity(scene, [&drawn](const QuantityPlace& what, const Quantity& quantity) {
    if (is_drawn(quantity)) drawn.once.push_back(what.source);
  });
  const Fluctuation& f = scene.fluctuation;
  const bool amplitude_once = amplitude_draws(scene.excitation) == AmplitudeDraws::once;
  if (f.amplitude > 0.0 && amplitude_once) drawn.once.push_back(Source::amplitude);
  const bool often = f.kinetic_friction > 0.0 || f.restitution > 0.0 || (f.amplitude > 0.0 && !amplitude_once);
  drawn.along_the_way = often || f.static_friction > 0.0;
  // A block that never comes to a stop has the static friction of its start only.
  if (f.static_friction > 0.0 && !often) drawn.once.push_back(Source::static_friction);
  return drawn;
}

random::DrawHistory given_draws(const Scene& scene, const std::vector<Source>& once, const Point& point) {
  random::DrawHistory history;
  for (std::size_t d = 0; d < once.size(); ++d) history.given.push_back({once[d], point[d]});
  for_each_quantity(scene, [&history](const QuantityPlace& what, const Quantity& quantity) {
    if (!is_drawn(quantity) || drawn_from(quantity) != BasicDraw::uniform) return;
    constexpr double below_one = 1.0 - 0x1p-53;
    for (random::GivenDraw& draw : history.given) {
      if (draw.source == what.source) draw.number = std::min(base::normal_upper_tail(-draw.number), below_one);
    }
  });
  return history;
}

}  // namespace rocking::rare
