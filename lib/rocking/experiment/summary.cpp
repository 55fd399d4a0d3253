#include "rocking/experiment/summary.hpp"

namespace rocking::experiment {

bool Summary::was_clamped() const {
  return clamps.kinetic_at_zero + clamps.kinetic_at_static + clamps.static_at_zero + clamps.restitution +
             clamps.amplitude_at_zero >
         0;
}

Summary summarise(const Record& record, std::uint64_t realisation) {
  return {.mode = record.verdict.mode,
          .reason = record.verdict.reason,
          .termination = record.termination,
          .margin = record.verdict.margin,
          .held = record.verdict.held,
          .in_transient = record.verdict.in_transient,
          .left_ground = record.losses_of_contact > 0,
          .was_past_balance = record.was_past_balance,
          .met_contradiction = record.contradictions > 0,
          .digest = digest_of(record, realisation),
          .parted_from_next = std::nullopt,
          .repeat_mode = std::nullopt,
          .repeat_parted = std::nullopt,
          .long_mode = std::nullopt,
          .effort = record.effort,
          .clamps = record.clamps};
}

}  // namespace rocking::experiment
