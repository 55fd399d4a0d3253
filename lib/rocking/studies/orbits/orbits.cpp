#include "rocking/studies/orbits/orbits.hpp"

#include <algorithm>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/realisation/continuation.hpp"
#include "rocking/realisation/fixed_point.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/scene/drawn_quantities.hpp"

namespace rocking {
namespace {

/// A run has come to its orbit when its last point is so close; later it comes closer. Orbits are known far more closely
/// (orbit.cpp), and different ones are farther apart, but for those next to a bifurcation where they meet.
constexpr double on_orbit = 1e-6;

/// Of two orbits in a list, each is the mirror image of the other, or they are one that is its own.
void set_mirror_images(std::vector<Orbit>& orbits, std::size_t one, std::size_t other) {
  orbits[one].mirror = other;
  orbits[other].mirror = one;
  orbits[one].is_symmetric = orbits[other].is_symmetric = one == other;
}

/// Collects the orbits of one condition.
class OrbitSearch {
 public:
  OrbitSearch(const Condition& condition, int longest, base::StopRequest stop)
      : condition_(&condition), map_(condition), longest_(longest), stop_(stop) {}

  [[nodiscard]] OrbitsOfCondition all() {
    search_from_run();
    search_from_grid();
    add_mirror_images();
    find_orbit_of_run();
    return std::move(found_);
  }

 private:
  void search_from_run() {
    Continuation continuation(random::Draws(0, 0), stop_);
    const RealisationResult result = continuation.run(*condition_);
    found_.termination = result.termination;
    found_.mode = result.classification.mode;
    if (result.termination != dynamics::Termination::reached_horizon) return;
    last_ = result.strobe.back();
    if (found_.mode.kind == section::ResponseKind::periodic) {
      search(*last_, found_.mode.periods, FoundBy::run);
    } else {
      search_all_periods(*last_, FoundBy::run);
    }
  }

  void search_from_grid() {
    // 9 x 9 starts. Theta' = 1 lifts a slender block from Theta = 0 to its balance, Theta = 1: motions that do not
    // overturn stay within about these limits.
    constexpr int steps = 4;
    constexpr double tilt_limit = 0.8;
    constexpr double rate_limit = 1.2;
    for (int i = -steps; i <= steps; ++i) {
      for (int j = -steps; j <= steps; ++j) {
        section::StrobePoint start{.tilt = tilt_limit * i / steps, .tilt_rate = rate_limit * j / steps};
        if (condition_->scene.friction) {
          const auto image = map_.image(start, 1);
          if (!image) continue;
          start = image->end();
        }
        search_all_periods(start, FoundBy::grid);
      }
    }
  }

  void search_all_periods(const section::StrobePoint& start, FoundBy found_by) {
    for (int periods = 1; periods <= longest_; ++periods) search(start, periods, found_by);
  }

  void search(const section::StrobePoint& start, int periods, FoundBy found_by) {
    stop_.check();
    ++found_.searches;
    auto fixed = find_fixed_point(map_, start, periods, stop_);
    if (!fixed) return;
    auto orbit = orbit_of(map_, std::move(*fixed), found_by, stop_);
    if (!orbit) return;
    ++found_.converged;
    if (place_of(orbit->points, found_.orbits)) return;
    orbit->is_symmetric = map_.has_mirror_symmetry();
    if (orbit->is_symmetric) orbit->mirror = found_.orbits.size();
    found_.orbits.push_back(std::move(*orbit));
  }

  void add_mirror_images() {
    for (std::size_t i = 0; i < found_.orbits.size(); ++i) {
      const auto mirror = mirror_image_of(map_, found_.orbits[i]);
      if (!mirror) continue;
      if (!place_of(*mirror, found_.orbits)) search(mirror->front().point, found_.orbits[i].period, FoundBy::mirror);
      if (const auto place = place_of(*mirror, found_.orbits)) set_mirror_images(found_.orbits, i, *place);
    }
  }

  void find_orbit_of_run() {
    if (!last_) return;
    for (std::size_t i = 0; i < found_.orbits.size(); ++i) {
      const Orbit& orbit = found_.orbits[i];
      const bool is_on = std::ranges::any_of(
          orbit.points, [this](const SectionState& state) { return distance(state.point, *last_) < on_orbit; });
      if (is_on && orbit.stability.is_stable()) found_.run_on = i;
    }
  }

  const Condition* condition_;
  PoincareMap map_;
  int longest_;
  base::StopRequest stop_;
  OrbitsOfCondition found_;
  std::optional<section::StrobePoint> last_;  ///< strobe point of the run
};

}  // namespace

std::size_t add_orbit(OrbitsOfCondition& found, const PoincareMap& map, Orbit orbit, base::StopRequest stop) {
  if (const auto place = place_of(orbit.points, found.orbits)) return *place;
  const std::size_t place = found.orbits.size();
  orbit.is_symmetric = map.has_mirror_symmetry();
  if (orbit.is_symmetric) orbit.mirror = place;
  const FoundBy found_by = orbit.found_by;
  const auto mirror = mirror_image_of(map, orbit);
  found.orbits.push_back(std::move(orbit));
  if (!mirror) return place;
  auto other = place_of(*mirror, found.orbits);
  if (!other) {
    auto fixed = find_fixed_point(map, mirror->front().point, static_cast<int>(mirror->size()), stop);
    auto image = fixed ? orbit_of(map, std::move(*fixed), found_by, stop) : std::nullopt;
    if (!image || !is_same_cycle(image->points, *mirror)) return place;
    other = found.orbits.size();
    image->mirror = *other;
    found.orbits.push_back(std::move(*image));
  }
  set_mirror_images(found.orbits, place, *other);
  return place;
}

OrbitsOfCondition orbits_of(const Condition& condition, int longest, base::StopRequest stop) {
  check_condition(condition);
  return OrbitSearch(condition, longest, stop).all();
}

void check_orbits(const Experiment& experiment) {
  for (const Condition& condition : experiment.conditions) {
    if (!is_periodic(condition.scene.excitation)) {
      throw base::InputError({"/excitation/kind", '"' + std::string(name_of(condition.scene.excitation)) + '"',
                              "does not repeat: it has no periodic orbits", "give a harmonic excitation"});
    }
    if (vertical_of(condition.scene.excitation) != nullptr && periods_of_base(condition.scene) != 1) {
      throw base::InputError({"/excitation/vertical", "",
                              "does not repeat once an excitation period: the map from one strobe point to the next "
                              "would be another one each time",
                              "give a whole multiple of the horizontal frequency"});
    }
    if (const auto place = place_of_randomness(condition.scene)) {
      throw base::InputError({std::string(*place), "",
                              "is random: only a motion in which nothing is random has periodic orbits",
                              "give a number, or leave out `fluctuation`"});
    }
  }
}

}  // namespace rocking
