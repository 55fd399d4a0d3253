#include "rocking/studies/orbits/orbits.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "rocking/realisation/fixed_point.hpp"
#include "rocking/studies/orbits/fold_and_flip.hpp"
#include "rocking/studies/orbits/trace.hpp"

namespace rocking {
namespace {

// Steps are as in trace.hpp, with the shares of both ranges. The tangent is known to about 1e-11/1e-9 where differences
// need the shortest step (fold_and_flip.cpp), so that steps below 1e-7 tell nothing of its direction.
constexpr double least_curve_step = 1e-7;

/// Distance up to which a bifurcation is on a curve: as those of one bifurcation in branches.cpp.
constexpr double same_orbit = 1e-2;

struct TracedCriticalCurve {
  std::vector<CriticalPoint> points;  ///< without the start
  BranchEnd end = BranchEnd::range;
};

/// Follows one curve in one direction.
class CriticalTrace {
 public:
  CriticalTrace(const CriticalFamily& family, const CurveQuestion& question, base::StopRequest stop)
      : family_(&family), question_(&question), stop_(stop) {}

  [[nodiscard]] TracedCriticalCurve from(const CriticalPoint& start) const {
    TracedCriticalCurve curve;
    CriticalPoint at = start;
    double step = first_step;
    while (curve.points.size() < question_->most_points) {
      auto next = step_from(at, step);
      if (!next) {
        step *= 0.5;
        if (step >= least_curve_step) continue;
        curve.end = why_lost(at);
        return curve;
      }
      const bool closes = curve.points.size() > 3 && comes_back(start, at, next->point);
      if (closes) {
        curve.end = BranchEnd::closed;
        return curve;
      }
      curve.points.push_back(next->point);
      if (question_->on_point) question_->on_point();
      if (next->is_at_end) return curve;
      if (next->point.steps <= few_newton_steps) step = std::min(1.5 * step, largest_step);
      at = std::move(next->point);
    }
    curve.end = BranchEnd::points;
    return curve;
  }

 private:
  struct Next {
    CriticalPoint point;
    bool is_at_end = false;
  };

  /// Share of a step along the tangent after which a parameter leaves its range; 1 if it does not.
  static double share_within(const CriticalPoint& at, double step, std::size_t unknown) {
    const double sought = at.at[unknown] + step * at.tangent[unknown];
    if (sought >= 0.0 && sought <= 1.0) return 1.0;
    return ((sought < 0.0 ? 0.0 : 1.0) - at.at[unknown]) / (step * at.tangent[unknown]);
  }

  [[nodiscard]] std::optional<Next> step_from(const CriticalPoint& at, double step) const {
    const std::size_t leaving = share_within(at, step, 4) < share_within(at, step, 3) ? 4 : 3;
    const double share = share_within(at, step, leaving);
    const bool is_beyond = share < 1.0;
    PlaneUnknowns sought = plus(at.at, share * step, at.tangent);
    PlaneUnknowns normal = at.tangent;
    if (is_beyond) {
      sought[leaving] = at.tangent[leaving] < 0.0 ? 0.0 : 1.0;
      normal = {};
      normal[leaving] = at.tangent[leaving] < 0.0 ? -1.0 : 1.0;
    }
    auto point = correct(*family_, at.border, {.normal = normal, .through = sought}, stop_);
    if (!point) return std::nullopt;
    if (is_beyond) point->at[leaving] = sought[leaving];
    for (const std::size_t unknown : {std::size_t{3}, std::size_t{4}}) {
      if (point->at[unknown] < 0.0 || point->at[unknown] > 1.0) return std::nullopt;
    }
    const double away = norm(plus(point->at, -1.0, sought));
    const bool is_accepted = away < 0.5 * step && dot(at.tangent, point->tangent) > least_cosine &&
                             is_same_contact(family_->orbits, at.image, point->image);
    if (!is_accepted) return std::nullopt;
    return Next{std::move(*point), is_beyond};
  }

  /// A motion just beyond the last orbit shows by its changes of contact why there is no further one.
  [[nodiscard]] BranchEnd why_lost(const CriticalPoint& at) const {
    const auto beyond = image_of(*family_, plus(at.at, 100.0 * least_curve_step, at.tangent));
    const bool changes = beyond && !is_same_contact(family_->orbits, at.image, *beyond);
    return changes ? BranchEnd::contact_change : BranchEnd::last_point;
  }

  const CriticalFamily* family_;
  const CurveQuestion* question_;
  base::StopRequest stop_;
};

class CurveSearch {
 public:
  CurveSearch(const CurveQuestion& question, const BranchStudy& study, base::StopRequest stop)
      : question_(&question), study_(&study), stop_(stop) {}

  [[nodiscard]] std::vector<BifurcationCurve> all() {
    for (std::size_t i = 0; i < study_->bifurcations.size(); ++i) follow(i);
    return std::move(curves_);
  }

 private:
  [[nodiscard]] PlaneUnknowns unknowns_at(const Bifurcation& one) const {
    const section::StrobePoint& point = one.orbit->points.front().point;
    return {point.tilt, point.tilt_rate, point.slip_rate, question_->ranges[0].share(one.value),
            question_->ranges[1].share(question_->second)};
  }

  void follow(std::size_t place) {
    const Bifurcation& one = study_->bifurcations[place];
    const OrbitBranch& branch = study_->branches[one.branch];
    if (!one.orbit) return;
    for (const CriticalOrbits& critical :
         critical_orbits(one.kind, {.period = branch.period, .is_symmetric = branch.is_symmetric})) {
      const CriticalFamily family{.conditions = &question_->conditions,
                                  .ranges = question_->ranges,
                                  .orbits = critical.orbits,
                                  .multiplier = critical.multiplier};
      const auto start = critical_near(family, unknowns_at(one), stop_);
      if (!start) continue;
      if (is_on_a_curve(one)) return;
      const CriticalTrace trace(family, *question_, stop_);
      TracedCriticalCurve up = trace.from(*start);
      TracedCriticalCurve down{.points = {}, .end = BranchEnd::closed};
      if (up.end != BranchEnd::closed) {
        CriticalPoint reversed = *start;
        reversed.tangent = plus({}, -1.0, reversed.tangent);
        down = trace.from(reversed);
      }
      BifurcationCurve curve{
          .bifurcation = place, .kind = one.kind, .orbits = family.orbits, .ends = {down.end, up.end}};
      std::ranges::reverse(down.points);
      for (const CriticalPoint& point : down.points) add(family, point, curve);
      add(family, *start, curve);
      for (const CriticalPoint& point : up.points) add(family, point, curve);
      curves_.push_back(std::move(curve));
      return;
    }
  }

  /// Whether a curve that was followed has crossed the second parameter's value at this bifurcation.
  [[nodiscard]] bool is_on_a_curve(const Bifurcation& one) const {
    const section::StrobePoint& at = one.orbit->points.front().point;
    for (const BifurcationCurve& curve : curves_) {
      if (curve.kind != one.kind) continue;
      for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
        const BifurcationPoint& a = curve.points[i];
        const BifurcationPoint& b = curve.points[i + 1];
        const double below = a.second_value - question_->second;
        const double above = b.second_value - question_->second;
        if (below * above > 0.0 || below == above) continue;
        const double value = a.value + below / (below - above) * (b.value - a.value);
        if (std::abs(question_->ranges[0].share(value) - question_->ranges[0].share(one.value)) > same_orbit) continue;
        if (is_near_the_cycle(a.orbit, at) || is_near_the_cycle(b.orbit, at)) return true;
      }
    }
    return false;
  }

  static bool is_near_the_cycle(const Orbit& orbit, const section::StrobePoint& at) {
    return std::ranges::any_of(orbit.points,
                               [&](const SectionState& state) { return distance(state.point, at) < 3.0 * same_orbit; });
  }

  /// Adds nothing where the motion ends within the second half of the period.
  void add(const CriticalFamily& family, const CriticalPoint& point, BifurcationCurve& curve) const {
    CriticalFamily whole = family;
    whole.orbits.is_symmetric = false;
    const auto image = family.orbits.is_symmetric ? image_of(whole, point.at) : std::optional(point.image);
    const section::StrobePoint state{.tilt = point.at[0], .tilt_rate = point.at[1], .slip_rate = point.at[2]};
    if (!image) return;
    BifurcationPoint& added = curve.points.emplace_back();
    added = {.value = question_->ranges[0].value(point.at[3]),
             .second_value = question_->ranges[1].value(point.at[4]),
             .orbit = orbit_through(state, *image, point.residual, FoundBy::continuation),
             .test = point.test};
    added.orbit.is_symmetric = family.orbits.is_symmetric;
  }

  const CurveQuestion* question_;
  const BranchStudy* study_;
  base::StopRequest stop_;
  std::vector<BifurcationCurve> curves_;
};

}  // namespace

std::vector<BifurcationCurve> bifurcation_curves(const CurveQuestion& question, const BranchStudy& study,
                                                 base::StopRequest stop) {
  return CurveSearch(question, study, stop).all();
}

}  // namespace rocking
