#include "rocking/output/impacts_text.hpp"

#include "rocking/input/quantities_in_text.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/scene/rate_ratios.hpp"

namespace rocking {
namespace {

Restitution restitution_in(const Json& written) {
  if (written.is_string()) return Jy25Restitution{};
  if (written.is_object() && written.contains("rate_ratio")) return RateRatio{quantity_in(written.at("rate_ratio"))};
  return quantity_in(written);
}

}  // namespace

std::string impacts_text(const std::vector<ReportedImpact>& impacts) {
  RateRatios ratios;
  for (const ReportedImpact& impact : impacts) {
    const dynamics::Geometry block = dynamics::geometry_of({.width = impact.width_m, .height = impact.height_m});
    Scene scene;
    scene.restitution = restitution_in(impact.restitution);
    ratios.add(block, restitution_of(scene, block));
  }
  return ratios.text();
}

}  // namespace rocking
