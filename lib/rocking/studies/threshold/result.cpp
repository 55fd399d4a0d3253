#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/output/response_event_text.hpp"
#include "rocking/studies/threshold/study.hpp"

namespace rocking {

static const StructType& fields_of(const ThresholdPoint*) {
  using Point = ThresholdPoint;
  static const StructType fields{
      "ThresholdPoint",
      field<&Point::value>("value", "of the number"),
      field<&Point::impacts>("impacts", "until the fall or the horizon; 0 of a random scene"),
      field<&Point::termination>("termination", "why the motion ended",
                                 the_only<NamedType<dynamics::Termination, dynamics::termination_names>>()),
      field<&Point::counts, &stats::Proportion::trials>("realisations", "at this value; 1 where nothing is random"),
      field<&Point::counts, &stats::Proportion::successes>("happened", "those with the event"),
  };
  return fields;
}

static const StructType& fields_of(const ThresholdEdge*) {
  using Edge = ThresholdEdge;
  static const StructType fields{
      "ThresholdEdge",
      field<&Edge::stands>("stands", "side without the event"),
      field<&Edge::happens>("happens", "side with the event, an end of a band"),
  };
  return fields;
}

static const StructType& fields_of(const ThresholdOfCondition*) {
  using Bands = ThresholdBands;
  constexpr auto found = &ThresholdOfCondition::found;
  static const StructType fields{
      "ThresholdCondition",
      field<&ThresholdOfCondition::parameters>("parameters",
                                               "JSON pointer to value, for each other entry of the sweep"),
      derived<[](const ThresholdOfCondition& condition) {
        const auto& bands = condition.found.bands;
        return bands.empty() ? std::nullopt : std::optional(bands.front()[0]);
      }>("threshold", "smallest value at which the event happens; null: it happens nowhere in the range"),
      field<found, &Bands::bands>("bands", "[smallest, largest] value at which the event happens, by rising value"),
      derived<[](const ThresholdOfCondition& condition) { return condition.found.gaps(); }>(
          "gaps", "between two bands, [first, last] value at which the block stands again"),
      derived<[](const ThresholdOfCondition& condition) { return condition.found.begins_inside(); }>(
          "begins_inside", "whether the event happens at `from`, so that the first band may begin below"),
      derived<[](const ThresholdOfCondition& condition) { return condition.found.ends_inside(); }>(
          "ends_inside", "whether it happens at `to`, so that the last band may go on"),
      field<found, &Bands::edges>(
          "edges",
          "the two values that a bisection has left, by rising value; of a random scene the ends of a 95 % interval"),
      field<found, &Bands::without_answer>(
          "without_answer",
          "values of the scan at which the motion ended by a budget or by Painleve's paradox, counted as standing; of "
          "a random scene those at which the share of the event was not told from the probability"),
  };
  return fields;
}

const StructType& fields_of(const ThresholdReport*) {
  using File = ThresholdReport;
  using Question = ThresholdQuestion;
  constexpr auto study = &File::study;
  constexpr auto question = &ThresholdStudy::question;
  static const StructType fields{
      "Thresholds",
      field<&File::input>("input", "what was asked"),
      field<study, question, &Question::of>("parameter", "JSON pointer to the number"),
      field<study, question, &Question::event>("event", "as `--event` takes it", event_text_type()),
      field<study, question, &Question::from>("from", "smallest value of the scan"),
      field<study, question, &Question::to>("to", "largest value"),
      field<study, question, &Question::probability>(
          "probability", "of a random scene: that of the event at an end of a band; else null", rule::confidence),
      field<study, question, &Question::realisations>("realisations", "of a random scene: most of them at one value"),
      field<study, question, &Question::steps>(
          "steps", "equal ones, of the scan; a band or a gap that is narrower than one may be missed"),
      field<study, question, &Question::accuracy>(
          "accuracy", "of an edge over its value, up to which it was bisected; 0: to neighbouring doubles",
          rule::not_negative),
      field<study, &ThresholdStudy::conditions>("conditions", "for each combination of the other values of the sweep"),
  };
  return fields;
}

const DocumentOf<ThresholdReport>& threshold_document() {
  static const DocumentOf<ThresholdReport> document(
      "rocking.threshold/1",
      "Where in a range of one number an event happens: its bands, by a scan and bisection; of a random scene, where "
      "its probability passes a given one.",
      [](const ThresholdReport& report, const ReadingPlace& place) { check_input(report.input, place.at("input")); });
  return document;
}

}  // namespace rocking
