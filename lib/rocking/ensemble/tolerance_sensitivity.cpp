#include "rocking/ensemble/result.hpp"

#include <algorithm>

namespace rocking {
namespace {

/// Independent errors add in quadrature, others at worst linearly: an error of a fifth changes an interval little.
constexpr double small_share = 0.2;

double widest_half(const ConditionResult& condition) {
  double widest = 0.0;
  for (const auto& [mode, probability] : condition.modes) {
    widest = std::max(widest, 0.5 * (probability.simultaneous.high - probability.simultaneous.low));
  }
  return widest;
}

NumericalError judged(const ToleranceSensitivity& floor) {
  const double bearable = small_share * floor.half_width;
  if (floor.interval.high <= bearable) return NumericalError::small;
  if (floor.interval.low > bearable) return NumericalError::not_small;
  return NumericalError::undecided;
}

}  // namespace

std::optional<ToleranceSensitivity> tolerance_sensitivity(std::span<const ConditionResult> conditions,
                                                          double confidence) {
  ToleranceSensitivity floor;
  floor.half_width = 1.0;
  for (const ConditionResult& condition : conditions) {
    if (!condition.non_recurrence || condition.non_recurrence->arithmetic_flips.trials == 0) continue;
    floor.flips.successes += condition.non_recurrence->arithmetic_flips.successes;
    floor.flips.trials += condition.non_recurrence->arithmetic_flips.trials;
    floor.half_width = std::min(floor.half_width, widest_half(condition));
  }
  if (floor.flips.trials == 0) return std::nullopt;
  floor.interval = stats::clopper_pearson(floor.flips, confidence);
  floor.noise = judged(floor);
  return floor;
}

}  // namespace rocking
