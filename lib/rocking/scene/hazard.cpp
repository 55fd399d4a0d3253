#include "rocking/scene/hazard.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include "rocking/base/error.hpp"
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

namespace {

/// The periods of the spectral acceleration that is swept; empty: none.
std::vector<double> measure_periods(const Scene& scene) {
  const auto* recorded = std::get_if<Recorded>(&scene.excitation);
  return recorded == nullptr ? std::vector<double>() : recorded->measure_periods;
}

/// Throws where conditions have different periods: a hazard curve is that of one spectral acceleration.
void check_one_period(const HazardCurve& hazard, const Experiment& experiment) {
  const std::vector<double> first = measure_periods(experiment.conditions.front().scene);
  const bool is_one = std::ranges::all_of(experiment.conditions, [&first](const Condition& condition) {
    return measure_periods(condition.scene) == first;
  });
  if (is_one) return;
  throw base::InputError({.place = hazard.name,
                          .value = "",
                          .reason = "is a curve of one spectral acceleration, but the sweep changes its period",
                          .remedy = "make a run for each period, with the hazard curve of each",
                          .where = {}});
}

/// Throws where the hazard curve is one of another intensity measure than that of the run.
void check_intensity(const HazardCurve& hazard, const Experiment& experiment) {
  const std::string own = swept_measure(experiment);
  if (hazard.intensity == own || intensity_of(experiment) == level_pointer)
    return;  // levels do not state their measure
  const bool lacks_period = own.starts_with(hazard.intensity + '[');
  const std::string line = hazard.header_line == 0 ? "" : ", line " + std::to_string(hazard.header_line);
  throw base::InputError({.place = hazard.name + line,
                          .value = hazard.intensity,
                          .reason = lacks_period ? "does not state its period; the run sweeps " + own
                                                 : "is not the intensity measure of the run, which is " + own,
                          .remedy = "give a hazard curve in " + own + " with the header \"" + own + ", annual_rate\"" +
                                    (lacks_period ? "" : ", or a run that sweeps " + hazard.intensity),
                          .where = {}});
}

}  // namespace

std::optional<double> selected_level(const Scene& scene) {
  const auto* recorded = std::get_if<Recorded>(&scene.excitation);
  if (recorded == nullptr) return std::nullopt;
  return recorded->level ? recorded->level : recorded->return_period;
}

std::string_view intensity_of(const Experiment& experiment) {
  if (selected_level(experiment.conditions.front().scene)) return level_pointer;
  for (const Parameter& parameter : experiment.conditions.front().parameters) {
    const auto found = std::find(all_intensity_pointers.begin(), all_intensity_pointers.end(), parameter.pointer);
    if (found != all_intensity_pointers.end()) return *found;
  }
  return {};
}

bool has_return_periods(const Experiment& experiment) {
  return std::ranges::any_of(experiment.conditions, [](const Condition& condition) {
    const auto* recorded = std::get_if<Recorded>(&condition.scene.excitation);
    return recorded != nullptr && recorded->return_period;
  });
}

std::vector<double> measure_periods(const Experiment& experiment) {
  return measure_periods(experiment.conditions.front().scene);
}

std::string swept_measure(const Experiment& experiment) {
  const std::string_view pointer = intensity_of(experiment);
  std::string text(pointer.substr(pointer.rfind('/') + 1));
  // The period of Sa(2 pi/p) follows from the block.
  if (text == "sa_p_g") return text;
  const std::vector<double> periods = measure_periods(experiment);
  for (std::size_t i = 0; i < periods.size(); ++i) text += (i == 0 ? '[' : '-') + base::shortest(periods[i]);
  return periods.empty() ? text : text + ']';
}

void check_hazard(const HazardCurve& hazard, const Experiment& experiment) {
  check_intensity(hazard, experiment);
  check_one_period(hazard, experiment);
}

}  // namespace rocking
