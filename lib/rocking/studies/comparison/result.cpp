#include "rocking/studies/comparison/study.hpp"

#include <utility>

#include "rocking/fields/container_types.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/report_differences.hpp"
#include "rocking/output/stats_fields.hpp"

namespace rocking {

static const StructType& fields_of(const ModeComparison*) {
  using Mode = ModeComparison;
  using stats::McNemar;
  using stats::PairedCounts;
  static const StructType fields{
      "ModeComparison",
      field<&Mode::counts, &PairedCounts::both>("both", "realisations that have the mode in both runs"),
      field<&Mode::counts, &PairedCounts::first_only>("first_only", "in the first run only"),
      field<&Mode::counts, &PairedCounts::second_only>("second_only", "in the second run only"),
      field<&Mode::counts, &PairedCounts::neither>("neither", "in none"),
      field<&Mode::difference>("difference", "of the shares, first minus second", rule::difference_of_shares),
      field<&Mode::score>("score", "interval of the difference: Tango's", rule::difference_of_shares),
      field<&Mode::exact>("exact", "exact interval of the difference", rule::difference_of_shares),
      field<&Mode::test, &McNemar::p_value>("mcnemar_p_value", "exact test of whether the difference is 0",
                                            rule::share),
      field<&Mode::test, &McNemar::mid_p>("mcnemar_mid_p", "the same with mid-p", rule::share),
      field<&Mode::variance_reduction>("variance_reduction",
                                       "variance of the difference with independent random numbers over that with "
                                       "common ones; null where no two realisations differ"),
  };
  return fields;
}

static const StructType& fields_of(const ChangedModes*) {
  static const StructType fields{
      "ChangedModes",
      field<&ChangedModes::counts, &stats::Proportion::successes>("count", "number of them"),
      field<&ChangedModes::interval>("interval", "of their share: Clopper-Pearson", rule::share),
  };
  return fields;
}

static const StructType& fields_of(const ConditionComparison*) {
  using Compared = ConditionComparison;
  static const StructType fields{
      "ConditionComparison",
      field<&Compared::parameters>("parameters", "of the first run: JSON pointer to value"),
      field<&Compared::confidence>("confidence", "of the intervals of this condition", rule::confidence),
      field<&Compared::realisations>("realisations", "that both runs have"),
      field<&Compared::changed>("changed", "realisations with another response mode"),
      field<&Compared::modes>("modes", "those that occurred in either run"),
  };
  return fields;
}

const StructType& fields_of(const Comparison*) {
  static const StructType fields{
      "Comparison",
      field<&Comparison::settings>("settings", "what differs between the experiments, in words"),
      field<&Comparison::confidence>("confidence", "of the intervals of all conditions; null where it is swept",
                                     rule::confidence),
      derived<[](const Comparison& found) { return std::uint64_t{number_of_tests(found.conditions)}; }>(
          "tests", "number of p-values, which is needed to judge a single one"),
      field<&Comparison::conditions>("conditions", "one entry for each condition"),
  };
  return fields;
}

const DocumentOf<Comparison>& comparison_document() {
  static const DocumentOf<Comparison> document(
      "rocking.comparison/1", "Two runs compared realisation by realisation, with common random numbers.");
  return document;
}

Comparison comparison_of(const Experiment& first, const Experiment& second,
                         std::vector<ConditionComparison> conditions) {
  for (std::size_t i = 0; i < conditions.size(); ++i) conditions[i].parameters = first.conditions[i].parameters;
  return {.settings = experiment_differences(first.canonical_text, second.canonical_text),
          .confidence = common_confidence(first),
          .conditions = std::move(conditions)};
}

}  // namespace rocking
