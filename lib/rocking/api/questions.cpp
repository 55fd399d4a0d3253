#include "rocking/api/questions.hpp"

#include <array>
#include <string_view>
#include <vector>

#include "rocking/fields/container_types.hpp"
#include "rocking/input/record_formats.hpp"
#include "rocking/scene/counted_tests.hpp"
#include "rocking/section/classification.hpp"

namespace rocking {
namespace {

template <const StructType& (*fields)()>
const ValueType& struct_type() {
  return fields();
}

/// A list of structs that have these fields in questions.
template <class Item, const StructType& (*fields)()>
const ValueType& list_of() {
  return the_only<ListType<std::vector<Item>, 0, struct_type<fields>>>();
}

const Rule tilt_rule{.least = 1e-9, .most = 1e9};

const StructType& repetition_fields() {
  using rare::Repetition;
  static const StructType fields{
      "Repetition",
      field<&Repetition::estimate>("estimate", "of the probability", rule::not_negative),
      field<&Repetition::ancestors>("ancestors", "first trajectories from which those with the event descend"),
      field<&Repetition::work>("work", "in realisations to the horizon", rule::not_negative),
  };
  return fields;
}

const StructType& earlier_fields() {
  static const StructType fields{
      "RareEstimate",
      field<&RareEstimate::repetitions>("repetitions", "that are not made again",
                                        list_of<rare::Repetition, repetition_fields>()),
  };
  return fields;
}

const StructType& rare_level_fields() {
  static const StructType fields{
      "RareLevel",
      field<&RareLevel::intensity>("intensity", "of the excitation", rule::positive),
      field<&RareLevel::probability>("probability", "of the event", rule::confidence),
      field<&RareLevel::interval, &stats::Interval::low>("low", "of the probability", rule::share),
      field<&RareLevel::interval, &stats::Interval::high>("high", "of the probability", rule::share),
      // All of the sum in one repetition gives 1, but for rounding.
      field<&RareLevel::relative_error>("relative_error", "standard error over the probability",
                                        Rule{.above = 0.0, .most = 1.000001}),
      field<&RareLevel::degrees_of_freedom>("degrees_of_freedom", "of the error", Rule{.least = 1.0}),
  };
  return fields;
}

const StructType& rare_record_fields() {
  using OfRecord = RareOfCurve::OfRecord;
  static const StructType fields{
      "RareOfRecord",
      field<&OfRecord::name>("name", "of the ground motion"),
      field<&OfRecord::level>("level", "under it", rare_level_fields()),
  };
  return fields;
}

const StructType& rare_of_curve_fields() {
  static const StructType fields{
      "RareOfCurve",
      field<&RareOfCurve::event, &FragilityEvent::peak_tilt>("peak_tilt", "of the event; absent: overturning",
                                                             tilt_rule),
      field<&RareOfCurve::level>("level", "of a suite the mean over the records", rare_level_fields()),
      field<&RareOfCurve::records>("records", "of a suite", list_of<RareOfCurve::OfRecord, rare_record_fields>()),
  };
  return fields;
}

const StructType& metadata_fields() {
  static const StructType fields{
      "RecordMetadata",
      field<&RecordMetadata::file>("file", "as in the experiment, or its last part"),
      field<&RecordMetadata::magnitude>("magnitude", "moment magnitude"),
      field<&RecordMetadata::distance_km>("distance_km", "from the source", rule::positive),
  };
  return fields;
}

/// Of a condition, by group.
const Rule tests_rule{.most = static_cast<double>(most_tests)};

const StructType& tested_condition_fields() {
  static const StructType fields{
      "TestedCondition",
      field<&TestedCondition::counts>("counts", "of tests by group", tests_rule),
  };
  return fields;
}

const StructType& design_point_fields() {
  using infer::DesignPoint;
  static const StructType fields{
      "DesignPoint",
      field<&DesignPoint::at>("at", "values of the unknowns"),
      field<&DesignPoint::counts>("counts", "of realisations, by condition and by group"),
  };
  return fields;
}

constexpr std::array<std::string_view, 3> sampler_names{"box-muller", "ziggurat", "inverse-cdf"};

}  // namespace

const StructType& fields_of(const CostRequest*) {
  static const StructType fields{
      "CostRequest",
      field<&CostRequest::seconds>("seconds", "wall-clock time to spend [s]", rule::positive),
      field<&CostRequest::sample>("sample", "realisations to measure", Rule{.least = 1.0, .most = 100'000.0}),
      field<&CostRequest::tolerances>("tolerances", "beside those of the experiment",
                                      Rule{.least = 1e-16, .most = 1e-2}),
  };
  return fields;
}

const StructType& fields_of(const Execution*) {
  static const StructType fields{
      "Execution",
      field<&Execution::threads>("threads", "of the computation", Rule{.least = 1.0, .most = 4096.0}),
  };
  return fields;
}

const StructType& fields_of(const FragilityQuestion*) {
  using Type = FragilityQuestion;
  static const StructType fields{
      "FragilityQuestion",
      field<&Type::peak_tilts>("peak_tilts", "whose exceedance is an event", tilt_rule),
      field<&Type::rare>("rare", "small probabilities of the same blocks",
                         list_of<RareOfCurve, rare_of_curve_fields>()),
      field<&Type::metadata>("metadata", "of the records of suites", list_of<RecordMetadata, metadata_fields>()),
  };
  return fields;
}

const StructType& fields_of(const GroundMotionRequest*) {
  using Type = GroundMotionRequest;
  using Question = MotionQuestion;
  static const StructType fields{
      "GroundMotionRequest",
      field<&Type::format>("format", "of the files", Rule{.choices = record_format_choices}),
      field<&Type::columns>("columns", "of the files", Rule{.choices = record_column_names}),
      field<&Type::units>("units", "of the accelerations", Rule{.choices = record_unit_names}),
      field<&Type::time_step>("time_step", "of columns without times [s]", rule::positive),
      field<&Type::question, &Question::gravity>("gravity", "1 g [m/s^2]", rule::positive),
      field<&Type::question, &Question::damping>("damping", "of the response spectrum",
                                                 Rule{.least = 0.0, .below = 1.0}),
      field<&Type::question, &Question::periods>("periods", "of the response spectrum [s]", rule::positive),
  };
  return fields;
}

const StructType& fields_of(const InferRequest*) {
  using Type = InferRequest;
  static const StructType fields{
      "InferRequest",
      field<&Type::tests, &CountedTests::conditions>("tests", "by tested condition",
                                                     list_of<TestedCondition, tested_condition_fields>()),
      field<&Type::next_tests>("next_tests", "of a candidate condition", Rule{.least = 1.0, .most = 1000.0}),
      field<&Type::seconds>("seconds", "after which no points are added [s]", rule::positive),
      field<&Type::earlier>("earlier", "points of an earlier answer",
                            list_of<infer::DesignPoint, design_point_fields>()),
  };
  return fields;
}

const StructType& fields_of(const OrbitsRequest*) {
  using Type = OrbitsRequest;
  static const StructType fields{
      "OrbitsRequest",
      field<&Type::longest>("longest", "largest period, in excitation periods",
                            Rule{.least = 1.0, .most = static_cast<double>(section::longest_period)}),
      field<&Type::from>("from", "smallest value of the parameter for branches"),
      field<&Type::to>("to", "largest value"),
      field<&Type::most_points>("most_points", "of a branch", Rule{.least = 2.0, .most = 1e6}),
      field<&Type::most_branches>("most_branches", "that are followed", Rule{.least = 1.0, .most = 1e5}),
      field<&Type::second_from>("second_from", "smallest value of the second parameter"),
      field<&Type::second_to>("second_to", "largest value"),
      field<&Type::most_curve_points>("most_curve_points", "of a curve in each direction",
                                      Rule{.least = 1.0, .most = 1e6}),
  };
  return fields;
}

const StructType& fields_of(const Provenance*) {
  static const StructType fields{
      "Provenance",
      field<&Provenance::duration_s>("duration_s", "of the run [s]", rule::not_negative),
      field<&Provenance::threads>("threads", "of the run"),
  };
  return fields;
}

const StructType& fields_of(const RareRequest*) {
  using Type = RareRequest;
  static const StructType fields{
      "RareRequest",
      field<&Type::question, &RareQuestion::event, &rare::Event::peak_tilt>(
          "peak_tilt", "that abs(Theta) exceeds; absent: overturning", Rule{.least = 0.0, .most = 100.0}),
      field<&Type::question, &RareQuestion::relative_error>(
          "relative_error", "standard error over the probability that is aimed at", Rule{.least = 1e-3, .most = 1.0}),
      field<&Type::particles>("particles", "trajectories of a repetition", Rule{.least = 20.0, .most = 100'000.0}),
      field<&Type::seconds>("seconds", "for all conditions together [s]", rule::positive),
      field<&Type::earlier>("earlier", "estimates of an earlier study, by condition",
                            list_of<RareEstimate, earlier_fields>()),
  };
  return fields;
}

const StructType& fields_of(const SamplerQuestion*) {
  using Type = SamplerQuestion;
  static const StructType fields{
      "SamplerQuestion",
      field<&Type::n>("n", "how many numbers", Rule{.least = 20.0, .most = 1e8}),
      field<&Type::law, &stats::NormalLaw::mean>("mean", "of the distribution", Rule{.least = -1e6, .most = 1e6}),
      // The fourth power of a smaller one is no normal double.
      field<&Type::law, &stats::NormalLaw::sigma>("sigma", "standard deviation", Rule{.least = 1e-70, .most = 1e6}),
      field<&Type::sampler>("sampler", "how normal numbers are made", Rule{.choices = sampler_names}),
  };
  return fields;
}

const StructType& fields_of(const TrajectoryRequest*) {
  using Type = TrajectoryRequest;
  static const StructType fields{
      "TrajectoryRequest",
      field<&Type::condition>("condition", "from 0"),
      field<&Type::realisation>("realisation", "from 0", Rule{.most = 999'999'999.0}),
      field<&Type::periods>("periods", "of the excitation", Rule{.least = 1.0, .most = 1e8}),
      field<&Type::samples_per_period>("samples_per_period", "of the history", Rule{.least = 0.0, .most = 1e5}),
  };
  return fields;
}

}  // namespace rocking
