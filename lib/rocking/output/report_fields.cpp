#include <algorithm>
#include <vector>

#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/input/report_claims.hpp"
#include "rocking/output/ensemble_fields.hpp"
#include "rocking/output/findings.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/report.hpp"
#include "rocking/output/shaking_text.hpp"

namespace rocking {

static const StructType& fields_of(const ReportedCondition*) {
  using Reported = ReportedCondition;
  static const StructType fields{
      "Condition",
      field<&Reported::asked, &Condition::parameters>("parameters",
                                                      "JSON pointer to value, for each entry of the sweep"),
      field<&Reported::shaking>(
          "shaking",
          "amplitude and frequency of the base in every unit, for the mean block; absent under a ground motion",
          rule::none, WithoutValue::omitted),
      field<&Reported::scale>(
          "scale",
          "factor on the accelerations of the ground motion, of a random one the mean; absent under other excitations",
          rule::not_negative, WithoutValue::omitted),
      field<&Reported::floor>("floor", "of a building, on which the block stands; absent on the ground", rule::none,
                              WithoutValue::omitted),
      inlined<&Reported::result>(),
  };
  return fields;
}

/// `internal` of a report.
struct ReportedEffort {
  Effort total;
  std::vector<Effort> conditions;
};

namespace {

ReportedEffort internal_of(const Report& report) {
  ReportedEffort internal;
  for (const ReportedCondition& condition : report.conditions) {
    const Effort& effort = internal.conditions.emplace_back(
        Effort{.operations = condition.result.operations, .clamps = condition.result.validity.clamps});
    internal.total.operations += effort.operations;
    internal.total.clamps += effort.clamps;
  }
  return internal;
}

void set_operations(const ReportedEffort& read, const ReadingPlace&, Report& report) {
  for (std::size_t i = 0; i < std::min(read.conditions.size(), report.conditions.size()); ++i) {
    report.conditions[i].result.operations = read.conditions[i].operations;
  }
}

using InternalType = ConvertedType<Report, ReportedEffort, internal_of, set_operations>;

}  // namespace

static const StructType& fields_of(const ReportedEffort*) {
  static const StructType fields{
      "ReportedEffort",
      field<&ReportedEffort::total>("total", "of all conditions"),
      field<&ReportedEffort::conditions>("conditions", "of each"),
  };
  return fields;
}

/// Read over, and never written.
static Field warnings_of_earlier_programs() {
  return only_where<[](const Report&) { return false; }>(
      derived<[](const Report&) { return std::optional<std::vector<std::string>>(); }>(
          "warnings", "of earlier programs, in place of `findings`"));
}

const StructType& fields_of(const Report*) {
  static const StructType result{
      "RunResult",
      field<&Report::digest>("digest", "SHA-256 over the realisation results of all realisations, in order"),
      field<&Report::tolerance_sensitivity>("tolerance_sensitivity",
                                            "of all conditions together: response modes that change at a tighter "
                                            "tolerance with the same random numbers; null if none was rerun"),
      field<&Report::ground_motions>("ground_motions", "how each file was read; absent without recorded excitation",
                                     rule::none, WithoutValue::omitted),
      derived<[](const Report& report) {
        std::vector<Finding> findings = findings_of(report);
        std::erase_if(findings, [](const Finding& each) { return each.rating == Rating::fine; });
        return findings;
      }>("findings", "what a reader must know before using the result; absent, of earlier programs: none", {},
         WithoutValue::omitted),
      warnings_of_earlier_programs(),
      field<&Report::conditions>("conditions", "one entry for each point of the sweep"),
  };
  static const StructType fields{
      "Report",
      field<&Report::input>("input", "what was asked"),
      of_owner<Report>("result", "what was found", result),
      field<&Report::system>("system", "all that may differ between two equal runs"),
      of_owner<Report>("internal", "what was computed, by effect; 0 for an effect that is off",
                       the_only<InternalType>()),
  };
  return fields;
}

const DocumentOf<Report>& report_document() {
  static const DocumentOf<Report> document(report_format,
                                           "A run: all but `system` has the same bytes for equal input.");
  return document;
}

}  // namespace rocking
