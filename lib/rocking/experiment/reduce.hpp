#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "rocking/base/digest.hpp"
#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/record.hpp"
#include "rocking/experiment/result.hpp"

namespace rocking::experiment {

/// What is kept of a record once its neighbour has been compared with it: some hundred bytes, whatever the horizon.
struct Summary {
  section::ResponseMode mode;
  section::Reason reason = section::Reason::too_few_points;
  dynamics::Termination termination = dynamics::Termination::reached_horizon;
  bool in_transient = false;
  bool left_ground = false;
  bool was_past_balance = false;
  bool met_contradiction = false;
  bool clamped = false;
  base::Sha256 digest{};
  /// Of an even-numbered realisation: when the next one parted from it.
  std::optional<std::int64_t> parted_from_next;
  /// Of a realisation that was repeated at another tolerance: its mode there, and when the two parted.
  struct Repeat {
    section::ResponseMode mode;
    std::optional<std::int64_t> parted;
  };
  std::optional<Repeat> repeat;
};

[[nodiscard]] Summary summarise(const Record& record, std::uint64_t realisation);

/// The tolerance at which a tenth of the realisations is repeated, with the same draws, to tell what arithmetic does from
/// what friction does: a hundred times tighter, but not below 1e-16.
[[nodiscard]] double repeat_tolerance(double tolerance);

/// What adds up over a condition's realisations, in any order.
struct Totals {
  Effort effort;
  Clamps clamps;
};

/// Counts, probabilities, non-recurrence and validity of a condition from its realisations in their order.
[[nodiscard]] ConditionResult reduce(const Condition& condition, std::span<const Summary> realisations,
                                     const Totals& totals);

}  // namespace rocking::experiment
