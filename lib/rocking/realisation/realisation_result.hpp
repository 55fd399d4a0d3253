#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/base/digest.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/dynamics/contact.hpp"
#include "rocking/realisation/measures.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/section/classification.hpp"
#include "rocking/section/classify.hpp"
#include "rocking/section/response_mode.hpp"

namespace rocking {

/// What became of a realisation that was observed until its response was classified (UntilClassified). Periods count
/// from the start of the realisation.
struct Settling {
  section::ResponseMode horizon_mode;  ///< at the end of the sampled periods
  std::int64_t observed_periods = 0;   ///< until it was classified, or the watch, the motion or the limit ended
  /// End of the first window of those that gave the response mode, or the period of overturning. Absent: censored.
  std::optional<std::int64_t> settling_period;
  std::optional<std::int64_t> left_period;       ///< end of the window in which a settled response had another mode
  std::optional<section::ResponseMode> left_to;  ///< this mode
  base::Sha256 continued{};  ///< digest of the strobe points after the fixed horizon; zero without any
  std::optional<section::ModeCounts> long_run;  ///< windows of its long run by their modes; absent without one

  [[nodiscard]] bool was_continued() const { return continued != base::Sha256{}; }
};

/// Result of one realisation, run to its horizon and classified.
struct RealisationResult {
  dynamics::Termination termination = dynamics::Termination::reached_horizon;
  section::Classification classification;
  /// Of the newest window whose classification needed it; absent if none did. Not part of the digest.
  std::optional<section::ExponentEstimate> exponent = std::nullopt;
  /// From the first period on, including the transient, to the fixed horizon.
  std::vector<section::StrobePoint> strobe;
  std::uint64_t losses_of_contact = 0;   ///< downward crossings of N = 0
  std::uint64_t losses_before_fall = 0;  ///< of these, without those of the final fall
  double first_loss_of_contact = 0.0;    ///< tau, if there was one
  bool was_past_balance = false;
  std::optional<dynamics::Side> overturned_side =
      std::nullopt;                  ///< absent if it did not overturn; not part of the digest
  std::uint64_t contradictions = 0;  ///< instants at which neither sticking nor slipping agrees with the equations
  PeakValues peaks;                  ///< not part of the digest
  OperationCounts operations;
  Clamps clamps;
  std::optional<Settling> settling;  ///< absent at a fixed horizon
};

/// Runs one realisation. A pure function of its first three arguments. Throws base::InputError if check_condition does,
/// and base::Stopped if it is asked to stop.
[[nodiscard]] RealisationResult realise(const Condition& condition, std::uint64_t seed, std::uint64_t realisation,
                                        base::StopRequest stop = {});

/// The same of a condition that was checked, or that breaks a rule on purpose; its numbers are finite.
[[nodiscard]] RealisationResult realise_unchecked(const Condition& condition, std::uint64_t seed,
                                                  std::uint64_t realisation, base::StopRequest stop = {});

/// First period, counted from 1, in which the two results have diverged: their strobe points are more than 0.01 apart
/// in (Theta, Theta'), or only one of the runs has ended. Absent if they have not diverged.
[[nodiscard]] std::optional<std::int64_t> divergence_period(const RealisationResult& a, const RealisationResult& b);

/// SHA-256 over the bits of a result: realisation number, termination, response mode, strobe points, counts of events.
[[nodiscard]] base::Sha256 digest_of(const RealisationResult& result, std::uint64_t realisation);

}  // namespace rocking
