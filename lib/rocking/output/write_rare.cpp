#include "rocking/output/write_rare.hpp"

#include <algorithm>
#include <bit>

#include "rocking/base/digest.hpp"
#include "rocking/output/mode_table.hpp"
#include "rocking/output/result_json.hpp"
#include "rocking/output/text_table.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"
#include "rocking/text/seed_text.hpp"

namespace rocking {
namespace {

Json or_null_if_absent(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

std::string_view name_of(rare::Score score) {
  switch (score) {
    case rare::Score::tilt: return "tilt";
    case rare::Score::energy: return "energy";
  }
  return "";
}

/// Over the bits of every repetition's estimate, in order.
std::string digest_of(const std::vector<RareEstimate>& conditions) {
  base::Sha256Builder builder;
  for (const RareEstimate& condition : conditions) {
    builder.add(condition.levels);
    for (const rare::Repetition& repetition : condition.repetitions) {
      builder.add(repetition.estimate);
      builder.add(repetition.work);
    }
  }
  return base::to_hex(builder.finish());
}

Json condition_json(const RareEstimate& found, const Condition& condition) {
  Json json = Json::object();
  json["parameters"] = parameters_json(condition);
  json["probability"] = or_null_if_absent(found.probability);
  json["interval"] = Json::array({found.interval.low, found.interval.high});
  json["confidence"] = condition.confidence;
  json["relative_error"] = or_null_if_absent(found.relative_error);
  json["work"] = found.work;
  json["crude_work"] = or_null_if_absent(found.crude_work);
  json["method"] = to_string(found.method);
  json["ended"] = to_string(found.end);
  json["diagnosis"] = to_string(found.diagnosis);
  json["ancestors"] = {{"median", found.median_ancestors}, {"least", found.least_ancestors}};
  json["levels"] = found.levels;
  json["reached"] = found.reached;
  json["pilot_work"] = found.pilot_work;
  Json& repetitions = json["repetitions"] = Json::array();
  for (const rare::Repetition& repetition : found.repetitions) {
    repetitions.push_back(Json::array({repetition.estimate, repetition.work, repetition.ancestors}));
  }
  return json;
}

std::string event_words(const RareQuestion& question) {
  if (!question.event.peak_tilt) return "the block overturns within the horizon";
  return "the largest abs(Theta) within the horizon exceeds " + significant(*question.event.peak_tilt, 6);
}

std::string percentage(const std::optional<double>& relative) {
  return relative ? significant(100.0 * *relative, 2) + " %" : "-";
}

std::string warning_about(const RareEstimate& found) {
  switch (found.diagnosis) {
    case RareDiagnosis::none: return "";
    case RareDiagnosis::no_levels:
      return "the pilot run found no way to the event. The probability may be 0; the interval's upper end is that of "
             "the "
             "highest level reached";
    case RareDiagnosis::few_repetitions:
      return "finished in time: " + counted(found.repetitions.size(), "repetition") +
             ". An interval needs 8. Give more time, or fewer --particles";
    case RareDiagnosis::few_ancestors:
      return "half of the repetitions descend from fewer than 10 first trajectories; the interval may be too narrow. "
             "Use "
             "more --particles";
    case RareDiagnosis::uneven:
      return "some repetitions missed the event, or one has more than a third of the sum; the interval may be too "
             "narrow. "
             "Use more --particles";
  }
  return "";
}

std::string end_of(const RareEstimate& found) {
  switch (found.end) {
    case RareEnd::precise: return "";
    case RareEnd::out_of_time: return "the time was up before the relative error was reached";
    case RareEnd::never_seen: return "no repetition saw the event";
    case RareEnd::most_repetitions:
      return "the largest number of repetitions was made before the relative error was reached";
  }
  return "";
}

}  // namespace

std::string rare_text(const FoundRare& found) {
  const std::string& canonical = found.experiment->canonical_text;
  Json question = Json::object();
  question["event"] = found.question.event.peak_tilt ? "peak_tilt" : "overturned";
  question["peak_tilt"] = or_null_if_absent(found.question.event.peak_tilt);
  question["relative_error"] = found.question.relative_error;
  Json settings = Json::object();
  settings["seed"] = seed_text(found.experiment->seed);
  settings["particles"] = found.particles;
  settings["score"] = name_of(found.score);
  std::string text = "{\n  \"format\": " + Json(rare_format).dump();
  text += ",\n  \"input\": { \"experiment\": " + canonical;
  text += ",\n    \"sha256\": " + Json(base::to_hex(base::sha256(canonical))).dump() + " }";
  text += ",\n  \"question\": " + question.dump() + ",\n  \"settings\": " + settings.dump();
  text += ",\n  \"digest\": " + Json(digest_of(found.conditions)).dump() + ",\n  \"conditions\": [";
  for (std::size_t i = 0; i < found.conditions.size(); ++i) {
    text += (i == 0 ? "\n    " : ",\n    ");
    text += condition_json(found.conditions[i], found.experiment->conditions[i]).dump();
  }
  return text + "\n  ]\n}\n";
}

std::string rare_table(const FoundRare& found) {
  const auto& conditions = found.experiment->conditions;
  TextRow heading;
  for (const Parameter& parameter : conditions.front().parameters) heading.push_back(last_key(parameter.pointer));
  for (const char* name : {"probability", "from", "to", "error", "levels", "repetitions", "work", "plain sampling"}) {
    heading.emplace_back(name);
  }
  std::vector<TextRow> rows{heading};
  std::string notes;
  for (std::size_t c = 0; c < conditions.size(); ++c) {
    const RareEstimate& estimate = found.conditions[c];
    TextRow row;
    for (const Parameter& parameter : conditions[c].parameters) row.push_back(short_value(parameter));
    row.insert(row.end(), {estimate.probability ? significant(*estimate.probability, 3) : "-",
                           significant(estimate.interval.low, 3), significant(estimate.interval.high, 3),
                           percentage(estimate.relative_error), std::to_string(estimate.levels.size()),
                           std::to_string(estimate.repetitions.size()), significant(estimate.work, 3),
                           estimate.crude_work ? significant(*estimate.crude_work, 3) : "-"});
    rows.push_back(std::move(row));
    for (const std::string& note : {end_of(estimate), warning_about(estimate)}) {
      if (note.empty()) continue;
      notes += (conditions.size() > 1 ? "condition " + std::to_string(c) + ": " : "") + note + ".\n";
    }
  }
  return "Probability that " + event_words(found.question) + ".\n\n" + aligned(rows) + "from, to: interval with " +
         level_text(highest_confidence(*found.experiment)) +
         " % confidence; error: standard error over the probability; work, plain sampling: simulated\ntime in "
         "realisations to the horizon, by this method and by plain sampling for the same error. It is no processor\n"
         "time: `rocking run` simulates several realisations at once in SIMD lanes, this method one.\n" +
         notes;
}

}  // namespace rocking
