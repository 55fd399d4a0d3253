#include "rocking/output/ensemble_fields.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/stats_fields.hpp"

namespace rocking {

/// stats::TimeToShare as it is written.
struct WrittenTimeToShare {
  double unsettled = 0.0;
  std::string basis;
  std::optional<std::int64_t> periods;
  std::array<std::optional<std::int64_t>, 2> interval;
  std::uint64_t settled_in_the_last_half = 0;
};

namespace {

constexpr std::array<std::string_view, 3> bases{"observed", "extrapolated", "unknown"};

WrittenTimeToShare written(const stats::TimeToShare& found) {
  return {.unsettled = ResponseTimes::tolerable_share,
          .basis = std::string(bases.at(found.is_observed ? 0
                                        : found.time      ? 1
                                                          : 2)),
          .periods = found.time,
          .interval = {found.low, found.high},
          .settled_in_the_last_half = found.events};
}

void convert(const WrittenTimeToShare& read, const ReadingPlace&, stats::TimeToShare& found) {
  found = {.is_observed = read.basis == bases.front(),
           .time = read.periods,
           .low = read.interval[0],
           .high = read.interval[1],
           .events = read.settled_in_the_last_half};
}

}  // namespace

static const StructType& fields_of(const WrittenTimeToShare*) {
  using Time = WrittenTimeToShare;
  static const StructType fields{
      "TimeToShare",
      field<&Time::unsettled>("unsettled", "the share that is left", rule::confidence),
      field<&Time::basis>("basis", "how it is known", Rule{.choices = bases}),
      field<&Time::periods>("periods", "by when the others have settled; null: unknown", rule::not_negative),
      field<&Time::interval>("interval", "its interval; null: open", rule::not_negative),
      field<&Time::settled_in_the_last_half>("settled_in_the_last_half",
                                             "realisations on which the extrapolation rests"),
  };
  return fields;
}

template <>
struct TypeOf<stats::TimeToShare> : OnlyType<ConvertedType<stats::TimeToShare, WrittenTimeToShare, written, convert>> {
};

static const StructType& fields_of(const Leaving*) {
  static const StructType fields{
      "Leaving",
      field<&Leaving::left>("left", "responses that were left again while they were watched"),
      field<&Leaving::watched_periods>("watched_periods", "of all of them", Rule{.least = 1.0}),
      derived<[](const Leaving& found) {
        return 1000.0 * static_cast<double>(found.left) / static_cast<double>(found.watched_periods);
      }>("per_1000_periods", "rate of leaving", rule::not_negative),
      field<&Leaving::per_1000_periods>("interval", "of that rate, exact if it is constant", rule::not_negative),
  };
  return fields;
}

static const StructType& fields_of(const LongRuns::Share*) {
  static const StructType fields{
      "LongRunShare",
      field<&LongRuns::Share::share>("share", "of the windows", rule::share),
      field<&LongRuns::Share::interval>("interval", "its interval, for this mode alone", rule::share),
  };
  return fields;
}

static const StructType& fields_of(const LongRuns*) {
  static const StructType fields{
      "LongRuns",
      field<&LongRuns::count>("realisations", "with a long run"),
      field<&LongRuns::windows>("windows", "counted in each of them"),
      field<&LongRuns::shares>("modes", "response mode to its share of the windows"),
  };
  return fields;
}

const StructType& fields_of(const SettlingResult*) {
  using Found = SettlingResult;
  using Times = ResponseTimes;
  static const StructType at_horizon{
      "AtHorizon",
      field<&Found::at_horizon>("counts", "response mode to realisations"),
      field<&Found::differ>("differ", "probability that two runs differ there; null with fewer than two", rule::share),
      field<&Found::differ_interval>("differ_interval", "its interval; null likewise", rule::share),
  };
  static const StructType fields{
      "SettlingResult",
      field<&Found::censored>("censored", "realisations that had not settled"),
      field<&Found::times, &Times::quartiles>("settling_periods", "quartiles of the settling period, as `quantiles`"),
      field<&Found::times, &Times::nearly_all>("nearly_all", "the period by which all but a small share have settled"),
      field<&Found::times, &Times::any_mode>("any_mode", "probability of having settled by a period"),
      field<&Found::incidence>("modes", "the same in each response mode (Aalen & Johansen 1978)"),
      of_owner<Found>("at_horizon", "what a run with the fixed horizon would have found", at_horizon),
      field<&Found::divergence>("divergence_by_friction",
                                "probability that two runs with independent random numbers have diverged by a period"),
      field<&Found::times, &Times::divergence_quartiles>("divergence_periods",
                                                         "quartiles of the divergence time, as `quantiles`"),
      field<&Found::leaving>("leaving", "with `watch_windows`: settled responses that were left again, by mode"),
      field<&Found::long_runs>("long_run_shares",
                               "with `long_run_every`: shares of the windows in the second half of `at_most_periods`",
                               rule::none, WithoutValue::omitted),
  };
  return fields;
}

}  // namespace rocking
