#include "rocking/experiment/check_condition.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "rocking/base/error.hpp"

namespace rocking::experiment {
namespace {

class ConditionChecker {
 public:
  explicit ConditionChecker(const Condition& condition) : condition_(condition), scene_(condition.scene) {}

  [[nodiscard]] std::vector<base::Problem> check() {
    check_block();
    const Excitation& excitation = scene_.excitation;
    finite("/restitution", scene_.restitution);
    std::visit([this](const auto& kind) { check_numbers(kind); }, excitation);
    // A period must be a number, also in units of its smallest parts.
    const double frequency = frequency_ratio(excitation);
    positive("/excitation/frequency_ratio", frequency, 0x1p-60 / frequency);
    if (scene_.friction) {
      not_negative("/friction/static", scene_.friction->static_coefficient);
      not_negative("/friction/kinetic", scene_.friction->kinetic_coefficient);
    }
    check_fluctuation();
    finite("/initial/tilt", scene_.initial.tilt);
    finite("/initial/tilt_rate", scene_.initial.tilt_rate);
    finite("/initial/slip_rate", scene_.initial.slip_rate);
    positive("/accuracy/tolerance", condition_.tolerance, condition_.tolerance);
    return std::move(problems_);
  }

 private:
  void reject(std::string place, double value, std::string reason, std::string remedy) {
    problems_.push_back({std::move(place), std::to_string(value), std::move(reason), std::move(remedy)});
  }

  void finite(const char* place, double value) {
    if (!std::isfinite(value)) reject(place, value, "is not a finite number", "give one");
  }

  void finite(const char* place, const Quantity& quantity) {
    if (const auto* number = std::get_if<double>(&quantity)) return finite(place, *number);
    const auto* uniform = std::get_if<Uniform>(&quantity);
    const auto [first, second] = uniform != nullptr
                                     ? std::pair(uniform->low, uniform->high)
                                     : std::pair(std::get<Normal>(quantity).mean, std::get<Normal>(quantity).sigma);
    finite(place, first);
    finite(place, second);
  }

  void not_negative(const char* place, double value) {
    if (!(value >= 0.0) || !std::isfinite(value)) reject(place, value, "is not a number of at least 0", "give one");
  }

  /// `derived`: what is worked out of it.
  void positive(const char* place, double value, double derived) {
    if (value > 0.0 && std::isnormal(value) && std::isnormal(derived)) return;
    reject(place, value, "is not a positive number within the range of the computation", "give one nearer to 1");
  }

  void check_block() {
    const dynamics::Block& block = scene_.block;
    positive("/block/width_m", block.width, block.width);
    positive("/block/height_m", block.height, block.height);
    positive("/block/gravity_m_s2", block.gravity, block.gravity);
    if (!problems_.empty()) return;
    const dynamics::Geometry geometry = dynamics::geometry_of(block);
    positive("/block", geometry.half_diagonal, geometry.frequency_parameter);
    positive("/block", geometry.shape_angle, geometry.sine * geometry.cosine);
  }

  template <class Kind>
  void check_numbers(const Kind& kind) {
    kind.check([this](const char* place, const auto& value) { this->finite(place, value); });
  }

  void check_fluctuation() {
    const Fluctuation& sigma = scene_.fluctuation;
    not_negative("/fluctuation/static_friction/sigma", sigma.static_friction);
    not_negative("/fluctuation/kinetic_friction/sigma", sigma.kinetic_friction);
    not_negative("/fluctuation/restitution/sigma", sigma.restitution);
    not_negative("/fluctuation/amplitude/sigma", sigma.amplitude);
    if (sigma.refreshes_per_period >= 1) return;
    reject("/fluctuation/friction/refreshes_per_period", sigma.refreshes_per_period, "is below 1", "give 200");
  }

  const Condition& condition_;
  const Scene& scene_;
  std::vector<base::Problem> problems_;
};

}  // namespace

void check_condition(const Condition& condition) {
  std::vector<base::Problem> problems = ConditionChecker(condition).check();
  if (!problems.empty()) throw base::InputError(std::move(problems));
}

}  // namespace rocking::experiment
