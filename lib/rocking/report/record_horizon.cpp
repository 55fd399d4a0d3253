#include "rocking/report/record_horizon.hpp"

#include <algorithm>
#include <cmath>
#include <variant>

namespace rocking::report {

std::int64_t periods_under_record(const experiment::Scene& scene) {
  constexpr double two_pi = 0x1.921fb54442d18p+2;
  const dynamics::Geometry block = dynamics::geometry_of(scene.block);
  const double delta = 1.0 - 1.5 * (1.0 + scene.restitution) * block.sine * block.sine;
  const double coming_to_rest = 8.0 + 4.0 / std::max(1.0 - std::abs(delta), 1e-3);
  const double record =
      std::visit([](const auto& kind) { return kind.last_second(); }, scene.excitation) * block.frequency_parameter;
  return static_cast<std::int64_t>(std::ceil((record + coming_to_rest) * frequency_ratio(scene.excitation) / two_pi));
}

}  // namespace rocking::report
