#include "rocking/scene/check_hazard.hpp"

#include <cmath>
#include <cstddef>
#include <string>

#include "rocking/base/number_text.hpp"

namespace rocking {

std::optional<HazardFault> fault_of(const HazardPoint& point, const HazardPoint* before) {
  constexpr auto intensity = &HazardPoint::intensity;
  constexpr auto rate = &HazardPoint::rate;
  const auto is_positive = [](double number) { return number > 0.0 && std::isfinite(number); };
  if (!is_positive(point.intensity)) return HazardFault{intensity, "must be positive", "give an intensity above 0"};
  if (!is_positive(point.rate)) return HazardFault{rate, "must be positive", "give a rate above 0, or omit the line"};
  if (before == nullptr) return std::nullopt;
  if (!(point.intensity > before->intensity)) {
    return HazardFault{intensity, "is not above the intensity before it", "sort the lines by growing intensity"};
  }
  if (!(point.rate < before->rate)) {
    return HazardFault{rate, "is not below the rate before it: a stronger intensity is exceeded less often",
                       "give rates of exceedance per year, which fall with the intensity"};
  }
  return std::nullopt;
}

std::vector<base::Problem> problems_of(const HazardCurve& hazard) {
  std::vector<base::Problem> problems;
  const HazardPoint* before = nullptr;
  for (const HazardPoint& point : hazard.points) {
    if (const auto fault = fault_of(point, before)) {
      const std::string place = "hazard/points/" + std::to_string(&point - hazard.points.data());
      const bool is_rate = fault->number == &HazardPoint::rate;
      problems.push_back({place + (is_rate ? "/rate" : "/intensity"), base::shortest(point.*(fault->number)),
                          fault->reason, fault->remedy});
    }
    before = &point;
  }
  if (hazard.points.size() < 2) {
    problems.push_back({"hazard/points", std::to_string(hazard.points.size()) + " points",
                        "a hazard curve needs at least two points",
                        "give intensity and annual rate of exceedance for each"});
  }
  return problems;
}

}  // namespace rocking
