#include "rocking/output/impacts_text.hpp"

#include "rocking/input/quantities_in_text.hpp"
#include "rocking/scene/rate_ratios.hpp"
#include "rocking/scene/restitution.hpp"

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
    ratios.add(impact.block, mean_restitution(restitution_in(impact.restitution), impact.block));
  }
  return ratios.text();
}

}  // namespace rocking
