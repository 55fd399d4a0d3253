#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/stats_fields.hpp"
#include "rocking/studies/infer/study.hpp"

namespace rocking {

template <>
struct TypeOf<ReachedBound> : OnlyType<NamedType<ReachedBound, reached_bound_names>> {};

namespace {

/// `true`, or the reason why not.
class IdentifiedType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    const auto& reason = static_cast<const Identified*>(value)->reason_why_not;
    return reason.empty() ? Json(true) : Json(reason);
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    auto& identified = *static_cast<Identified*>(value);
    if (json.is_string() && !json.get_ref<const std::string&>().empty()) {
      identified.reason_why_not = json.get<std::string>();
    } else if (json != Json(true)) {
      place.reject(json, "must be true or the reason why not");
    }
  }
  [[nodiscard]] Json schema(const Rule&) const override {
    return {{"oneOf", Json::array({{{"const", true}}, {{"type", "string"}, {"minLength", 1}}})}};
  }
};

}  // namespace

static const StructType& fields_of(const UnknownPosterior*) {
  using Type = UnknownPosterior;
  static const StructType fields{
      "UnknownPosterior",
      field<&Type::mean>("mean", "of the posterior"),
      field<&Type::median>("median", "of the posterior"),
      field<&Type::interval>("interval", "with equal tails"),
  };
  return fields;
}

namespace infer {

static const StructType& fields_of(const ProfilePoint*) {
  using Type = ProfilePoint;
  static const StructType fields{
      "ProfilePoint",
      field<&Type::at>("at", "value of the unknown"),
      field<&Type::likelihood_ratio>("likelihood_ratio", "largest likelihood with this value over the largest one",
                                     rule::share),
  };
  return fields;
}

static const StructType& fields_of(const RegionPoint*) {
  using Type = RegionPoint;
  static const StructType fields{
      "RegionPoint",
      field<&Type::at>("at", "values of the unknowns"),
      field<&Type::likelihood_ratio>("likelihood_ratio", "likelihood over the largest one", rule::share),
  };
  return fields;
}

static const StructType& fields_of(const DesignPoint*) {
  using Type = DesignPoint;
  static const StructType fields{
      "DesignPoint",
      field<&Type::at>("at", "values of the unknowns"),
      field<&Type::counts>("counts", "of realisations, by condition (candidates last) and by group"),
  };
  return fields;
}

}  // namespace infer

static const StructType& fields_of(const ReportedUnknown*) {
  using Type = ReportedUnknown;
  static const StructType fields{
      "Unknown",
      field<&Type::parameter>("parameter", "JSON pointer into the experiment"),
      field<&Type::from>("from", "smallest value, in the unit of the parameter"),
      field<&Type::to>("to", "largest value"),
      field<&Type::estimate>(
          "estimate", "where the likelihood is largest; null: the first design was not finished, or it was stopped"),
      field<&Type::interval>("interval", "by the profile likelihood; null as the estimate"),
      field<&Type::reaches>("reaches", "ends of the range that the interval reaches; null as the estimate"),
      field<&Type::profile>("profile", "likelihood, at the values of the grid of `region`"),
      field<&Type::posterior>("posterior", "with the priors of the experiment; null: it has none"),
  };
  return fields;
}

static const StructType& fields_of(const InferenceFit*) {
  using Type = InferenceFit;
  static const StructType fields{
      "InferenceFit",
      field<&Type::statistic>("statistic", "deviance of the counts from the shares at the estimate"),
      field<&Type::p_value>("p_value", "share of made-up data sets with a larger one", rule::share),
  };
  return fields;
}

static const StructType& fields_of(const ReportedTests*) {
  using Type = ReportedTests;
  static const StructType fields{
      "TestedCondition",
      field<&Type::parameters>("parameters", "JSON pointer to value"),
      field<&Type::counts>("counts", "of tests, by group"),
      field<&Type::predicted>("predicted", "shares at the estimate, by group", rule::share),
      field<&Type::intervals>("intervals", "Clopper-Pearson intervals of the counted shares, by group", rule::share),
  };
  return fields;
}

static const StructType& fields_of(const ReportedCandidate*) {
  using Type = ReportedCandidate;
  static const StructType fields{
      "CandidateCondition",
      field<&Type::parameters>("parameters", "JSON pointer to value"),
      field<&Type::region>("region", "expected size of the region over the present one, geometric mean",
                           rule::not_negative),
      field<&Type::deviations>("deviations", "expected standard deviations of the unknowns over the present ones",
                               rule::not_negative),
  };
  return fields;
}

namespace {

const StructType& settings_fields() {
  using File = InferReport;
  static const StructType fields{
      "InferSettings",
      field<&File::confidence>("confidence", "of the intervals and of the region", rule::confidence),
      field<&File::next_tests>("next_tests", "tests of a candidate condition"),
  };
  return fields;
}

}  // namespace

const StructType& fields_of(const InferReport*) {
  using File = InferReport;
  static const StructType fields{
      "Inference",
      field<&File::input>("input", "what was asked"),
      field<&File::seed>("seed", "of the experiment", seed_type()),
      of_owner<File>("settings", "of the answer", settings_fields()),
      field<&File::unknowns>("unknowns", "what the tests say of each"),
      field<&File::identified>("identified", "true, or why the tests cannot tell", the_only<IdentifiedType>()),
      field<&File::log_likelihood>("log_likelihood", "probability of the counts at the estimate, its logarithm"),
      field<&File::fit>("fit", "whether the estimate explains the counts"),
      field<&File::region_limit>("region_limit", "least likelihood ratio in the joint region", rule::share),
      field<&File::region>("region", "points of a grid within the joint region, and the estimate"),
      derived<[](const File& report) { return too_few_realisations(report); }>(
          "too_few_realisations",
          "that errors of the realisations outweigh the tests in the limits of the intervals and of the region; "
          "absent: they do not",
          {}, WithoutValue::omitted),
      field<&File::groups>("groups", "of response modes that were counted together; the last has all others"),
      field<&File::tests>("tests", "conditions that were tested"),
      field<&File::candidates>("candidates", "conditions that may be tested next"),
      field<&File::realisations>("realisations", "of all points of the design and all conditions"),
      field<&File::end>("ended", "why no more points were added to the design",
                        the_only<NamedType<InferEnd, infer_end_names>>()),
      field<&File::design>("design", "values of the unknowns at which was simulated"),
  };
  return fields;
}

const DocumentOf<InferReport>& infer_document() {
  static const DocumentOf<InferReport> document(
      "rocking.infer/1",
      "What counted tests say of unknown numbers. Without a time limit, equal input gives equal bytes.",
      check_infer_report);
  return document;
}

}  // namespace rocking
