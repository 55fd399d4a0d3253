#include "rocking/ensemble/stopping.hpp"

#include <numeric>

#include "rocking/base/error.hpp"
#include "rocking/ensemble/mode_family.hpp"

namespace rocking {
namespace {

bool has_reached(const stats::StoppingRule& rule, const Until& until, const ModeTally& modes) {
  if (!until.mode) return rule.narrow_enough(category_counts(modes));
  const auto add = [](std::uint64_t sum, const auto& entry) { return sum + entry.second; };
  const auto found = modes.find(*until.mode);
  const stats::Proportion counts{.successes = found == modes.end() ? 0 : found->second,
                                 .trials = std::accumulate(modes.begin(), modes.end(), std::uint64_t{0}, add)};
  return rule.narrow_enough(counts, anytime_interval(rule, *until.mode, counts));
}

}  // namespace

stats::StoppingRule stopping_rule(const Condition& condition) {
  ROCKING_EXPECT(condition.until.has_value());
  const auto& [half_width, relative, mode] = *condition.until;
  ROCKING_EXPECT(half_width.has_value() != relative.has_value());
  return stats::StoppingRule({.half_width = relative ? *relative : *half_width,
                              .scale = relative ? stats::HalfWidthScale::relative : stats::HalfWidthScale::absolute,
                              .at_most = condition.realisations,
                              .family = mode_family(condition.confidence)});
}

stats::Interval anytime_interval(const stats::StoppingRule& rule, const section::ResponseMode& mode,
                                 const stats::Proportion& counts) {
  return is_prespecified(mode) ? rule.interval_of_prespecified(counts) : rule.interval_of_others(counts);
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
  if (has_reached(rule, *condition.until, modes)) {
    return {.realisations = seen, .is_final = true, .cause = StoppedBecause::half_width_reached};
  }
  if (seen == condition.realisations) {
    return {.realisations = seen, .is_final = true, .cause = StoppedBecause::at_most_reached};
  }
  return {.realisations = rule.next_look(seen)};
}

}  // namespace rocking
