#include "rocking/output/ensemble_fields.hpp"

#include <array>
#include <optional>

#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/stats_fields.hpp"
#include "rocking/output/validity_fields.hpp"

namespace rocking {

template <>
struct TypeOf<StoppedBecause> : OnlyType<NamedType<StoppedBecause, stop_cause_names>> {};
template <>
struct TypeOf<NumericalError> : OnlyType<NamedType<NumericalError, numerical_error_names>> {};

namespace {

using Quartiles = std::array<std::optional<double>, 3>;

Quartiles quartiles_of(const DivergenceTimes& times) {
  return {times.lower_quartile, times.median, times.upper_quartile};
}

void set_quartiles(const Quartiles& read, const ReadingPlace&, DivergenceTimes& times) {
  times.lower_quartile = read[0];
  times.median = read[1];
  times.upper_quartile = read[2];
}

using QuartilesType = ConvertedType<DivergenceTimes, Quartiles, quartiles_of, set_quartiles>;

}  // namespace

static const StructType& fields_of(const DivergenceTimes*) {
  using Times = DivergenceTimes;
  static const StructType fields{
      "DivergenceTimes",
      field<&Times::pairs>("pairs", "number of pairs of runs"),
      field<&Times::diverged>("diverged", "of these, by the horizon"),
      of_owner<Times>("quartiles_periods",
                      "null: so many had not diverged by the horizon that the quartile lies beyond it",
                      the_only<QuartilesType>(), rule::not_negative),
  };
  return fields;
}

static const StructType& fields_of(const NonRecurrence*) {
  using Found = NonRecurrence;
  using stats::Proportion;
  static const StructType flips{
      "FlippedModes",
      field<&Found::arithmetic_flips, &Proportion::successes>("count", "response modes that differ"),
      field<&Found::arithmetic_flips, &Proportion::trials>("of", "realisations that were rerun"),
      field<&Found::arithmetic_flips_interval>("interval", "of that share", rule::share),
  };
  static const StructType fields{
      "NonRecurrence",
      field<&Found::differ>("differ", "probability that two runs differ in response mode", rule::share),
      field<&Found::differ_interval>("differ_interval", "its interval", rule::share),
      field<&Found::entropy>("entropy_nat", "of the response modes", rule::not_negative),
      field<&Found::friction>("divergence_by_friction", "divergence times of runs with independent random numbers"),
      field<&Found::arithmetic>("divergence_by_tolerance",
                                "divergence times of runs with common random numbers and another tolerance"),
      field<&Found::arithmetic_tolerance>("arithmetic_tolerance", "that other tolerance", rule::positive),
      of_owner<Found>("arithmetic_flips", "response modes that differ at the other tolerance", flips),
  };
  return fields;
}

static const StructType& fields_of(const Quantiles*) {
  static const StructType fields{
      "Quantiles",
      field<&Quantiles::realisations>("realisations", "on which the quantiles are based"),
      field<&Quantiles::beyond>("beyond",
                                "of these, the ones that ended before their horizon; they count as above every value"),
      field<&Quantiles::levels>(
          "quantiles",
          "[level, value, low, high]: a quantile with its interval; null: it lies beyond, or the interval is open"),
  };
  return fields;
}

static const StructType& fields_of(const PeakQuantiles::Slip*) {
  using Slip = PeakQuantiles::Slip;
  static const StructType fields{
      "SlipQuantiles",
      inlined<&Slip::over_half_diagonal>(),
      field<&Slip::metres>("quantiles_m", "the same in metres"),
  };
  return fields;
}

static const StructType& fields_of(const PeakQuantiles*) {
  using Peaks = PeakQuantiles;
  static const StructType fields{
      "PeakQuantiles",
      field<&Peaks::tilt>("peak_tilt", "largest abs(Theta) of a realisation: tilt over psi of its side (model.md, 11)"),
      field<&Peaks::tilt_rate>("peak_tilt_rate", "largest abs(Theta')"),
      field<&Peaks::slip>("peak_slip", "largest abs(X), over R and in metres; null without friction"),
      field<&Peaks::final_slip>(
          "final_slip",
          "X at the horizon, > 0 to the right, of the realisations that reached it; null without friction"),
  };
  return fields;
}

static const StructType& fields_of(const Exponents*) {
  static const StructType fields{
      "LyapunovExponents",
      field<&Exponents::mean>("mean", "over these realisations [1/period]"),
      field<&Exponents::standard_error>("standard_error",
                                        "of the mean, from the scatter of realisations [1/period]; null with one",
                                        rule::not_negative),
      field<&Exponents::error_of_one>("error_of_one",
                                      "root mean square of the standard errors of the single exponents, each from "
                                      "eight batches of periods [1/period]",
                                      rule::not_negative),
      inlined<&Exponents::quantiles>(),
  };
  return fields;
}

/// A member that is not named here does not compile: it has a field below, or it has none.
static void name_members(const ConditionResult& result) {
  [[maybe_unused]] const auto& [realisations, modes, left, right, non_recurrence, peaks, exponents, settling, validity,
                                operations, stopped_because] = result;
}

const StructType& fields_of(const ConditionResult*) {
  using Result = ConditionResult;
  static_cast<void>(name_members);
  static const StructType fields{
      "ConditionResult",
      field<&Result::realisations>("realisations", "n; 1 if nothing is random, whatever number was requested",
                                   Rule{.least = 1.0}),
      field<&Result::modes>("counts",
                            "response mode to realisations; (1,1), (1,3), chaotic and overturned are always present",
                            mode_counts_type()),
      field<&Result::modes>("probabilities", "response mode to its probability", mode_probabilities_type()),
      field<&Result::overturned_left>(
          "overturned_left",
          "of the mode overturned: to the left (theta > 0), with the intervals of a mode; `simultaneous` holds at once "
          "with the other side and all other modes. Absent in reports of earlier versions",
          {}, WithoutValue::omitted),
      field<&Result::overturned_right>("overturned_right", "to the right", {}, WithoutValue::omitted),
      field<&Result::non_recurrence>("non_recurrence",
                                     "different responses under equal conditions; null with fewer than two "
                                     "realisations, because there is nothing to compare"),
      field<&Result::settling>("incidence", "which response, and by when: only with `until_classified`", {},
                               WithoutValue::omitted),
      inlined<&Result::peaks>(),
      field<&Result::exponents>("lyapunov_exponent",
                                "largest one per excitation period, of the realisations whose classification needed "
                                "it; absent where none did (methods-classification.md)",
                                {}, WithoutValue::omitted),
      of_owner<Result>("validity", "realisations that left the model or whose classification is uncertain",
                       validity_fields()),
      field<&Result::stopped_because>("stopped_because",
                                      "`deterministic`: nothing is random and one realisation is the response; with "
                                      "`until`: `half_width_reached` or `at_most_reached`"),
  };
  return fields;
}

const StructType& fields_of(const ToleranceSensitivity*) {
  using Found = ToleranceSensitivity;
  using stats::Proportion;
  static const StructType fields{
      "ToleranceSensitivity",
      field<&Found::flips, &Proportion::successes>("flips", "reruns whose response mode changed"),
      field<&Found::flips, &Proportion::trials>("of", "realisations that were rerun", Rule{.least = 1.0}),
      field<&Found::interval>("interval", "of that share; if the confidence is swept, at the highest", rule::share),
      field<&Found::half_width>("half_width",
                                "half of the widest simultaneous interval, in the condition where that is narrowest",
                                rule::share),
      field<&Found::noise>("arithmetic_noise", "whether the share that changes lies below a fifth of the half-width"),
  };
  return fields;
}

}  // namespace rocking
