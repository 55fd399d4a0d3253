#include "rocking/fields/container_types.hpp"
#include "rocking/fields/converted_type.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/output/stats_fields.hpp"
#include "rocking/studies/rare/study.hpp"
#include "rocking/studies/rare/summarise.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {

namespace {

/// `[estimate, work, ancestors]`, and `unresolved` where it is not 0.
class RepetitionType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    const auto& repetition = *static_cast<const rare::Repetition*>(value);
    Json numbers = Json::array({repetition.estimate, repetition.work, repetition.ancestors});
    if (repetition.unresolved > 0.0) numbers.push_back(repetition.unresolved);
    return numbers;
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    std::vector<double> numbers;
    type_of<std::vector<double>>().read(json, place, &numbers);
    if (numbers.size() != least && numbers.size() != most) return place.reject(json, "must have 3 numbers, or 4");
    auto& repetition = *static_cast<rare::Repetition*>(value);
    repetition.estimate = numbers[0];
    repetition.work = numbers[1];
    repetition.ancestors = static_cast<std::size_t>(numbers[2]);
    if (numbers.size() == most) repetition.unresolved = numbers[3];
  }
  [[nodiscard]] Json schema(const Rule&) const override {
    Json schema = type_of<std::vector<double>>().schema(rule::not_negative);
    schema.update({{"minItems", least}, {"maxItems", most}});
    return schema;
  }

 private:
  static constexpr std::size_t least = 3;
  static constexpr std::size_t most = 4;
};

}  // namespace

template <>
struct TypeOf<rare::Repetition> : OnlyType<RepetitionType> {};

namespace {

/// What a figure shows, and no more.
double rounded(double number) {
  constexpr int digits = 4;
  return std::stod(significant(number, digits));
}

Json rounded_list(const std::vector<double>& numbers) {
  Json list = Json::array();
  for (const double number : numbers) list.push_back(rounded(number));
  return list;
}

/// A list of numbers for figures.
class RoundedType final : public ValueType {
 public:
  [[nodiscard]] Json json(const void* value) const override {
    return rounded_list(*static_cast<const std::vector<double>*>(value));
  }
  void read(const Json& json, const ReadingPlace& place, void* value) const override {
    type_of<std::vector<double>>().read(json, place, value);
  }
  [[nodiscard]] Json schema(const Rule& rule) const override { return type_of<std::vector<double>>().schema(rule); }
};
const ValueType& rounded_type() { return the_only<RoundedType>(); }

/// A line for each list.
const ValueType& rounded_lines_type() { return the_only<LinesType<std::vector<std::vector<double>>, rounded_type>>(); }

}  // namespace

/// `[Theta, Theta']`.
template <>
struct TypeOf<rare::StrobeState> {
  class Type final : public ValueType {
   public:
    [[nodiscard]] Json json(const void* value) const override {
      const auto& state = *static_cast<const rare::StrobeState*>(value);
      return rounded_list({state.tilt, state.tilt_rate});
    }
    void read(const Json& json, const ReadingPlace& place, void* value) const override {
      std::array<double, 2> numbers{};
      type_of<std::array<double, 2>>().read(json, place, &numbers);
      *static_cast<rare::StrobeState*>(value) = {numbers[0], numbers[1]};
    }
    [[nodiscard]] Json schema(const Rule& rule) const override { return type_of<std::array<double, 2>>().schema(rule); }
  };
  static const ValueType& get() { return the_only<Type>(); }
};

// Found beside their structs.
namespace rare {

static const StructType& fields_of(const Path::Given*) {
  using Given = Path::Given;
  static const StructType fields{
      "RareGiven",
      field<&Given::source>("source", "name of the source"),
      field<&Given::number>("number", "in place of its draw"),
      field<&Given::index>("index", "of the draw"),
  };
  return fields;
}

static const StructType& fields_of(const Path::Branch*) {
  using Branch = Path::Branch;
  static const StructType fields{
      "RareBranch",
      field<&Branch::number>("number", "realisation number of its draws along the way", seed_type()),
      field<&Branch::from>("from", "by the number of the source: the index of the first draw that is its own"),
  };
  return fields;
}

static const StructType& fields_of(const Path*) {
  static const StructType fields{
      "RarePath",
      field<&Path::number>("number", "realisation number of its draws", seed_type()),
      field<&Path::given>("given", "numbers in place of draws"),
      field<&Path::branches>("branches", "where it goes on with the draws of other numbers, in order",
                             the_only<LinesType<std::vector<Path::Branch>>>()),
      field<&Path::samples_per_period>("samples_per_period", "of `tilts`", Rule{.least = 1.0}),
      field<&Path::tilts>("tilts", "Theta from tau = 0 to the event, a list for each period, to 4 digits",
                          rounded_lines_type()),
      field<&Path::strobe>("strobe", "[Theta, Theta'] at each strobe point, to 4 digits",
                           the_only<LinesType<std::vector<StrobeState>>>()),
  };
  return fields;
}

static const StructType& fields_of(const CommittorMap*) {
  using Map = CommittorMap;
  static const StructType fields{
      "RareCommittor",
      field<&Map::tilt>("tilt", "columns are at even distances of Theta from -tilt to tilt", rule::not_negative),
      field<&Map::tilt_rate>("tilt_rate", "rows, likewise of Theta'", rule::not_negative),
      field<&Map::rows>("rows", "probability of the event, to 4 digits, by rising Theta'", rounded_lines_type()),
  };
  return fields;
}

}  // namespace rare

static Field unresolved_field() {
  return only_where<[](const ReportedRare& reported) { return reported.estimate.unresolved != 0.0; }>(
      field<&ReportedRare::estimate, &RareEstimate::unresolved>(
          "unresolved",
          "probability that a motion ends without an answer, by a budget or by Painleve's paradox; the upper end of "
          "the interval counts these as the event; absent: 0",
          rule::share));
}

static const StructType& fields_of(const ReportedRare*) {
  using Reported = ReportedRare;
  using Found = RareEstimate;
  constexpr auto estimate = &Reported::estimate;
  static const StructType fields{
      "RareEstimate",
      field<&Reported::parameters>("parameters", "JSON pointer to value, for each entry of the sweep"),
      field<estimate, &Found::probability>("probability", "mean of the repetitions; null: none was finished in time",
                                           rule::share),
      field<estimate, &Found::interval>(
          "interval", "of the probability; for a probability 0 its end is an order of magnitude, no bound",
          rule::share),
      field<&Reported::confidence>("confidence", "of the interval", rule::confidence),
      unresolved_field(),
      field<estimate, &Found::relative_error>(
          "relative_error",
          "standard error over the probability; null for a probability 0, for equal repetitions, and for few",
          rule::not_negative),
      field<estimate, &Found::work>("work", "simulated time with the pilot runs, in realisations to the horizon",
                                    rule::not_negative),
      field<estimate, &Found::crude_work>(
          "crude_work",
          "realisations that plain sampling needs for the same relative error, (1 - P)/(P error^2); null: unknown",
          rule::not_negative),
      field<estimate, &Found::ancestors>(
          "ancestors",
          "first trajectories of a repetition from which those with the event descend, median of the repetitions"),
      field<estimate, &Found::method>("method", "`twisted_run` where numbers are drawn along the way",
                                      the_only<NamedType<RareMethod, rare_method_names>>()),
      field<estimate, &Found::end>("ended", "why no more repetitions were made",
                                   the_only<NamedType<RareEnd, rare_end_names>>()),
      field<estimate, &Found::diagnosis>("diagnosis", "what stands in the way of trusting the interval",
                                         the_only<NamedType<RareDiagnosis, rare_diagnosis_names>>()),
      field<estimate, &Found::levels>(
          "levels", "of abs(Theta) in the search for the event, rising; empty for a twisted run", rule::not_negative),
      field<estimate, &Found::reached>(
          "reached", "share of the particles of that search that reach each level, and the event last", rule::share),
      field<estimate, &Found::pilot_work>("pilot_work", "part of `work` before the first repetition",
                                          rule::not_negative),
      field<estimate, &Found::repetitions>(
          "repetitions",
          "[estimate, work, ancestors] of each; ancestors: first trajectories from which those with the event descend. "
          "A fourth number, where it is not 0: the estimate for `unresolved`"),
      field<estimate, &Found::committor>("committor",
                                         "estimate of the probability of the event from points of the Poincare section "
                                         "at strobe point 1, with V = 0; null: of importance sampling"),
      field<estimate, &Found::paths>("paths",
                                     "trajectories with the event, drawn by their weights; empty if there was no time"),
  };
  return fields;
}

static const StructType& fields_of(const RareSuite*) {
  static const StructType fields{
      "RareSuite",
      field<&RareSuite::parameters>("parameters", "JSON pointer to value, for the rest of the sweep"),
      field<&RareSuite::records>("records", "number of records, each of which is equally likely"),
      field<&RareSuite::probability>("probability", "mean over the records; null: that of a record is", rule::share),
      field<&RareSuite::interval>("interval", "of the probability under one of these records", rule::share),
      field<&RareSuite::confidence>("confidence", "of the interval", rule::confidence),
      field<&RareSuite::relative_error>("relative_error", "standard error over the probability; null: unknown",
                                        rule::not_negative),
  };
  return fields;
}

namespace {

/// By EventName.
constexpr std::array<std::string_view, 4> event_keys{"overturned", "peak_tilt", "slip", "displacement"};

/// A threshold that stands in the file only where it is that of the event.
template <EventName name>
Field threshold_field(std::string_view key, std::string_view sentence) {
  return only_where<[](const RareReport& report) { return report.question.event.name == name; }>(
      field<&RareReport::question, &RareQuestion::event>(key, sentence, threshold_type(name), Rule{.above = 0.0}));
}

const StructType& question_fields() {
  using File = RareReport;
  static const StructType fields{
      "RareQuestion",
      derived<[](const File& report) {
        return std::string(event_keys[static_cast<std::size_t>(report.question.event.name)]);
      }>("event", "`overturned`, `peak_tilt`, `slip` or `displacement`"),
      field<&File::question, &RareQuestion::event>("peak_tilt",
                                                   "that abs(Theta) exceeds within the horizon; null: another event",
                                                   threshold_type(EventName::tilt), rule::not_negative),
      threshold_field<EventName::slip>("slip_m", "that the largest slip exceeds, where that is the event"),
      threshold_field<EventName::displacement>("displacement_m",
                                               "that the slip at the end exceeds, where that is the event"),
      field<&File::question, &RareQuestion::relative_error>(
          "relative_error", "standard error over the probability that was aimed at", rule::not_negative),
  };
  return fields;
}

const StructType& settings_fields() {
  using File = RareReport;
  static const StructType fields{
      "RareSettings",
      field<&File::seed>("seed", "of the experiment", seed_type()),
      field<&File::question, &RareQuestion::particles>("particles", "of a repetition", Rule{.least = 20.0}),
  };
  return fields;
}

}  // namespace

const StructType& fields_of(const RareReport*) {
  using File = RareReport;
  static const StructType fields{
      "RareEvents",
      field<&File::input>("input", "what was asked"),
      of_owner<File>("question", "the event", question_fields()),
      of_owner<File>("settings", "of the estimate", settings_fields()),
      fitting(derived<[](const File& report) { return report.digest(); }>(
          "digest", "SHA-256 over the levels and the repetitions")),
      field<&File::conditions>("conditions", "of the experiment"),
      field<&File::suites>("suites", "probability over the records of a suite; empty if no ground motion is swept"),
  };
  return fields;
}

namespace {

/// What follows from the repetitions of a condition, and the probabilities of suites from these.
void check_report(const RareReport& report, const ReadingPlace& place) {
  check_input(report.input, place.at("input"));
  std::vector<Condition> conditions;
  std::vector<RareEstimate> estimates;
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const ReportedRare& reported = report.conditions[i];
    ReportedRare right = reported;
    rare::summarise_repetitions(right.estimate, right.confidence, report.question.particles);
    check_fit(reported, right, place.at("conditions").at(std::to_string(i)));
    Condition& condition = conditions.emplace_back();
    condition.parameters = reported.parameters;
    condition.confidence = reported.confidence;
    estimates.push_back(reported.estimate);
  }
  check_fit(report.suites, rare_suites(conditions, estimates), place.at("suites"));
}

}  // namespace

const DocumentOf<RareReport>& rare_document() {
  static const DocumentOf<RareReport> document(
      "rocking.rare/1", "Probabilities of rare overturning. Without a time limit, equal input gives equal bytes.",
      check_report);
  return document;
}

base::Sha256 RareReport::digest() const {
  base::Sha256Builder builder;
  for (const ReportedRare& condition : conditions) {
    builder.add(condition.estimate.levels);
    for (const rare::Repetition& repetition : condition.estimate.repetitions) {
      builder.add(repetition.estimate);
      builder.add(repetition.work);
      if (repetition.unresolved > 0.0) builder.add(repetition.unresolved);
    }
  }
  return builder.finish();
}

std::vector<RareEstimate> estimates_for(const RareReport& asked, const RareReport& earlier) {
  const auto differ = [](const char* place) {
    throw base::InputError({place, "", "is not that of the earlier estimate, whose repetitions are therefore of no use",
                            "use the same experiment and options, or `--overwrite` without `--resume`"});
  };
  if (asked.input.sha256 != earlier.input.sha256) differ("/input");
  if (asked.seed != earlier.seed) differ("/settings/seed");
  if (asked.question.particles != earlier.question.particles) differ("/settings/particles");
  if (asked.question.event != earlier.question.event) differ("/question/event");
  std::vector<RareEstimate> all;
  for (const ReportedRare& condition : earlier.conditions) all.push_back(condition.estimate);
  return all;
}

RareReport rare_report(const Experiment& experiment, const RareQuestion& question,
                       const std::vector<RareEstimate>& found) {
  RareReport report{
      .input = input_of(experiment), .question = question, .seed = experiment.seed, .conditions = {}, .suites = {}};
  report.question.earlier.clear();
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Condition& condition = experiment.conditions[i];
    report.conditions.push_back({condition.parameters, condition.confidence, found[i]});
  }
  if (found.size() == experiment.conditions.size()) report.suites = rare_suites(experiment.conditions, found);
  return report;
}

}  // namespace rocking
