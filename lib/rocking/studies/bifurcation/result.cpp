#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/output/validity_fields.hpp"
#include "rocking/studies/bifurcation/study.hpp"

namespace rocking {

constexpr std::array all_starts{std::string_view("initial"), std::string_view("continued")};

namespace {

using WrittenPoint = std::array<double, 2>;

WrittenPoint point_as_written(const section::StrobePoint& point) { return {point.tilt, point.tilt_rate}; }

void set_point(const WrittenPoint& read, const ReadingPlace&, section::StrobePoint& point) {
  point = {.tilt = read[0], .tilt_rate = read[1], .slip_rate = 0.0};
}

std::string start_as_written(const bool& is_continued) { return std::string(all_starts[is_continued ? 1 : 0]); }

void set_start(const std::string& read, const ReadingPlace&, bool& is_continued) {
  is_continued = read == all_starts[1];
}

using StartType = ConvertedType<bool, std::string, start_as_written, set_start>;

}  // namespace

template <>
struct TypeOf<section::StrobePoint>
    : OnlyType<ConvertedType<section::StrobePoint, WrittenPoint, point_as_written, set_point>> {};

static const StructType& fields_of(const ReportedStep*) {
  using Reported = ReportedStep;
  using section::Classification;
  constexpr auto step = &Reported::step;
  static const StructType fields{
      "DiagramStep",
      field<&Reported::value>("value", "of the parameter"),
      field<&Reported::branch>("branch",
                               "`initial`: from the initial state of the file; `upwards`, `downwards`: by "
                               "continuation, with increasing or decreasing parameter",
                               the_only<NamedType<DiagramBranch, branch_names>>()),
      field<step, &DiagramStep::continued>(
          "start",
          "`continued`: from the end of the previous step of the branch; `initial`: from the initial state of the "
          "file, as the first step of a branch and each step after one that did not reach its horizon",
          the_only<StartType>(), Rule{.choices = all_starts}),
      field<step, &DiagramStep::condition>("condition", "its number in the experiment"),
      field<&Reported::shaking>("shaking", "as in a report", rule::none, WithoutValue::omitted),
      field<step, &DiagramStep::termination>("termination", "why the run ended",
                                             the_only<NamedType<dynamics::Termination, dynamics::termination_names>>()),
      field<step, &DiagramStep::classification, &Classification::mode>("mode", "response mode"),
      field<step, &DiagramStep::classification, &Classification::reason>(
          "reason", "rule that gave the mode; null: the horizon was not reached"),
      field<step, &DiagramStep::points>("points",
                                        "[tilt, tilt_rate]: Theta and Theta' at the strobe instants of the sampled "
                                        "periods; empty: the horizon was not reached"),
  };
  return fields;
}

static const StructType& fields_of(const ReportedDiagram*) {
  using Reported = ReportedDiagram;
  static const StructType fields{
      "BifurcationDiagram",
      field<&Reported::others>("others", "JSON pointer to value, for each other entry of the sweep"),
      field<&Reported::steps>("steps", "by branch, then by increasing value",
                              the_only<LinesType<std::vector<ReportedStep>>>()),
  };
  return fields;
}

const StructType& fields_of(const BifurcationReport*) {
  using File = BifurcationReport;
  static const StructType fields{
      "BifurcationDiagrams",
      field<&File::input>("input", "what was asked"),
      field<&File::realisation>("realisation", "whose random numbers were used"),
      field<&File::parameter>("parameter", "JSON pointer to the swept parameter"),
      field<&File::diagrams>("diagrams", "one for each point of the grid of the other entries"),
  };
  return fields;
}

const DocumentOf<BifurcationReport>& bifurcation_document() {
  static const DocumentOf<BifurcationReport> document(
      "rocking.bifurcation/1",
      "The responses of one realisation along a swept parameter, from the initial state and by continuation.");
  return document;
}

BifurcationReport bifurcation_report(const Experiment& experiment, std::uint64_t realisation,
                                     const std::vector<Diagram>& diagrams) {
  BifurcationReport report{.input = input_of(experiment),
                           .realisation = realisation,
                           .parameter = experiment.conditions.front().parameters.front().pointer,
                           .diagrams = {}};
  for (const Diagram& diagram : diagrams) {
    const auto& parameters = experiment.conditions[diagram.conditions.front()].parameters;
    ReportedDiagram& reported = report.diagrams.emplace_back();
    reported.others.assign(parameters.begin() + 1, parameters.end());
    for (const DiagramBranch branch : all_branches) {
      for (const DiagramStep& step : diagram.branches[static_cast<std::size_t>(branch)]) {
        const Condition& condition = experiment.conditions[step.condition];
        reported.steps.push_back({.value = number_in(condition.parameters.front().value).value(),
                                  .branch = branch,
                                  .step = step,
                                  .shaking = shaking_of(condition.scene)});
      }
    }
  }
  return report;
}

}  // namespace rocking
