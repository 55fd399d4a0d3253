#include "rocking/ensemble/stopping.hpp"

#include "rocking/base/error.hpp"

namespace rocking {

std::string_view to_string(StoppedBecause cause) {
  switch (cause) {
    case StoppedBecause::deterministic: return "deterministic";
    case StoppedBecause::all_realisations_done: return "all_realisations_done";
    case StoppedBecause::half_width_reached: return "half_width_reached";
    case StoppedBecause::at_most_reached: return "at_most_reached";
  }
  return "";
}

stats::StoppingRule stopping_rule(const Condition& condition) {
  ROCKING_EXPECT(condition.until.has_value());
  return stats::StoppingRule({.half_width = condition.until->half_width,
                              .at_most = condition.realisations,
                              .family = mode_family(condition.confidence)});
}

Target first_target(const Condition& condition) {
  if (!is_random(condition.scene)) {
    return {.realisations = 1, .is_final = true, .cause = StoppedBecause::deterministic};
  }
  if (condition.until) return {.realisations = stopping_rule(condition).next_look(0)};
  return {.realisations = condition.realisations, .is_final = true, .cause = StoppedBecause::all_realisations_done};
}

Target next_target(const Condition& condition, const Target& target, const ModeTally& modes) {
  ROCKING_EXPECT(!target.is_final);
  const stats::StoppingRule rule = stopping_rule(condition);
  const std::uint64_t seen = target.realisations;
  if (rule.narrow_enough(category_counts(modes))) {
    return {.realisations = seen, .is_final = true, .cause = StoppedBecause::half_width_reached};
  }
  if (seen == condition.realisations) {
    return {.realisations = seen, .is_final = true, .cause = StoppedBecause::at_most_reached};
  }
  return {.realisations = rule.next_look(seen)};
}

}  // namespace rocking
