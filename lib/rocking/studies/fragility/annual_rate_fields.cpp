#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/stats_fields.hpp"
#include "rocking/studies/fragility/fields.hpp"
#include "rocking/studies/fragility/words.hpp"

namespace rocking {

template <>
struct TypeOf<RateSource> {
  static const ValueType& get() { return the_only<NamedType<RateSource, rate_source_names>>(); }
};

template <>
struct TypeOf<RareUse> {
  static const ValueType& get() { return the_only<NamedType<RareUse, rare_use_names>>(); }
};

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
          "`below_best_level`, that above the estimates with the most, or `up_to_highest` estimate; "
          "or `not_used`",
          {}, WithoutValue::omitted),
      field<&Rate::extrapolated_hazard>("extrapolated_hazard",
                                        "share of `value` from beyond the last point of the hazard curve, where it is "
                                        "continued",
                                        rule::share),
      field<&Rate::within_hazard>("within_hazard", "the rest of `value`, without that share [1/year]",
                                  rule::not_negative),
      field<&Rate::hazard_ends>("hazard_ends",
                                "intensity from which on the rate of the hazard curve is 0; absent: nowhere",
                                Rule{.above = 0.0}, WithoutValue::omitted),
      field<&Rate::frequent_hazard>(
          "frequent_hazard",
          "rate of the first point of the hazard curve where it is above one a year, which needs "
          "a look [1/year]",
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
          "the levels allow to the largest one, with a record "
          "that is not in the suite",
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
      field<&Comparison::interval>(
          "interval",
          "of it by bootstrap over records, the same in both, by shares with what the levels leave undecided; null: "
          "none"),
      field<&Comparison::ratio>("ratio", "rate of the option over that of the base; null: that is 0",
                                rule::not_negative),
      field<&Comparison::ratio_interval>("ratio_interval", "of it likewise; null: without an upper bound",
                                         optional_open_interval_type(), rule::not_negative),
  };
  return fields;
}

static const StructType& fields_of(const SurvivingBlock*) {
  using Block = SurvivingBlock;
  static const StructType fields{
      "SurvivingBlock",
      field<&Block::name>("name", "values of the rest of the sweep, title or folder of the run"),
      field<&Block::rate>("rate", "mean annual rate of the event [1/year]", rule::not_negative),
      field<&Block::rate_interval>("rate_interval", "of it; null: unknown", rule::not_negative),
      field<&Block::probability>("probability", "that the event has not happened: exp(-rate years)", rule::share),
      field<&Block::interval>("interval", "of it; null: that of the rate is", rule::share),
  };
  return fields;
}

static const StructType& fields_of(const SurvivalBranch*) {
  using Branch = SurvivalBranch;
  static const StructType fields{
      "SurvivalBranch",
      field<&Branch::hazard>("hazard", "file of the hazard curve"),
      field<&Branch::all>("all",
                          "that no block has had the event, `rate` that any has it; `probability` is the "
                          "likelihood of the branch"),
      field<&Branch::independent>("independent", "product of the probabilities of the blocks, without what they share",
                                  rule::share),
      field<&Branch::weight>("weight", "likelihood over the sum over the branches; 0: all are 0", rule::share),
      field<&Branch::blocks>("blocks", "each by itself"),
  };
  return fields;
}

const StructType& fields_of(const Survival*) {
  static const StructType fields{
      "Survival",
      field<&Survival::event>("event", "as of a curve"),
      field<&Survival::years>("years", "that have passed", Rule{.above = 0.0}),
      field<&Survival::source>("from",
                               "`law`, if it holds for every block and for all together; else `levels` or `isotonic`"),
      field<&Survival::branches>("branches", "one for each hazard curve"),
  };
  return fields;
}

}  // namespace rocking
