#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/stats_fields.hpp"
#include "rocking/studies/curves/look.hpp"

namespace rocking {

static const StructType& fields_of(const SuiteEstimate*) {
  using Found = SuiteEstimate;
  static const StructType fields{
      "SuiteEstimate",
      field<&Found::value>("value", "estimate", rule::not_negative),
      field<&Found::interval>("interval", "by profile likelihood; null: without an upper bound", open_interval_type(),
                              rule::not_negative),
      field<&Found::bootstrap>("bootstrap", "interval by bootstrap over records; null: too few samples with a law",
                               rule::not_negative),
  };
  return fields;
}

namespace {

const StructType& pooled_median_fields() {
  static const StructType fields{
      "PooledMedian",
      inlined<&PooledSuite::median>(),
      field<&PooledSuite::is_extrapolated>("extrapolated", "whether it lies outside the levels"),
  };
  return fields;
}

const StructType& bootstrap_fields() {
  using Bootstrap = stats::RecordBootstrap;
  static const StructType fields{
      "Bootstrap",
      field<&Bootstrap::samples>("samples", "of the records"),
      derived<[](const Bootstrap& bootstrap) { return std::uint64_t{bootstrap.laws.size()}; }>(
          "with_law", "samples that have a law"),
  };
  return fields;
}

}  // namespace

static const StructType& fields_of(const PooledSuite*) {
  using Pooled = PooledSuite;
  static const StructType fields{
      "PooledSuite",
      of_owner<Pooled>("median", "of the law", pooled_median_fields()),
      field<&Pooled::dispersion>("dispersion", "standard deviation of the logarithm of the capacity"),
      field<&Pooled::between_records>("between_records", "its part between records"),
      field<&Pooled::within_record>("within_record", "its part within a record"),
      field<&Pooled::log_likelihood>("log_likelihood", "without binomial coefficients"),
  };
  return fields;
}

static const StructType& fields_of(const SuiteLevel*) {
  using Level = SuiteLevel;
  static const StructType fields{
      "SuiteLevel",
      field<&Level::intensity>("intensity", "of the excitation", Rule{.above = 0.0}),
      field<&Level::records>("records", "at this intensity", Rule{.least = 1.0}),
      field<&Level::overturned, &stats::Proportion::trials>("realisations", "sum over the records", Rule{.least = 1.0}),
      field<&Level::overturned, &stats::Proportion::successes>("overturned", "those with the event"),
      count_if_any<&Level::unresolved>("unresolved", unresolved_sentence),
      field<&Level::estimate>("estimate", "mean over the records of their shares", rule::share),
      field<&Level::fitted>("fitted", "by the law of the suite; null: no law", rule::share),
      field<&Level::band>("band", "of `fitted` by bootstrap over records; null: too few samples with a law",
                          rule::share),
      field<&Level::isotonic>("isotonic", "the nearest to the estimates of all levels that does not decrease",
                              rule::share),
      field<&Level::isotonic_band>("isotonic_band", "of `isotonic` by bootstrap over records", rule::share),
  };
  return fields;
}

static const StructType& fields_of(const RecordCurve*) {
  static const StructType fields{
      "RecordCurve",
      field<&RecordCurve::name>("name", "path of the ground motion, as in the experiment"),
      inlined<&RecordCurve::curve>(),
  };
  return fields;
}

static const StructType& fields_of(const RankedMeasure*) {
  using Ranked = RankedMeasure;
  static const StructType fields{
      "RankedMeasure",
      field<&Ranked::measure>("measure", "of intensity",
                              the_only<NamedType<IntensityMeasure, intensity_measure_names>>()),
      field<&Ranked::median>("median", "of the law in this measure; null with the following ones: none fitted",
                             rule::not_negative),
      field<&Ranked::dispersion>("dispersion", "of the same law", rule::not_negative),
      field<&Ranked::between_records>("between_records", "its part between records", rule::not_negative),
      field<&Ranked::within_record>("within_record", "its part within a record", rule::not_negative),
      field<&Ranked::deviance>("deviance", "-2 ln likelihood, without binomial coefficients"),
      field<&Ranked::aic>("aic", "deviance + 6 (Akaike)"),
  };
  return fields;
}

const StructType& fields_of(const SuiteCurve*) {
  using Curve = SuiteCurve;
  static const StructType fields{
      "SuiteCurve",
      inlined<&Curve::subject>(),
      field<&Curve::outcome>("outcome", "of the pooled law"),
      field<&Curve::pooled>("pooled", "law of the suite, also if it is `rejected`; null: none"),
      field<&Curve::test>("test", "of this law; null: none"),
      field<&Curve::bootstrap>("bootstrap", "over records", bootstrap_fields()),
      field<&Curve::levels>("levels", "all records together, by increasing intensity"),
      field<&Curve::rare>(
          "rare", "with `--rare`: small probabilities, by increasing intensity; of a suite the means over its records",
          {}, WithoutValue::omitted),
      field<&Curve::records>("records", "each record's own curve"),
      field<&Curve::measures>("measures", "of intensity, best first"),
  };
  return fields;
}

template <>
struct TypeOf<RareUse> : OnlyType<NamedType<RareUse, rare_use_names>> {};

static const StructType& fields_of(const RateInRange*) {
  static const StructType fields{
      "RateInRange",
      field<&RateInRange::from>("from", "lower end of the range of intensity", rule::not_negative),
      field<&RateInRange::to>("to", "its upper end; null: no end", rule::not_negative),
      field<&RateInRange::rate>("rate", "part of the rate [1/year]", rule::not_negative),
      field<&RateInRange::share>("share", "of the whole rate", rule::not_negative),
      field<&RateInRange::is_tested>(
          "tested", "whether the range lies between the lowest level that can lift the block and the highest level"),
  };
  return fields;
}

static const StructType& fields_of(const RateInYears*) {
  static const StructType fields{
      "RateInYears",
      field<&RateInYears::years>("years", "as asked", Rule{.above = 0.0}),
      field<&RateInYears::probability>("probability", "that the event happens in these years: 1 - exp(-value years)",
                                       rule::share),
      field<&RateInYears::interval>("interval", "of it; null: that of the rate is", rule::share),
  };
  return fields;
}

const StructType& fields_of(const AnnualRate*) {
  using Rate = AnnualRate;
  static const StructType fields{
      "AnnualRate",
      field<&Rate::value>("value", "mean annual rate of the event from intensities of at least `least_uplift` [1/year]",
                          rule::not_negative),
      field<&Rate::interval>("interval", "of the probabilities' uncertainty, the hazard taken as exact; null: unknown",
                             rule::not_negative),
      field<&Rate::source>("from",
                           "what gives the probabilities: the fitted law, or the levels (of a suite: their isotonic "
                           "shares), interpolated"),
      field<&Rate::impossible>("impossible",
                               "what the law, or of one motion without a law the interpolated levels, gives below "
                               "`least_uplift`; not part of `value` [1/year]",
                               rule::not_negative),
      field<&Rate::below_levels>("below_levels",
                                 "part of `value` below the lowest level that can lift the block [1/year]",
                                 rule::not_negative),
      field<&Rate::untested_share>("untested_share", "sum of the shares of the ranges that are not tested",
                                   rule::not_negative),
      field<&Rate::probability_at_first>("probability_at_first",
                                         "at the lowest intensity of the hazard curve, below which nothing is counted; "
                                         "0: the block is not lifted there",
                                         rule::share),
      field<&Rate::rare_below>("rare_below",
                               "below this intensity the rare estimates give the probabilities; absent: there are none",
                               rule::not_negative, WithoutValue::omitted),
      field<&Rate::rare_use>(
          "rare_use",
          "with `--rare`: `below_sure_level`, the lowest with ten events; where no level has so many: "
          "`below_best_level`, that above the estimates with the most, or `up_to_highest` estimate; or `not_used`",
          {}, WithoutValue::omitted),
      field<&Rate::extrapolated_hazard>(
          "extrapolated_hazard",
          "share of `value` from beyond the last point of the hazard curve, where it is continued", rule::share),
      field<&Rate::within_hazard>("within_hazard", "the rest of `value`, without that share [1/year]",
                                  rule::not_negative),
      field<&Rate::hazard_ends>("hazard_ends",
                                "intensity from which on the rate of the hazard curve is 0; absent: nowhere",
                                Rule{.above = 0.0}, WithoutValue::omitted),
      field<&Rate::frequent_hazard>(
          "frequent_hazard",
          "rate of the first point of the hazard curve where it is above one a year, which needs a look [1/year]",
          Rule{.above = 0.0}, WithoutValue::omitted),
      derived<[](const AnnualRate& rate) {
        std::vector<std::string> warnings = hazard_warnings(rate);
        return warnings.empty() ? std::nullopt : std::optional(std::move(warnings));
      }>("warnings", "what the hazard curve lacks, and that it or the event is too frequent to be believed", {},
         WithoutValue::omitted),
      field<&Rate::by_level>("by_level", "disaggregation by intensity"),
      field<&Rate::in_years>("in_years", "probabilities of the event, with `--years`", {}, WithoutValue::omitted),
  };
  return fields;
}

static const StructType& fields_of(const RateEstimate*) {
  static const StructType fields{
      "RateEstimate",
      field<&RateEstimate::source>("from",
                                   "`law`; `isotonic`: mean shares of the records, made not to decrease, interpolated"),
      field<&RateEstimate::value>("value", "mean annual rate [1/year]", rule::not_negative),
      field<&RateEstimate::interval>(
          "interval",
          "by the law by bootstrap over records, null: too few samples with a law; by shares from the least rate that "
          "the levels allow to the largest one, with a record that is not in the suite",
          rule::not_negative),
  };
  return fields;
}

static const StructType& fields_of(const RateOfRecord*) {
  using Record = RateOfRecord;
  static const StructType fields{
      "RateOfRecord",
      field<&Record::name>("name", "path of the ground motion, as in the experiment"),
      field<&Record::rate>("rate", "by the shares of this record alone [1/year]", rule::not_negative),
      field<&Record::share>("share", "of the sum over the records", rule::share),
  };
  return fields;
}

const StructType& fields_of(const SuiteRate*) {
  using Rate = SuiteRate;
  static const StructType fields{
      "SuiteRate",
      inlined<&Rate::chosen>(),
      field<&Rate::estimates>("estimates", "the rate by the law, if there is one, and by isotonic shares"),
      field<&Rate::disagreement>(
          "disagreement", "larger over smaller of the rates by law and by isotonic shares, less 1; null: one is 0",
          rule::not_negative),
      field<&Rate::at_most>("at_most",
                            "the largest rate that the levels allow: below them the probability is their first share, "
                            "above them 1 [1/year]",
                            rule::not_negative),
      field<&Rate::undecided_share>("undecided_share", "part of the isotonic rate that the levels leave open",
                                    rule::not_negative),
      field<&Rate::add_levels>("add_levels", "intensities to add; empty: the rates agree and little is open",
                               Rule{.above = 0.0}),
      field<&Rate::by_record>("by_record", "disaggregation by record"),
  };
  return fields;
}

const StructType& fields_of(const RateComparison*) {
  using Comparison = RateComparison;
  static const StructType fields{
      "RateComparison",
      field<&Comparison::base>("base", "values of the other entries of the sweep in the first suite"),
      field<&Comparison::option>("option", "in the one that is compared with it"),
      field<&Comparison::event>("event", "as of a curve"),
      field<&Comparison::source>("from", "what gives the probabilities of both rates, as of `annual_rate`"),
      field<&Comparison::difference>("difference", "rate of the option less that of the base [1/year]"),
      field<&Comparison::interval>("interval",
                                   "of it by bootstrap over records, the same in both, by shares with what the levels "
                                   "leave undecided; null: none"),
      field<&Comparison::ratio>("ratio", "rate of the option over that of the base; null: that is 0",
                                rule::not_negative),
      field<&Comparison::ratio_interval>("ratio_interval", "of it likewise; null: without an upper bound",
                                         optional_open_interval_type(), rule::not_negative),
  };
  return fields;
}

}  // namespace rocking
