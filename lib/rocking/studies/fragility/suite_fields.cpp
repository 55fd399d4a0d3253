#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/stats_fields.hpp"
#include "rocking/studies/fragility/fields.hpp"

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

using TiltQuantiles = decltype(PeakTiltLevel::quantiles);
using WrittenTiltQuantiles = std::array<std::array<std::optional<double>, 2>, peak_tilt_shares.size()>;

WrittenTiltQuantiles written_quantiles(const TiltQuantiles& quantiles) {
  WrittenTiltQuantiles list;
  for (std::size_t i = 0; i < list.size(); ++i) list[i] = {peak_tilt_shares[i], quantiles[i]};
  return list;
}

void set_quantiles(const WrittenTiltQuantiles& list, const ReadingPlace& place, TiltQuantiles& quantiles) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (list[i][0] != peak_tilt_shares[i]) {
      place.at(std::to_string(i)).reject(Json(), "must begin with its share: 0.16, 0.5 and 0.84");
    }
    quantiles[i] = list[i][1];
  }
}

using TiltQuantilesType = ConvertedType<TiltQuantiles, WrittenTiltQuantiles, written_quantiles, set_quantiles>;

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
      field<&Level::happened, &stats::Proportion::trials>("realisations", "sum over the records", Rule{.least = 1.0}),
      field<&Level::happened, &stats::Proportion::successes>("overturned", "those with the event"),
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

static const StructType& fields_of(const SuiteCurve*) {
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

const StructType& fields_of(const ReportedSuite*) {
  static const StructType fields{
      "SuiteFragility",
      inlined<&ReportedSuite::run>(),
      inlined<&ReportedSuite::curve>(),
      field<&ReportedSuite::rate>("annual_rate", "with `--hazard`", {}, WithoutValue::omitted),
  };
  return fields;
}

static const StructType& fields_of(const PeakTiltLevel*) {
  using Level = PeakTiltLevel;
  static const StructType fields{
      "PeakTiltLevel",
      field<&Level::intensity>("intensity", "of the excitation", rule::not_negative),
      field<&Level::trials>("realisations", "under all records, or under one"),
      field<&Level::overturned>("overturned", "those that overturned"),
      field<&Level::quantiles>("quantiles", "[share, value] of the peak of abs(theta)/psi; null: overturned",
                               the_only<TiltQuantilesType>()),
  };
  return fields;
}

static const StructType& fields_of(const Resurrections*) {
  static const StructType fields{
      "Resurrections",
      field<&Resurrections::trials>("trials", "that stand at a level and overturned at a weaker one"),
      field<&Resurrections::of>("of", "those that overturned at some level"),
  };
  return fields;
}

static const StructType& fields_of(const PeakTiltCurve*) {
  static const StructType fields{
      "PeakTiltCurve",
      field<&PeakTiltCurve::record>("name", "path of the ground motion; empty without a suite"),
      field<&PeakTiltCurve::resurrections>("resurrections", "under this record"),
      field<&PeakTiltCurve::levels>("levels", "by increasing intensity"),
  };
  return fields;
}

static const StructType& fields_of(const IncrementalAnalysis*) {
  using Analysis = IncrementalAnalysis;
  static const StructType fields{
      "IncrementalAnalysis",
      field<&Analysis::parameter>("parameter", "JSON pointer to the intensity"),
      field<&Analysis::others>("others", "values of the other entries of the sweep"),
      field<&Analysis::resurrections>("resurrections", "sum over the records"),
      field<&Analysis::all>("levels", "of all records"),
      field<&Analysis::records>("records", "of each record"),
  };
  return fields;
}

const StructType& fields_of(const ReportedAnalysis*) {
  static const StructType fields{
      "ReportedAnalysis",
      inlined<&ReportedAnalysis::run>(),
      inlined<&ReportedAnalysis::analysis>(),
  };
  return fields;
}

}  // namespace rocking
