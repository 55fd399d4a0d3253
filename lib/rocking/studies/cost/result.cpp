#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/stats_fields.hpp"
#include "rocking/studies/cost/study.hpp"

namespace rocking {

/// Flips at a tolerance beside those at the floor.
struct ExcessOverFloor {
  std::uint64_t here_only = 0;
  std::uint64_t floor_only = 0;
  stats::Interval interval;
};

static const StructType& fields_of(const ExcessOverFloor*) {
  using Excess = ExcessOverFloor;
  static const StructType fields{
      "ExcessOverFloor",
      field<&Excess::here_only>("here_only", "realisations that flip only here"),
      field<&Excess::floor_only>("floor_only", "realisations that flip only at the floor"),
      field<&Excess::interval>("interval", "of the difference of the shares, exact", rule::difference_of_shares),
  };
  return fields;
}

static const StructType& fields_of(const Flip*) {
  static const StructType fields{
      "Flip",
      field<&Flip::key, &RealisationKey::condition>("condition", "from 0, for `rocking trajectory`"),
      field<&Flip::key, &RealisationKey::realisation>("realisation", "from 0"),
      field<&Flip::mode>("mode", "its response mode"),
      field<&Flip::reference>("reference", "its response mode at the tightest tolerance"),
  };
  return fields;
}

namespace {

std::optional<ExcessOverFloor> excess_of(const Departure& departure) {
  if (!departure.beside_tolerance_sensitivity) return std::nullopt;
  const stats::PairedCounts& counts = *departure.beside_tolerance_sensitivity;
  return ExcessOverFloor{counts.first_only, counts.second_only, *departure.beyond_floor};
}

void set_excess(const std::optional<ExcessOverFloor>& read, const ReadingPlace&, Departure& departure) {
  if (!read) return;
  departure.beside_tolerance_sensitivity = {.first_only = read->here_only, .second_only = read->floor_only};
  departure.beyond_floor = read->interval;
}

using ExcessType = ConvertedType<Departure, std::optional<ExcessOverFloor>, excess_of, set_excess>;

const StructType& error_fields() {
  static const StructType fields{
      "TrajectoryError",
      field<&Departure::moving>("of", "realisations that moved"),
      field<&Departure::median_error>("median", "of an even number the lower one; null: nothing moved",
                                      rule::not_negative),
      field<&Departure::largest_error>("largest", "null: nothing moved", rule::not_negative),
  };
  return fields;
}

const StructType& flip_fields() {
  using stats::Proportion;
  static const StructType fields{
      "Flips",
      field<&Departure::flips, &Proportion::successes>("count", "realisations"),
      field<&Departure::flips, &Proportion::trials>("of", "realisations", Rule{.least = 1.0}),
      field<&Departure::flips_interval>("interval", "of the share, Clopper-Pearson", rule::share),
  };
  return fields;
}

}  // namespace

static const StructType& fields_of(const Departure*) {
  static const StructType fields{
      "Departure",
      of_owner<Departure>("error", "largest difference in Theta, Theta', V at the ends of the first periods",
                          error_fields()),
      field<&Departure::diverged>("diverged",
                                  "realisations whose motion diverged from that of the reference before the horizon"),
      of_owner<Departure>("flips", "realisations with another response mode than at the reference", flip_fields()),
      of_owner<Departure>("beyond_floor",
                          "flips compared with those at the floor, the second tightest tolerance; null at the floor",
                          the_only<ExcessType>()),
      field<&Departure::first_flips>("first_flips", "at most five of them"),
  };
  return fields;
}

static const StructType& fields_of(const ToleranceCost*) {
  using Entry = ToleranceCost;
  static const StructType fields{
      "ToleranceCost",
      field<&Entry::tolerance>("tolerance", "of a step", rule::positive),
      field<&Entry::periods>("periods", "excitation periods run, of all realisations"),
      derived<[](const Entry& entry) { return entry.steps_per_period(); }>("steps_per_period", "steps in a period",
                                                                           rule::not_negative),
      field<&Entry::departure>("departure", "from the reference; null: this is the reference"),
  };
  return fields;
}

static const StructType& fields_of(const PlannedRealisations*) {
  using Planned = PlannedRealisations;
  static const StructType fields{
      "PlannedRealisations",
      field<&Planned::factor>("factor", "on the requested realisations", Rule{.least = 1.0}),
      field<&Planned::half_widths, &HalfWidths::mean>(
          "half_width_mean", "half-width of a condition's widest simultaneous interval, mean over the conditions",
          rule::share),
      field<&Planned::half_widths, &HalfWidths::widest>("half_width_widest", "the largest of all conditions",
                                                        rule::share),
      field<&Planned::half_widths, &HalfWidths::widest_wilson>("wilson_widest", "the same of Wilson's intervals",
                                                               rule::share),
      field<&Planned::periods>("periods", "of the whole run"),
  };
  return fields;
}

static const StructType& fields_of(const HalfWidthGoal*) {
  using Goal = HalfWidthGoal;
  static const StructType fields{
      "HalfWidthGoal",
      field<&Goal::half_width>("half_width", "in every condition", rule::positive),
      field<&Goal::needed, &RealisationsNeeded::by_shares>(
          "realisations", "of a condition, if the shares of the response modes stay the same"),
      field<&Goal::needed, &RealisationsNeeded::at_most>("at_most", "of a condition, whatever the shares are"),
      field<&Goal::periods>("periods", "of the whole run, with `realisations`"),
  };
  return fields;
}

namespace {

std::optional<double> tolerance_at(const Cost& cost, const std::optional<std::size_t>& place) {
  return place ? std::optional(cost.curve[*place].tolerance) : std::nullopt;
}

const StructType& sample_fields() {
  static const StructType fields{
      "CostSample",
      field<&Cost::sample>("realisations", "measured", Rule{.least = 1.0}),
      field<&Cost::sampled_conditions>("conditions", "from which they come", Rule{.least = 1.0}),
      field<&Cost::yardstick, &Yardstick::is_everything>("is_everything",
                                                         "nothing is random, and every condition was measured"),
  };
  return fields;
}

const StructType& recommendation_fields() {
  static const StructType fields{
      "Recommendation",
      derived<[](const Cost& cost) { return tolerance_at(cost, cost.recommendation.place); }>(
          "tolerance", "that is recommended; null: none", rule::positive),
      derived<[](const Cost& cost) { return tolerance_at(cost, cost.recommendation.coarsest); }>(
          "coarsest", "tolerance that suffices; null: none", rule::positive),
      field<&Cost::recommendation, &Recommendation::assurance>("assurance", "how good the evidence is",
                                                               the_only<NamedType<Assurance, assurance_names>>()),
      field<&Cost::yardstick, &Yardstick::half_width>("half_width", "mean of the intervals; null: nothing is random",
                                                      rule::not_negative),
      field<&Cost::recommendation, &Recommendation::bearable>("bearable", "share of flips that is too small to matter",
                                                              rule::share),
      derived<[](const Cost& cost) {
        return cost.recommendation.place ? std::optional(cost.recommendation.at_most) : std::nullopt;
      }>("at_most", "upper bound of the share of flips; null: no tolerance is recommended", rule::share),
      field<&Cost::recommendation, &Recommendation::sample_needed>(
          "sample_needed", "realisations that would show it; null: it is shown, or no number would show it"),
  };
  return fields;
}

}  // namespace

static const StructType& fields_of(const Cost*) {
  static const StructType fields{
      "Cost",
      of_owner<Cost>("sample", "what was measured", sample_fields()),
      derived<[](const Cost&) { return static_cast<std::uint64_t>(cost_error_periods); }>(
          "error_periods", "periods, from the start, over which errors are measured", Rule{.least = 1.0}),
      field<&Cost::curve>("tolerances", "by falling tolerance; the last is the reference"),
      field<&Cost::planned>("realisations", "with more realisations; empty: nothing is random"),
      field<&Cost::goals>("goals", "what a half-width needs; empty: nothing is random"),
      of_owner<Cost>("recommendation", "which tolerance to use", recommendation_fields()),
  };
  return fields;
}

namespace {

const StructType& timed_fields() {
  static const StructType fields{
      "MeasuredTime",
      field<&CostTiming::realisations>("realisations", "advanced together on each thread"),
      field<&CostTiming::periods>("periods", "of the longest horizon"),
  };
  return fields;
}

const StructType& system_fields() {
  using File = CostReport;
  static const StructType fields{
      "CostSystem",
      inlined<&File::system>(),
      field<&File::cost, &Cost::timing, &CostTiming::seconds_per_period>(
          "processor_s_per_period", "processor time in a period at each of `tolerances` [s]", rule::not_negative),
      field<&File::planned_seconds>(
          "planned_processor_s", "processor time of each of `realisations`, every condition at its own tolerance [s]",
          rule::not_negative),
      field<&File::cost, &Cost::timing>("timed", "how it was measured", timed_fields()),
      field<&File::recommendation>("recommendation", "in words"),
  };
  return fields;
}

bool names_its_tolerance(const Json& experiment) {
  const Json::json_pointer tolerance("/accuracy/tolerance");
  return experiment.is_null() || (experiment.contains(tolerance) && experiment.at(tolerance).is_number());
}

void check(const CostReport& report, const ReadingPlace& place) {
  const Cost& cost = report.cost;
  if (!names_its_tolerance(report.input.experiment)) {
    place.at("input").at("experiment").reject(report.input.experiment, "has no \"accuracy\" with a \"tolerance\"");
  }
  const auto has_length = [&place](std::string_view key, std::size_t found, std::size_t wanted) {
    if (found == wanted) return;
    place.at("system").at(key).reject(Json(found), "must have " + std::to_string(wanted) + " entries");
  };
  if (cost.curve.size() < 3) place.at("result").at("tolerances").reject(Json(), "must have at least three entries");
  has_length("processor_s_per_period", cost.timing.seconds_per_period.size(), cost.curve.size());
  has_length("planned_processor_s", report.planned_seconds.size(), cost.planned.size());
}

}  // namespace

const StructType& fields_of(const CostReport*) {
  static const StructType fields{
      "CostOfAccuracy",
      field<&CostReport::input>("input", "what was asked"),
      field<&CostReport::cost>("result", "what was measured, but for times"),
      of_owner<CostReport>("system", "on which machine, and how long it took", system_fields()),
  };
  return fields;
}

const DocumentOf<CostReport>& cost_document() {
  static const DocumentOf<CostReport> document("rocking.cost/1",
                                               "What accuracy costs in an experiment: tolerance against error, changed "
                                               "response modes and time; realisations against half-width and time.",
                                               check);
  return document;
}

CostReport cost_report(const MeasuredCost& measured) {
  CostReport report{.input = input_of(*measured.experiment),
                    .cost = measured.cost,
                    .system = measured.system,
                    .planned_seconds = {},
                    .recommendation = cost_recommendation(measured)};
  for (const PlannedRealisations& plan : measured.cost.planned) report.planned_seconds.push_back(plan.seconds);
  return report;
}

}  // namespace rocking
