#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "rocking/stats/interval.hpp"

/// Times to the first of several events that exclude each other (competing risks), some of them censored.
namespace rocking::stats {

/// The end of an observation: its time and the number of its event from 0, or no event (censored). Of equal times an
/// event comes before a censoring.
struct EndOfObservation {
  std::int64_t time = 0;
  std::optional<std::size_t> event;

  friend auto operator<=>(const EndOfObservation&, const EndOfObservation&) = default;
};

/// Number of observations by their end.
using EventTally = std::map<EndOfObservation, std::uint64_t>;

/// Cumulative incidence of one event at one time, with its infinitesimal-jackknife variance.
struct Incidence {
  std::int64_t time = 0;
  double estimate = 0.0;
  double variance = 0.0;
  Interval pointwise;
  Interval simultaneous;  ///< holds at all times at once
};

/// By when all but a share of the observations have met the event.
struct TimeToShare {
  bool is_observed = false;          ///< the curve reaches it; otherwise it is extrapolated
  std::optional<std::int64_t> time;  ///< absent: cannot be told
  std::optional<std::int64_t> low;   ///< ends of its interval; absent: open
  std::optional<std::int64_t> high;
  std::uint64_t events = 0;  ///< on which the extrapolation rests
};

/// Probability that `event` has occurred by each time at which its estimate changes (Aalen & Johansen 1978, Scand. J.
/// Stat. 5, 141-150). With one kind of event it is 1 minus the estimate of Kaplan and Meier.
///
/// The variance is the sum of the squared influences of the observations (infinitesimal jackknife; that of `survfit` in
/// R's survival package). Without censoring before a time it is F (1 - F)/n there.
///
/// The pointwise interval is the exact one of Clopper and Pearson for the effective number of observations F (1 - F)/v
/// (Korn & Graubard 1998, Surv. Methodol. 24, 193-201). Without earlier censoring it is the exact interval.
///
/// The band is F +- sqrt(ln(2/(1 - confidence))/(2 n)), within [0, 1] (Dvoretzky, Kiefer & Wolfowitz 1956; Massart
/// 1990, Ann. Prob. 18, 1269-1283), which holds for each n without censoring before the last event. n is the number of
/// observations without those censored before the last event; with such censoring the band is approximate.
/// Cost: number of distinct ends times number of distinct times.
[[nodiscard]] std::vector<Incidence> cumulative_incidence(const EventTally& tally, std::size_t event,
                                                          double confidence);

/// Interval for the rate of a Poisson process with `count` events in `exposure` > 0, per unit of exposure: the rates for
/// which neither tail has a probability below (1 - confidence)/2. Source: Garwood (1936), Biometrika 28, 437-442.
[[nodiscard]] Interval poisson_rate_interval(std::uint64_t count, double exposure, double confidence);

}  // namespace rocking::stats
