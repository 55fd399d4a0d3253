#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "rocking/stats/incidence.hpp"
#include "rocking/stats/interval.hpp"
#include "rocking/stats/quantile.hpp"

/// What follows from the cumulative incidence of an event that every observation meets sooner or later, some of them
/// after their censoring.
namespace rocking::stats {

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
