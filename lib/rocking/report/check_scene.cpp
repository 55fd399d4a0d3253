#include "rocking/report/check_scene.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string>
#include <string_view>

#include "rocking/report/read_quantity.hpp"
#include "rocking/report/text_table.hpp"

namespace rocking::report {
namespace {

std::string shown(double number) { return significant(number, 6); }

/// No draw of the sampler lies farther from the mean, in standard deviations: Box and Muller's radius of the smallest
/// uniform number, 2^-53, is sqrt(-2 ln 2^-53) = 8.572.
constexpr double largest_normal_draw = 8.6;

class SceneChecker {
 public:
  SceneChecker(const experiment::Scene& scene, const Json& document, Problems& problems)
      : scene_(scene), document_(document), problems_(problems) {}

  void check() {
    if (sound({"/friction"})) check_order_of_friction();
    if (sound({"/friction", "/block", "/slide_inertia", "/formulation"})) check_painleve();
    if (sound({"/block", "/initial/tilt"})) check_tilt();
    if (sound({"/initial/slip_rate"})) check_slip_rate();
  }

 private:
  [[nodiscard]] bool sound(std::initializer_list<std::string_view> places) const {
    return std::none_of(problems_.begin(), problems_.end(), [places](const base::Problem& problem) {
      return std::any_of(places.begin(), places.end(), [&problem](std::string_view place) {
        return problem.place == place || problem.place.starts_with(std::string(place) + '/');
      });
    });
  }

  void reject(std::string_view pointer, std::string reason, std::string remedy) {
    const Json::json_pointer place{std::string(pointer)};
    const std::string value = document_.contains(place) ? brief(document_.at(place)) : "";
    problems_.push_back({std::string(pointer), value, std::move(reason), std::move(remedy)});
  }

  void check_order_of_friction() {
    if (!scene_.friction) return;
    const auto [at_rest, sliding] = *scene_.friction;
    if (at_rest >= sliding) return;
    reject("/friction/static",
           "is below the kinetic coefficient, " + shown(sliding) + ", so that the onset of sliding is not consistent",
           "give at least " + shown(sliding) + ", or lower \"kinetic\"");
  }

  void check_painleve() {
    if (!scene_.friction) return;
    const double limit = painleve_friction(dynamics::geometry_of(scene_.block), scene_.slide_inertia);
    if (scene_.friction->kinetic_coefficient < limit) return;
    reject("/friction/kinetic", "is so large that the equations of sliding have no valid solution (Painleve's paradox)",
           "give less than " + shown(limit) + " for this block and formulation");
  }

  void check_tilt() {
    const double psi = dynamics::geometry_of(scene_.block).shape_angle;
    const double overturned = 0.5 * std::numbers::pi / psi;
    double largest = std::abs(mean_of(scene_.initial.tilt));
    if (const auto* uniform = std::get_if<experiment::Uniform>(&scene_.initial.tilt)) {
      largest = std::max(std::abs(uniform->low), std::abs(uniform->high));
    }
    if (const auto* normal = std::get_if<experiment::Normal>(&scene_.initial.tilt)) {
      largest += largest_normal_draw * normal->sigma;
    }
    if (largest < overturned) return;
    reject("/initial/tilt",
           "reaches the tilt of an overturned block: abs(tilt) must be below pi/2/psi = " + shown(overturned),
           "give a smaller tilt, in units of the shape angle");
  }

  void check_slip_rate() {
    const auto* number = std::get_if<double>(&scene_.initial.slip_rate);
    if (scene_.friction || (number != nullptr && *number == 0.0)) return;
    reject("/initial/slip_rate", "the block cannot slide, because the file has no friction",
           "add \"friction\": {\"static\": 0.35, \"kinetic\": 0.30}, or remove the slip rate");
  }

  const experiment::Scene& scene_;
  const Json& document_;
  Problems& problems_;
};

}  // namespace

double painleve_friction(const dynamics::Geometry& geometry, dynamics::SlideInertia inertia) {
  const double twice = 2.0 * dynamics::inertia_ratio(inertia) + 1.0;
  const double in_motion = std::sqrt(twice * twice - 1.0);
  const double in_impact = (1.0 / 3.0 + geometry.sine * geometry.sine) / (geometry.sine * geometry.cosine);
  return std::min(in_motion, in_impact);
}

void check_scene(const experiment::Scene& scene, const Json& document, Problems& problems) {
  SceneChecker(scene, document, problems).check();
}

}  // namespace rocking::report
