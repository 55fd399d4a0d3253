#include "rocking/studies/fragility/fragility.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "rocking/api/refuse.hpp"
#include "rocking/stats/normal_law.hpp"
#include "rocking/stats/probit_surface.hpp"

namespace rocking {

using stats::FragilityOutcome;
using stats::SurfaceCoefficients;

namespace {

constexpr std::size_t map_points = 25;  // in each direction
constexpr std::size_t least_records = 3;
constexpr std::array<const char*, 4> terms{"1", "ln x", "ln y", "ln x ln y"};

double measure_of(const Stripe& stripe, const std::string& name) {
  const auto* const place = std::ranges::find(surface_measure_names, name);
  const auto number = static_cast<std::size_t>(place - surface_measure_names.begin());
  const std::optional<double> found = number < stripe.measures.size() ? stripe.measures[number] : stripe.pgv_over_pga;
  if (found && *found > 0.0) return *found;
  refuse("surface", name, "is not known of " + stripe.record + ", or changes with the realisation");
}

struct Point {
  double u = 0.0, v = 0.0;
};

/// Of the turn from a to b to c; positive: to the left.
double turn(const Point& a, const Point& b, const Point& c) {
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

/// The convex hull of points, counterclockwise. Source: Andrew (1979), Inf. Process. Lett. 9, 216-219.
std::vector<Point> hull_of(std::vector<Point> points) {
  std::ranges::sort(points, [](const Point& a, const Point& b) { return std::tie(a.u, a.v) < std::tie(b.u, b.v); });
  std::vector<Point> hull;
  for (const bool is_upper : {false, true}) {
    const std::size_t first = hull.size();
    for (const Point& point : points) {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0.0) hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();
    if (!is_upper) std::ranges::reverse(points);
  }
  return hull;
}

bool is_within(const std::vector<Point>& hull, const Point& point) {
  constexpr double rounding = 1e-9;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (turn(hull[i], hull[(i + 1) % hull.size()], point) < -rounding) return false;
  }
  return true;
}

/// The tested points in (ln x, ln y), less their means.
struct Tested {
  std::vector<stats::SurfaceCounts> counts;
  std::vector<Point> hull;
  Point centre;
  std::uint64_t unresolved = 0;

  [[nodiscard]] Point at(double x, double y) const { return {std::log(x) - centre.u, std::log(y) - centre.v}; }
};

Tested tested_by(const StripeGroup& group, FragilitySurface& surface) {
  Tested tested;
  std::size_t record = 0;
  for (const std::span<const Stripe> stripes : group.by_record()) {
    for (const Stripe& stripe : stripes) {
      const stats::IntensityLevel level = level_of(stripe, surface.subject.event);
      const TestedPoint& point = surface.tested.emplace_back(TestedPoint{.record = stripe.record,
                                                                         .x = measure_of(stripe, surface.measures[0]),
                                                                         .y = measure_of(stripe, surface.measures[1]),
                                                                         .overturned = stats::proportion_at(level)});
      const auto happened = static_cast<double>(point.overturned.successes);
      tested.counts.push_back({.u = std::log(point.x),
                               .v = std::log(point.y),
                               .happened = happened,
                               .did_not = static_cast<double>(point.overturned.trials) - happened,
                               .record = record});
      tested.unresolved += level.unresolved;
    }
    ++record;
  }
  const auto count = static_cast<double>(tested.counts.size());
  for (const auto& point : tested.counts) {
    tested.centre.u += point.u / count;
    tested.centre.v += point.v / count;
  }
  std::vector<Point> points;
  for (auto& point : tested.counts) {
    point.u -= tested.centre.u;
    point.v -= tested.centre.v;
    points.push_back({point.u, point.v});
  }
  tested.hull = hull_of(points);
  return tested;
}

/// Why there is no surface; `fitted` where nothing is against one.
FragilityOutcome outcome_of(const Tested& tested) {
  double happened = 0.0, did_not = 0.0, uu = 0.0, uv = 0.0, vv = 0.0;
  for (const auto& point : tested.counts) {
    happened += point.happened;
    did_not += point.did_not;
    uu += point.u * point.u;
    uv += point.u * point.v;
    vv += point.v * point.v;
  }
  if (tested.unresolved > 0) return FragilityOutcome::unresolved;
  if (happened == 0.0) return FragilityOutcome::never_happened;
  if (did_not == 0.0) return FragilityOutcome::always_happened;
  constexpr double least = 1e-6;  // 1 less the squared correlation: one measure follows from the other
  const bool is_line = !(uu * vv - uv * uv > least * uu * vv);
  return is_line || tested.counts.back().record + 1 < least_records ? FragilityOutcome::too_little
                                                                    : FragilityOutcome::fitted;
}

/// What follows from the regression.
class Surface {
 public:
  Surface(const stats::ProbitSurface& model, const Tested& tested, const SuiteCurve& curve)
      : model_(model), tested_(tested), curve_(curve) {}

  [[nodiscard]] SurfaceCoefficient coefficient(std::size_t i) const {
    return {.term = terms[i], .value = model_.coefficients[i], .interval = interval([i](const SurfaceCoefficients& c) {
                                                                 return c[i];
                                                               })};
  }

  [[nodiscard]] SurfacePoint at(double x, double y) const {
    const Point point = tested_.at(x, y);
    const auto probability = [&point](const SurfaceCoefficients& c) {
      return stats::normal_cdf(stats::surface_probit(c, point.u, point.v));
    };
    return {.x = x,
            .y = y,
            .probability = probability(model_.coefficients),
            .interval = interval(probability),
            .is_extrapolated = !is_within(tested_.hull, point)};
  }

  [[nodiscard]] SurfaceMedian median_at(double y) const {
    const double v = std::log(y) - tested_.centre.v;
    const auto median = [&](const SurfaceCoefficients& c) {
      const double slope = c[1] + c[3] * v;
      return slope > 0.0 ? std::exp(tested_.centre.u - (c[0] + c[2] * v) / slope) : NAN;
    };
    const double x = median(model_.coefficients);
    if (!std::isfinite(x)) return {.y = y, .x = std::nullopt, .interval = std::nullopt};
    return {.y = y,
            .x = x,
            .interval = interval(median),
            .is_extrapolated = !(x > 0.0) || !is_within(tested_.hull, tested_.at(x, y))};
  }

  /// `least`: no probability counts where x, or y, is smaller.
  [[nodiscard]] SurfaceRate rate(const JointHazard& hazard, const Point& least) const {
    double outside = 0.0;
    const auto sum = [&](const SurfaceCoefficients& c, double* beyond) {
      double all = 0.0;
      for (const JointCell& cell : hazard.cells) {
        if (cell.x < least.u || cell.y < least.v) continue;
        const Point point = tested_.at(cell.x, cell.y);
        const double part = cell.rate * stats::normal_cdf(stats::surface_probit(c, point.u, point.v));
        all += part;
        if (beyond != nullptr && !is_within(tested_.hull, point)) *beyond += part;
      }
      return all;
    };
    const double value = sum(model_.coefficients, &outside);
    return {.hazard = hazard.name,
            .value = value,
            .interval = interval([&](const SurfaceCoefficients& c) { return sum(c, nullptr); }),
            .extrapolated_share = value > 0.0 ? outside / value : 0.0};
  }

 private:
  template <class Value>
  [[nodiscard]] std::optional<stats::Interval> interval(Value&& value) const {
    std::vector<double> samples;
    for (const SurfaceCoefficients& sample : model_.samples) {
      if (const double found = value(sample); std::isfinite(found)) samples.push_back(found);
    }
    return curve_.interval_of(std::move(samples));
  }

  const stats::ProbitSurface& model_;
  const Tested& tested_;
  const SuiteCurve& curve_;
};

/// So many values from the least to the largest, with equal ratios.
std::vector<double> grid_of(const std::vector<double>& sorted) {
  std::vector<double> grid;
  const double ratio = std::log(sorted.back() / sorted.front());
  for (std::size_t i = 0; i < map_points; ++i) {
    grid.push_back(sorted.front() * std::exp(ratio * static_cast<double>(i) / static_cast<double>(map_points - 1)));
  }
  return grid;
}

void set_map(const Surface& surface, const base::ManyParts& how, FragilitySurface& found) {
  std::vector<double> x, y;
  for (const TestedPoint& point : found.tested) {
    x.push_back(point.x);
    y.push_back(point.y);
  }
  std::ranges::sort(x);
  std::ranges::sort(y);
  const std::size_t quarter = (y.size() - 1) / 4;
  for (const double at : {y[quarter], y[y.size() - 1 - quarter]}) found.medians.push_back(surface.median_at(at));
  const std::vector<double> columns = grid_of(x), rows = grid_of(y);
  found.map.resize(columns.size() * rows.size());
  base::for_each_part(how, found.map.size(), [&](std::size_t i) {
    found.map[i] = surface.at(columns[i % columns.size()], rows[i / columns.size()]);
  });
}

/// The least intensity that moves the block, where a measure is the swept one.
Point least_of(const FragilitySurface& surface) {
  const double least = surface.subject.least_uplift.value_or(0.0);
  const auto of = [&](const std::string& measure) {
    return surface.subject.parameter == "/excitation/" + measure ? least : 0.0;
  };
  return {of(surface.measures[0]), of(surface.measures[1])};
}

}  // namespace

SurfaceCoefficients FragilitySurface::values() const {
  SurfaceCoefficients found{};
  for (std::size_t i = 0; i < coefficients.size() && i < found.size(); ++i) found[i] = coefficients[i].value;
  return found;
}

FragilitySurface fragility_surface(const StripeGroup& group, const SuiteCurve& curve,
                                   const std::vector<std::string>& measures, const std::optional<JointHazard>& hazard,
                                   const base::ManyParts& how) {
  FragilitySurface found{.subject = curve.subject, .measures = {measures.at(0), measures.at(1)}};
  const Tested tested = tested_by(group, found);
  found.outcome = outcome_of(tested);
  if (found.outcome != FragilityOutcome::fitted) return found;
  const auto fit = stats::probit_surface(tested.counts, curve.bootstrap.weights, how);
  if (!fit) {
    found.outcome = FragilityOutcome::separated;
    return found;
  }
  found.centre = {std::exp(tested.centre.u), std::exp(tested.centre.v)};
  found.log_likelihood = fit->log_likelihood;
  found.interaction = fit->interaction;
  found.second = fit->second;
  const Surface surface(*fit, tested, curve);
  for (std::size_t i = 0; i < (fit->has_interaction ? terms.size() : 3U); ++i) {
    found.coefficients.push_back(surface.coefficient(i));
  }
  set_map(surface, how, found);
  if (hazard) found.rate = surface.rate(*hazard, least_of(found));
  return found;
}

}  // namespace rocking
