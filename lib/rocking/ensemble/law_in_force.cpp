#include "rocking/ensemble/law_in_force.hpp"

#include <limits>

#include "rocking/scene/restitution.hpp"

namespace rocking {

std::optional<stats::MeanAndSigma> law_in_force(const FluctuatingNumber& number, std::string_view key) {
  if (key == "kinetic_friction_at_static") {
    if (!number.limit) return std::nullopt;
    return stats::smaller_of_normals(number.law, *number.limit, number.correlation);
  }
  if (key == "restitution") return stats::clamped_normal(number.law, least_restitution, largest_restitution);
  if (key == "block_length_at_bound") return std::nullopt;
  return stats::clamped_normal(number.law, 0.0, std::numeric_limits<double>::infinity());
}

}  // namespace rocking
