#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/base/stop_request.hpp"
#include "rocking/dynamics/termination.hpp"
#include "rocking/realisation/operation_counts.hpp"
#include "rocking/realisation/peak_values.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/classification.hpp"
#include "rocking/section/period.hpp"

namespace rocking {

/// Result of one realisation, run to its horizon and classified.
struct RealisationResult {
  dynamics::Termination termination = dynamics::Termination::reached_horizon;
  section::Classification classification;
  std::vector<section::StrobePoint> strobe;  ///< from the first period on, including the transient
  std::uint64_t losses_of_contact = 0;       ///< downward crossings of N = 0
  std::uint64_t losses_before_fall = 0;      ///< of these, without those of the final fall
  double first_loss_of_contact = 0.0;        ///< tau, if there was one
  bool was_past_balance = false;
  std::uint64_t contradictions = 0;  ///< instants at which neither sticking nor slipping agrees with the equations
  PeakValues peaks;                  ///< not part of the digest
  OperationCounts operations;
  Clamps clamps;
};

/// Runs one realisation. A pure function of its first three arguments. Throws base::InputError if check_condition does,
/// and base::Stopped if it is asked to stop.
[[nodiscard]] RealisationResult realise(const Condition& condition, std::uint64_t seed, std::uint64_t realisation,
                                        base::StopRequest stop = {});

/// The same of a condition that was checked, or that breaks a rule on purpose; its numbers are finite.
[[nodiscard]] RealisationResult realise_unchecked(const Condition& condition, std::uint64_t seed,
                                                  std::uint64_t realisation, base::StopRequest stop = {});

}  // namespace rocking
