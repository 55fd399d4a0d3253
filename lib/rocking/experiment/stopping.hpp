#pragma once

#include <cstdint>
#include <string_view>

#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/mode_family.hpp"
#include "rocking/stats/stopping_rule.hpp"

namespace rocking::experiment {

/// Why a condition has as many realisations as it has. Spelled like the enumerator in reports.
enum class StoppedBecause : std::uint8_t {
  deterministic,          ///< nothing is drawn: one says all
  all_realisations_done,  ///< as many as were asked for
  half_width_reached,     ///< all intervals are as narrow as was asked for
  at_most_reached,        ///< they are not, but no more were allowed
};

[[nodiscard]] std::string_view to_string(StoppedBecause cause);

/// How many realisations a condition is to have, as far as those seen allow to say.
struct Target {
  std::uint64_t realisations = 0;
  bool is_final = false;                                         ///< if not: then one has to look again
  StoppedBecause cause = StoppedBecause::all_realisations_done;  ///< if it is
};

/// Before anything is seen.
[[nodiscard]] Target first_target(const Condition& condition);

/// After a look at the modes of the first `target.realisations`, where that target was not final. A function of the
/// condition and these modes alone: threads and interruptions have no say.
[[nodiscard]] Target next_target(const Condition& condition, const Target& target, const ModeTally& modes);

/// The rule of a condition with `until`.
[[nodiscard]] stats::StoppingRule stopping_rule(const Condition& condition);

}  // namespace rocking::experiment
