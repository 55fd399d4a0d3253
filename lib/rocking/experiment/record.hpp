#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/base/digest.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/dynamics/termination.hpp"
#include "rocking/experiment/experiment.hpp"
#include "rocking/experiment/result.hpp"
#include "rocking/section/period.hpp"
#include "rocking/section/verdict.hpp"

namespace rocking::experiment {

/// One realisation, run to its horizon and named.
struct Record {
  dynamics::Termination termination = dynamics::Termination::reached_horizon;
  section::Verdict verdict;
  std::vector<section::StrobePoint> strobe;  ///< Poincare points from the first period on
  std::uint64_t losses_of_contact = 0;       ///< downward crossings of N = 0
  double first_loss_of_contact = 0.0;        ///< tau, where there was one
  bool was_past_balance = false;
  std::uint64_t contradictions = 0;  ///< instants at which neither sticking nor slipping agrees with the equations
  Effort effort;
  Clamps clamps;
};

/// Runs one realisation: a pure function of its first three arguments. Throws base::Stopped once it is asked to stop.
[[nodiscard]] Record realise(const Condition& condition, std::uint64_t seed, std::uint64_t realisation,
                             base::StopRequest stop = {});

/// SHA-256 over the bits of a record: realisation, termination, response mode, strobe points, counts of events.
[[nodiscard]] base::Sha256 digest_of(const Record& record, std::uint64_t realisation);

/// First period (from 1) whose strobe points are more than 0.01 apart in (Theta, Theta'), or in which one of the two runs
/// has ended and the other has not; absent if they have not parted.
[[nodiscard]] std::optional<std::int64_t> parting_period(const Record& a, const Record& b);

}  // namespace rocking::experiment
