#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "rocking/base/digest.hpp"
#include "rocking/experiment/record.hpp"
#include "rocking/experiment/result.hpp"

namespace rocking::experiment {

/// One realisation of one condition of an experiment; both count from 0.
struct RealisationKey {
  std::uint64_t condition = 0;
  std::uint64_t realisation = 0;

  friend auto operator<=>(const RealisationKey&, const RealisationKey&) = default;
};

/// What is kept of a record once its neighbour has been compared with it: some hundred bytes, whatever the horizon.
struct Summary {
  section::ResponseMode mode;
  std::optional<section::Reason> reason;  ///< absent where nothing was decided
  dynamics::Termination termination = dynamics::Termination::reached_horizon;
  double margin = 0.0;
  double held = 0.0;  ///< share of the sampled periods that bear the mode out
  bool in_transient = false;
  bool left_ground = false;
  bool was_past_balance = false;
  bool met_contradiction = false;
  base::Sha256 digest{};  ///< of the record
  /// Of an even-numbered realisation: when the next one parted from it [periods].
  std::optional<std::int64_t> parted_from_next;
  /// Of a realisation that was repeated at another tolerance: its mode there, and when the two parted [periods].
  std::optional<section::ResponseMode> repeat_mode;
  std::optional<std::int64_t> repeat_parted;
  /// Of a realisation whose label was checked: its mode by the longer run.
  std::optional<section::ResponseMode> long_mode;
  Effort effort;
  Clamps clamps;

  [[nodiscard]] bool was_clamped() const;
};

[[nodiscard]] Summary summarise(const Record& record, std::uint64_t realisation);

/// Calls visit(name, field) for every field of a summary, in a fixed order: what a stored row is made of.
template <class SomeSummary, class Visit>
void for_each_field(SomeSummary& summary, Visit&& visit) {
  visit("mode", summary.mode);
  visit("reason", summary.reason);
  visit("termination", summary.termination);
  visit("margin", summary.margin);
  visit("held", summary.held);
  visit("in_transient", summary.in_transient);
  visit("left_ground", summary.left_ground);
  visit("past_balance", summary.was_past_balance);
  visit("contradiction", summary.met_contradiction);
  visit("digest", summary.digest);
  visit("parted_from_next", summary.parted_from_next);
  visit("repeat_mode", summary.repeat_mode);
  visit("repeat_parted", summary.repeat_parted);
  visit("long_mode", summary.long_mode);
  auto& effort = summary.effort;
  visit("steps", effort.steps);
  visit("slip_steps", effort.slip_steps);
  visit("root_isolations", effort.root_isolations);
  visit("record_segments", effort.record_segments);
  visit("companion_periods", effort.companion_periods);
  visit("static_friction_draws", effort.static_friction_draws);
  visit("kinetic_friction_draws", effort.kinetic_friction_draws);
  visit("restitution_draws", effort.restitution_draws);
  visit("amplitude_draws", effort.amplitude_draws);
  visit("initial_draws", effort.initial_draws);
  for (std::size_t kind = 0; kind < effort.events.size(); ++kind) {
    visit("event_" + std::string(to_string(static_cast<dynamics::EventKind>(kind))), effort.events[kind]);
  }
  auto& clamps = summary.clamps;
  visit("clamped_kinetic_at_zero", clamps.kinetic_at_zero);
  visit("clamped_kinetic_at_static", clamps.kinetic_at_static);
  visit("clamped_static_at_zero", clamps.static_at_zero);
  visit("clamped_restitution", clamps.restitution);
  visit("clamped_amplitude_at_zero", clamps.amplitude_at_zero);
}

}  // namespace rocking::experiment
