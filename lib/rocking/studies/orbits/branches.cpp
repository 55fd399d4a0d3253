#include "rocking/studies/orbits/orbits.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <map>
#include <utility>

#include "rocking/realisation/fixed_point.hpp"
#include "rocking/section/classification.hpp"
#include "rocking/studies/orbits/fold_and_flip.hpp"
#include "rocking/studies/orbits/trace.hpp"

namespace rocking {
namespace {

/// Two findings of one bifurcation, from the two families that meet there. Each is located to 1e-9 (passage.cpp); the
/// orbits of the family that branches off differ by the root of the distance of the parameter: 3e-3 at 1e-5, times a
/// number of order 1.
constexpr double same_parameter = 1e-5;
constexpr double same_state = 1e-2;

/// Distance up to which two grazing orbits of a branch at one value of the parameter are one: the orbits listed are beside
/// the grazing, one that reaches the guard at a rate of 1e-6.
constexpr double grazing_state = 1e-5;

/// Largest distance of a multiplier from that of a bifurcation, within a bracket of 1e-9. Next to a grazing at a rate r a
/// multiplier changes by the width over r^3, 0.1 at r = 2e-3; no equation is solved there. Where test functions jump, it
/// was above 0.4.
constexpr double nearly_critical = 0.1;

/// Distances x along the critical direction at which a branch that begins is sought. Its parameter differs by about x^2
/// from that of the bifurcation: 1e-4 for the first one, which is more than `same_parameter`. A shorter one is tried for
/// a branch that is sharply bent or changes its contact nearby, a longer one where Newton's method falls back.
constexpr std::array switch_distances{0.01, 0.003, 0.03, 0.001};

/// Follows all branches of a question.
class BranchSearch {
 public:
  BranchSearch(const BranchQuestion& question, std::vector<OrbitsOfCondition>& found, base::StopRequest stop)
      : question_(&question), found_(&found), stop_(stop) {
    for (const double value : question.values) wanted_.push_back(question.range.share(value));
    for (const OrbitsOfCondition& condition : found) branch_of_.emplace_back(condition.orbits.size());
  }

  [[nodiscard]] BranchStudy all() {
    for (std::size_t c = 0; c < found_->size(); ++c) {
      if (!is_in_range(wanted_[c])) continue;
      for (std::size_t k = 0; k < (*found_)[c].orbits.size(); ++k) {
        if (branch_of_[c][k]) continue;
        if (is_full()) return std::move(study_);
        follow(c, k);
        follow_switches();
      }
    }
    return std::move(study_);
  }

 private:
  /// A branch that begins at a bifurcation.
  struct Switch {
    std::size_t bifurcation;
    OrbitFamily orbits;
    CurvePoint point;
    std::array<double, 3> direction;
  };

  static bool is_in_range(double q) { return q >= 0.0 && q <= 1.0; }

  bool is_full() {
    study_.is_complete = study_.branches.size() < question_->most_branches;
    return !study_.is_complete;
  }

  [[nodiscard]] MapFamily family(const OrbitFamily& orbits) const {
    return {question_->conditions, question_->range, orbits};
  }

  [[nodiscard]] TraceLimits limits(const MapFamily& family) {
    const auto is_known = [this, &family](const CurvePoint& point) {
      const std::size_t c = condition_at(point.at[3]);
      const auto place = orbit_at(c, family, point);
      return place && branch_of_[c][*place] && *branch_of_[c][*place] != study_.branches.size();
    };
    return {.wanted = wanted_,
            .most_points = question_->most_points,
            .is_known = is_known,
            .on_point = question_->on_point};
  }

  [[nodiscard]] std::size_t condition_at(double q) const {
    return static_cast<std::size_t>(std::ranges::find(wanted_, q) - wanted_.begin());
  }

  /// Place of the orbit through a point among those of a condition, to which it is added.
  std::optional<std::size_t> orbit_at(std::size_t condition, const MapFamily& family, const CurvePoint& point) {
    const auto asked = question_->conditions(question_->values[condition]);
    if (!asked) return std::nullopt;
    const PoincareMap map(*asked);
    auto fixed = find_fixed_point(map, state_of(point.at), family.orbits().period, stop_);
    if (!fixed) return std::nullopt;
    auto orbit = orbit_of(map, std::move(*fixed), FoundBy::continuation, stop_);
    if (!orbit) return std::nullopt;
    const std::size_t place = add_orbit((*found_)[condition], map, std::move(*orbit), stop_);
    branch_of_[condition].resize((*found_)[condition].orbits.size());
    return place;
  }

  /// Follows the orbit of a condition in both directions.
  void follow(std::size_t condition, std::size_t place) {
    const Orbit orbit = (*found_)[condition].orbits[place];
    if (orbit.stability.kind == OrbitKind::not_differentiable || orbit.period > section::longest_period) return;
    const MapFamily orbits = family({.period = orbit.period, .is_symmetric = is_symmetric(condition, orbit)});
    const auto start = correct(
        orbits,
        {.normal = {0.0, 0.0, 0.0, 1.0}, .through = unknowns_of(orbit.points.front().point, wanted_[condition])},
        stop_);
    if (!start) return;
    const TraceLimits limits = this->limits(orbits);
    TracedCurve up = trace_curve(orbits, *start, limits, stop_);
    TracedCurve down;
    if (up.end != BranchEnd::closed) {
      CurvePoint reversed = *start;
      reversed.tangent = plus({}, -1.0, reversed.tangent);
      down = trace_curve(orbits, reversed, limits, stop_);
    } else {
      down.end = BranchEnd::closed;
    }
    std::ranges::reverse(down.points);
    std::ranges::reverse(down.bifurcations);
    std::vector<CurvePoint> points = std::move(down.points);
    points.push_back(*start);
    std::ranges::move(up.points, std::back_inserter(points));
    std::vector<LocatedBifurcation> bifurcations = std::move(down.bifurcations);
    std::ranges::move(up.bifurcations, std::back_inserter(bifurcations));
    branch_of_[condition][place] = study_.branches.size();
    add(orbits, std::move(points), std::move(bifurcations), {.ends = {down.end, up.end}});
  }

  [[nodiscard]] bool is_symmetric(std::size_t condition, const Orbit& orbit) const {
    const auto asked = question_->conditions(question_->values[condition]);
    const auto mirror = asked ? mirror_image_of(PoincareMap(*asked), orbit) : std::nullopt;
    return orbit.period % 2 == 1 && mirror && is_same_cycle(*mirror, orbit.points);
  }

  void add(const MapFamily& orbits, std::vector<CurvePoint> points, std::vector<LocatedBifurcation> bifurcations,
           OrbitBranch branch) {
    const std::size_t place = study_.branches.size();
    branch.period = orbits.orbits().period;
    branch.is_symmetric = orbits.orbits().is_symmetric;
    for (const CurvePoint& point : points) {
      if (auto orbit = whole_orbit(orbits, point)) {
        branch.points.push_back({.value = value_at(point), .orbit = std::move(*orbit)});
      }
      const std::size_t c = condition_at(point.at[3]);
      if (c < wanted_.size()) mark(c, orbits, point, place);
    }
    study_.branches.push_back(std::move(branch));
    for (LocatedBifurcation& bifurcation : bifurcations) add(orbits, std::move(bifurcation), place);
  }

  void mark(std::size_t condition, const MapFamily& orbits, const CurvePoint& point, std::size_t branch) {
    const auto place = orbit_at(condition, orbits, point);
    if (!place) return;
    const auto mirror = (*found_)[condition].orbits[*place].mirror;
    for (const std::size_t one : {*place, mirror.value_or(*place)}) {
      if (!branch_of_[condition][one]) branch_of_[condition][one] = branch;
    }
  }

  /// Of the parameter.
  [[nodiscard]] double value_at(const CurvePoint& point) const {
    const std::size_t c = condition_at(point.at[3]);
    return c < wanted_.size() ? question_->values[c] : question_->range.value(point.at[3]);
  }

  /// Absent where the motion ends within the second half of the period.
  [[nodiscard]] static std::optional<Orbit> whole_orbit(const MapFamily& orbits, const CurvePoint& point) {
    const bool is_symmetric = orbits.orbits().is_symmetric;
    const auto image = is_symmetric ? orbits.full_image(point.at) : std::optional(point.image);
    if (!image) return std::nullopt;
    Orbit orbit = orbit_through(state_of(point.at), *image, point.residual, FoundBy::continuation);
    orbit.is_symmetric = is_symmetric;
    return orbit;
  }

  /// Locates a bifurcation by its critical multiplier; false where there is none near. Next to it the orbits that branch
  /// off, and their test functions, are known less well than those that go on.
  bool solve(const MapFamily& orbits, LocatedBifurcation& located) const {
    if (located.kind == BifurcationKind::grazing || located.kind == BifurcationKind::contact_change) return true;
    for (const CriticalOrbits& critical : critical_orbits(located.kind, orbits.orbits())) {
      const MapFamily family(question_->conditions, question_->range, critical.orbits);
      const auto found = critical_near(family, critical.multiplier, located.point.at, stop_);
      if (!found || !is_in_range(found->at[3])) continue;
      const Unknowns& at = found->at;
      auto image = orbits.image(at);
      if (!image) continue;
      located.point.residual = distance(image->end(), state_of(at));
      located.point.at = at;
      located.point.image = std::move(*image);
      located.share = at[3];
      located.error = found->error;
      return true;
    }
    return false;
  }

  /// Whether the orbit of a bracket has nearly the critical multiplier: where it has not, the test function jumps at a
  /// change of contact, or the curve has a corner there.
  static bool is_nearly_critical(const LocatedBifurcation& located) {
    const bool is_pair = located.kind == BifurcationKind::neimark_sacker;
    const double critical = located.kind == BifurcationKind::fold ? 1.0 : -1.0;
    return std::ranges::any_of(stability_of(located.point.image).multipliers, [=](const auto& multiplier) {
      if (is_pair) return multiplier.imag() != 0.0 && std::abs(std::abs(multiplier) - 1.0) < nearly_critical;
      return std::abs(multiplier - critical) < nearly_critical;
    });
  }

  /// Of the parameter; at least some units in its last place.
  [[nodiscard]] double error_of(const LocatedBifurcation& located) const {
    const ParameterRange& range = question_->range;
    return std::max(located.error * (range.high - range.low), 1e-12 * std::abs(range.value(located.share)));
  }

  void add(const MapFamily& orbits, LocatedBifurcation located, std::size_t branch) {
    const bool branches_off =
        located.kind == BifurcationKind::period_doubling || located.kind == BifurcationKind::symmetry_breaking;
    const bool is_parent = orbits.orbits().is_symmetric || !is_own_joint(orbits, located);
    if (!solve(orbits, located) && ((branches_off && !is_parent) || !is_nearly_critical(located))) return;
    Bifurcation bifurcation{.kind = located.kind,
                            .value = question_->range.value(located.share),
                            .error = error_of(located),
                            .branch = branch,
                            .orbit = whole_orbit(orbits, located.point)};
    if (located.kind == BifurcationKind::grazing && is_listed(bifurcation)) return;
    if (branches_off) {
      if (const auto known = known_bifurcation(bifurcation)) {
        // The test function of the family that goes on locates it better than that of the one that ends.
        if (is_parent && bifurcation.error <= (*known)->error) **known = std::move(bifurcation);
        return;
      }
    }
    study_.bifurcations.push_back(std::move(bifurcation));
    if (!branches_off || !is_parent) return;
    const OrbitFamily child{.period = located.kind == BifurcationKind::period_doubling ? 2 * orbits.orbits().period
                                                                                       : orbits.orbits().period,
                            .is_symmetric = false};
    if (child.period > section::longest_period) return;
    const auto direction = flip_direction(located.point.image.derivative);
    switches_.push_back({study_.bifurcations.size() - 1, child, std::move(located.point), direction});
  }

  /// Whether the branch has this grazing already: a step behind it, the branch may end at it again.
  [[nodiscard]] bool is_listed(const Bifurcation& grazing) const {
    return std::ranges::any_of(study_.bifurcations, [&](const Bifurcation& other) {
      return other.kind == grazing.kind && other.branch == grazing.branch &&
             std::abs(other.value - grazing.value) <= 2.0 * (other.error + grazing.error) &&
             is_same_point(other.orbit, grazing.orbit);
    });
  }
  static bool is_same_point(const std::optional<Orbit>& a, const std::optional<Orbit>& b) {
    return a && b && distance(a->points.front().point, b->points.front().point) < grazing_state;
  }

  /// Whether the family ends there: its orbits become those of half the period, or symmetric.
  static bool is_own_joint(const MapFamily& orbits, const LocatedBifurcation& located) {
    if (located.kind == BifurcationKind::symmetry_breaking) return true;
    const auto& asymmetry = located.point.asymmetry;
    return orbits.orbits().period % 2 == 0 && asymmetry && distance(*asymmetry, {}) < same_state;
  }

  [[nodiscard]] std::optional<Bifurcation*> known_bifurcation(const Bifurcation& one) {
    if (!one.orbit) return std::nullopt;
    const section::StrobePoint& point = one.orbit->points.front().point;
    for (Bifurcation& other : study_.bifurcations) {
      if (other.kind != one.kind || !other.orbit) continue;
      const double range = question_->range.high - question_->range.low;
      if (std::abs(other.value - one.value) > same_parameter * range) continue;
      const auto is_near = [&point](const SectionState& state) { return distance(state.point, point) < same_state; };
      if (std::ranges::any_of(other.orbit->points, is_near)) return &other;
    }
    return std::nullopt;
  }

  void follow_switches() {
    while (!switches_.empty() && !is_full()) {
      const Switch one = std::move(switches_.front());
      switches_.pop_front();
      const MapFamily orbits = family(one.orbits);
      for (const double far : switch_distances) {
        if (const auto start = start_of(one, orbits, far)) {
          follow_from(one, orbits, *start);
          break;
        }
      }
    }
  }

  /// An orbit of the branch that begins, at a distance in the critical direction; its tangent points away.
  [[nodiscard]] std::optional<CurvePoint> start_of(const Switch& one, const MapFamily& orbits, double far) const {
    const auto& [tilt, rate, slip] = one.direction;
    const Unknowns normal{tilt, rate, slip, 0.0};
    const Unknowns through = plus(one.point.at, far, normal);
    auto start = correct(orbits, {.normal = normal, .through = through}, stop_);
    if (!start || !start->asymmetry || !is_in_range(start->at[3])) return std::nullopt;
    if (distance(*start->asymmetry, {}) < 0.1 * far) return std::nullopt;  // still the orbits that it branches off from
    if (norm(plus(start->at, -1.0, through)) > 10.0 * far) return std::nullopt;
    return start;
  }

  void follow_from(const Switch& one, const MapFamily& orbits, const CurvePoint& start) {
    TracedCurve curve = trace_curve(orbits, start, limits(orbits), stop_);
    if (curve.end == BranchEnd::known && curve.points.size() < 2) return;
    std::vector<CurvePoint> points{start};
    std::ranges::move(curve.points, std::back_inserter(points));
    add(orbits, std::move(points), std::move(curve.bifurcations),
        {.ends = {BranchEnd::joins, curve.end}, .from = one.bifurcation});
  }

  const BranchQuestion* question_;
  std::vector<OrbitsOfCondition>* found_;
  base::StopRequest stop_;
  std::vector<double> wanted_;                                      ///< shares of the range, of the conditions
  std::vector<std::vector<std::optional<std::size_t>>> branch_of_;  ///< by condition and orbit
  std::deque<Switch> switches_;
  BranchStudy study_;
};

}  // namespace

int cycles_of(const OrbitBranch& branch) {
  std::map<int, std::size_t> orbits;
  for (const BranchPoint& point : branch.points) ++orbits[point.orbit.cycles];
  std::pair<int, std::size_t> most{};
  for (const auto& [cycles, count] : orbits) {
    if (count > most.second) most = {cycles, count};
  }
  return most.first;
}

bool can_be_continued(std::string_view pointer) {
  constexpr std::array<std::string_view, 4> parts{"/block", "/excitation/", "/friction/", "/restitution"};
  return std::ranges::any_of(parts, [&](std::string_view part) { return pointer.starts_with(part); }) &&
         !pointer.starts_with("/excitation/vertical/");
}

BranchStudy branches_of(const BranchQuestion& question, std::vector<OrbitsOfCondition>& found, base::StopRequest stop) {
  return BranchSearch(question, found, stop).all();
}

}  // namespace rocking
