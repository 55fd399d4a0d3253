#include "rocking/scene/hazard.hpp"

#include <cmath>
#include <string>

#include "rocking/base/number_text.hpp"

namespace rocking {

std::optional<HazardSite> hazard_site(const std::vector<double>& numbers) {
  if (numbers.empty()) return std::nullopt;
  if (numbers.size() == 2) return HazardSite{.longitude = numbers[0], .latitude = numbers[1]};
  throw base::InputError({"--site", std::to_string(numbers.size()) + " numbers", "is no longitude and latitude",
                          "write --site 13.4,42.35"});
}

std::optional<HazardFault> fault_of(const HazardPoint& point, const HazardPoint* before) {
  constexpr auto intensity = &HazardPoint::intensity;
  constexpr auto rate = &HazardPoint::rate;
  if (!(point.intensity > 0.0 && std::isfinite(point.intensity))) {
    return HazardFault{intensity, "must be positive", "give an intensity above 0"};
  }
  if (!(point.rate >= 0.0 && std::isfinite(point.rate))) {
    return HazardFault{rate, "must not be negative", "give a rate of at least 0"};
  }
  if (before == nullptr) return std::nullopt;
  if (!(point.intensity > before->intensity)) {
    return HazardFault{intensity, "is not above the intensity before it", "sort the lines by growing intensity"};
  }
  if (!(point.rate <= before->rate)) {
    return HazardFault{rate, "is above the number before it: a stronger intensity is exceeded less often",
                       "give rates or probabilities of exceedance, which do not rise with the intensity"};
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
  if (auto problem = problem_of_whole(hazard); problem && problems.empty()) {
    problem->place = "hazard/points";
    problems.push_back(*std::move(problem));
  }
  return problems;
}

std::optional<base::Problem> problem_of_whole(const HazardCurve& hazard) {
  if (hazard.points.size() < 2) {
    return base::Problem{hazard.name, std::to_string(hazard.points.size()) + " points",
                         "a hazard curve needs at least two points",
                         "give a line \"intensity, annual rate of exceedance\" for each"};
  }
  if (hazard.points.back().rate < hazard.points.front().rate) return std::nullopt;
  return base::Problem{hazard.name, "", "has the same rate of exceedance at all intensities",
                       "give stronger intensities, which are exceeded less often"};
}

}  // namespace rocking
