#pragma once

#include <cstdint>

#include "rocking/ensemble/result.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/stats/stopping_rule.hpp"

namespace rocking {

/// Number of realisations that a condition needs, as far as known at present.
struct Target {
  std::uint64_t realisations = 0;
  bool is_final = false;                                         ///< if not: look again at this number
  StoppedBecause cause = StoppedBecause::all_realisations_done;  ///< if final
};

/// The target before any realisation is known.
[[nodiscard]] Target first_target(const Condition& condition);

/// The target after a look at the modes of the first `target.realisations`; `target` must not be final. Depends only on
/// the condition and these modes, not on threads or interruptions.
[[nodiscard]] Target next_target(const Condition& condition, const Target& target, const ModeTally& modes);

/// The stopping rule of a condition with `until`.
[[nodiscard]] stats::StoppingRule stopping_rule(const Condition& condition);

/// The interval of a mode that the rule uses. The intervals of all modes hold at once, whenever and for whatever reason
/// the run stops.
[[nodiscard]] stats::Interval anytime_interval(const stats::StoppingRule& rule, const section::ResponseMode& mode,
                                               const stats::Proportion& counts);

}  // namespace rocking
