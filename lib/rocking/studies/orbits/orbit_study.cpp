#include "rocking/studies/orbits/question.hpp"

namespace rocking {

std::optional<bool> OrbitsOfCondition::is_certified() const {
  if (mode.kind != section::ResponseKind::periodic) return std::nullopt;
  if (!run_on) return false;
  const Orbit& orbit = orbits[*run_on];
  return orbit.stability.is_stable() && section::periodic(orbit.cycles, orbit.period) == mode;
}

OrbitLabels labels_of(const OrbitStudy& study) {
  OrbitLabels labels;
  for (std::size_t i = 0; i < study.conditions.size(); ++i) {
    const std::optional<bool> is_certified = study.conditions[i].is_certified();
    if (!is_certified) continue;
    ++labels.periodic;
    if (*is_certified) {
      ++labels.certified;
    } else {
      labels.not_certified.push_back(i);
    }
  }
  return labels;
}

}  // namespace rocking
