#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "rocking/stats/interval.hpp"
#include "rocking/stats/quantile.hpp"

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

/// The quantile at `level` of the time of the event, of `observations` observations: where the curve of
/// cumulative_incidence reaches the level. Its interval has the times at which the pointwise interval contains the
/// level (Brookmeyer & Crowley 1982, Biometrics 38, 29-41). Without censoring before it these are the nearest rank and
/// the interval of quantile_estimate. Absent: beyond the observation.
[[nodiscard]] QuantileEstimate incidence_quantile(const std::vector<Incidence>& curve, std::uint64_t observations,
                                                  double level, double confidence);

/// Observations are looked at every `step` after `from` > 0: an event is seen at the end of the step in which it
/// happened.
struct Steps {
  std::int64_t from = 0;
  std::int64_t step = 1;
};

/// The time at which a share, in (0, 1), of the observations has not met the event. Where the curve reaches it, this is
/// incidence_quantile at 1 - share. Otherwise the curve is continued from its end T by the probability q of the event in
/// a step, estimated from the steps in the last half of the observation:
///
///     T + step * ln(S(T)/share)/(-ln(1 - q)), rounded up to whole steps
///
/// Its interval combines those of S(T) and q (Clopper-Pearson), each at 1 - (1 - confidence)/2, so that it holds at
/// `confidence` if q stays as it is; if q falls, as it does where some observations hardly ever meet the event, the time
/// is later. `tally` has the event 0 and censorings only.
[[nodiscard]] TimeToShare time_to_share(const EventTally& tally, const Steps& steps, double share, double confidence);

/// At most `most` points of a curve, evenly spread, with the first and the last one; most >= 2.
[[nodiscard]] std::vector<Incidence> thinned(const std::vector<Incidence>& curve, std::size_t most);

}  // namespace rocking::stats
