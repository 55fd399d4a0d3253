#include "rocking/experiment/noise_floor.hpp"

#include <algorithm>

namespace rocking::experiment {
namespace {

/// Errors add like squares where they are independent, and at worst as they are: a fifth changes an interval little.
constexpr double small_share = 0.2;

double widest_half(const ConditionResult& condition) {
  double widest = 0.0;
  for (const auto& [mode, probability] : condition.modes) {
    widest = std::max(widest, 0.5 * (probability.simultaneous.high - probability.simultaneous.low));
  }
  return widest;
}

ArithmeticNoise judged(const NoiseFloor& floor) {
  const double bearable = small_share * floor.half_width;
  if (floor.interval.high <= bearable) return ArithmeticNoise::small;
  if (floor.interval.low > bearable) return ArithmeticNoise::not_small;
  return ArithmeticNoise::undecided;
}

}  // namespace

std::string_view to_string(ArithmeticNoise noise) {
  switch (noise) {
    case ArithmeticNoise::small: return "small";
    case ArithmeticNoise::not_small: return "not_small";
    case ArithmeticNoise::undecided: return "undecided";
  }
  return "";
}

std::optional<NoiseFloor> noise_floor(std::span<const ConditionResult> conditions, double confidence) {
  NoiseFloor floor;
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

}  // namespace rocking::experiment
