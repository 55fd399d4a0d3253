#include "rocking/studies/orbits/trace.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "rocking/realisation/fixed_point.hpp"

namespace rocking {
namespace {

/// A thousand times the residual that is left: a shorter step does not leave the orbit from which it starts.
constexpr double least_step = 1e-10;
/// Below it the tangent may jump at a change of contact: a smooth curve with such an angle would have a curvature of
/// 4.5e4. Forty successive steps below it, 4e-4 in all, lead nowhere.
constexpr double kink_step = 1e-5;
constexpr double crawling_step = kink_step;
constexpr int most_crawls = 40;
/// Below it an orbit is one of the family from which its own branches off: two orbits that differ by rounding, 1e-13, over
/// a distance of the multipliers from 1 of 1e-6.
constexpr double least_asymmetry = 1e-7;
/// Of a grazing behind which the curve cannot be followed: below what forty steps that lead nowhere may cover.
constexpr double just_behind = 4e-4;
/// Of the motion that shows why a curve ends: ten times the last step. The curve leaves its tangent there by 1e-18 times
/// its curvature, which is at most 4.5e4: less than rounding.
constexpr double cause_distance = 1e-9;

class CurveTrace {
 public:
  CurveTrace(const MapFamily& family, const TraceLimits& limits, base::StopRequest stop)
      : family_(&family), limits_(&limits), stop_(stop) {}

  [[nodiscard]] TracedCurve from(const CurvePoint& start) {
    CurvePoint at = start;
    double step = first_step;
    while (true) {
      if (curve_.points.size() >= limits_->most_points) return ended(BranchEnd::points);
      auto next = step_from(at, step);
      const Passage passage = next ? passage_between(at, next->point, *family_, limits_->wanted, stop_) : Passage{};
      if (!next || passage.is_broken) {
        step *= 0.5;
        if (step < least_step) return ended(why_lost(start, at));
        continue;
      }
      crawls_ = step < crawling_step ? crawls_ + 1 : 0;
      if (crawls_ > most_crawls) return ended(why_lost(start, at));
      const bool is_last = next->is_at_end;
      const bool closes = curve_.points.size() > 3 && comes_back(start, at, next->point);
      if (const auto end = advance(passage)) return ended(*end);
      if (is_last) return ended(BranchEnd::range);
      if (closes) return ended(BranchEnd::closed);
      if (next->point.steps <= few_newton_steps) step = std::min(1.5 * step, largest_step);
      at = std::move(next->point);
    }
  }

 private:
  struct Next {
    CurvePoint point;
    bool is_at_end = false;
  };

  TracedCurve ended(BranchEnd end) {
    curve_.end = end;
    return std::move(curve_);
  }

  [[nodiscard]] std::optional<Next> step_from(const CurvePoint& at, double step) const {
    Unknowns sought = plus(at.at, step, at.tangent);
    Unknowns normal = at.tangent;
    const bool is_beyond = sought[3] < 0.0 || sought[3] > 1.0;
    if (is_beyond) {
      const double end = sought[3] < 0.0 ? 0.0 : 1.0;
      sought = plus(at.at, (end - at.at[3]) / at.tangent[3], at.tangent);
      sought[3] = end;
      normal = {0.0, 0.0, 0.0, at.tangent[3] > 0.0 ? 1.0 : -1.0};
    }
    sought = with_slip_ended(at, sought);
    auto point = correct(*family_, {.normal = normal, .through = sought}, stop_);
    if (!point || !is_accepted(at, *point, sought, step)) return std::nullopt;
    if (is_beyond) point->at[3] = sought[3];
    return Next{std::move(*point), is_beyond};
  }

  [[nodiscard]] bool is_accepted(const CurvePoint& at, const CurvePoint& point, const Unknowns& sought,
                                 double step) const {
    if (point.at[3] < 0.0 || point.at[3] > 1.0) return false;
    if (point.asymmetry && distance(*point.asymmetry, {}) < least_asymmetry) return false;
    const double away = norm(plus(point.at, -1.0, sought));
    if (away < 0.5 * step && dot(at.tangent, point.tangent) > least_cosine) return true;
    const bool changes =
        at.image.contact != point.image.contact || !is_same_contact(family_->orbits(), at.image, point.image);
    return step < kink_step && away < 20.0 * step && changes;
  }

  /// Adds what lies up to the next point; returns why the curve ends there, if it does.
  std::optional<BranchEnd> advance(const Passage& passage) {
    std::ranges::copy(passage.bifurcations, std::back_inserter(curve_.bifurcations));
    for (const CurvePoint& point : passage.points) {
      const bool is_wanted = std::ranges::find(limits_->wanted, point.at[3]) != limits_->wanted.end();
      if (is_wanted && limits_->is_known && limits_->is_known(point)) return BranchEnd::known;
      curve_.points.push_back(point);
      if (limits_->on_point) limits_->on_point();
    }
    return passage.is_joined ? std::optional(BranchEnd::joins) : std::nullopt;
  }

  /// A grazing next to the last orbits, or a change of contact just beyond the last one, shows why there is none further.
  BranchEnd why_lost(const CurvePoint& start, const CurvePoint& at) {
    std::vector<CurvePoint> last{start};
    std::ranges::copy(curve_.points, std::back_inserter(last));
    if (auto grazing = graze(*family_, last, stop_)) {
      curve_.bifurcations.push_back({.kind = BifurcationKind::grazing,
                                     .point = std::move(grazing->beside),
                                     .share = grazing->share,
                                     .error = grazing->error});
      return BranchEnd::grazing;
    }
    if (has_just_grazed(at)) return BranchEnd::grazing;
    for (double away = least_step; away <= cause_distance; away *= 2.0) {
      const auto beyond = family_->image(with_slip_ended(at, plus(at.at, away, at.tangent)));
      if (!beyond || is_same_contact(family_->orbits(), at.image, *beyond)) continue;
      curve_.bifurcations.push_back({.kind = BifurcationKind::contact_change,
                                     .point = at,
                                     .share = at.at[3],
                                     .error = away * std::abs(at.tangent[3]) + at.error});
      return BranchEnd::contact_change;
    }
    return BranchEnd::last_point;
  }

  /// Where the slip ends on the section, the orbits beyond have none there; a slip in the other direction is no motion
  /// beside them.
  static Unknowns with_slip_ended(const CurvePoint& at, Unknowns beyond) {
    if (at.at[2] * beyond[2] < 0.0) beyond[2] = 0.0;
    return beyond;
  }

  /// Whether the curve has passed a grazing next to its last point, behind which it cannot be followed.
  [[nodiscard]] bool has_just_grazed(const CurvePoint& at) const {
    if (curve_.bifurcations.empty()) return false;
    const LocatedBifurcation& last = curve_.bifurcations.back();
    return last.kind == BifurcationKind::grazing && norm(plus(last.point.at, -1.0, at.at)) < just_behind;
  }

  const MapFamily* family_;
  const TraceLimits* limits_;
  base::StopRequest stop_;
  TracedCurve curve_;
  int crawls_ = 0;
};

}  // namespace

TracedCurve trace_curve(const MapFamily& family, const CurvePoint& start, const TraceLimits& limits,
                        base::StopRequest stop) {
  return CurveTrace(family, limits, stop).from(start);
}

}  // namespace rocking
