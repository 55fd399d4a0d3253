#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rocking/api/refuse.hpp"
#include "rocking/api/studies.hpp"
#include "rocking/base/error.hpp"
#include "rocking/output/rare_report.hpp"
#include "rocking/studies/suite/stripes.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/locate.hpp"
#include "rocking/text/parse_json.hpp"

namespace rocking {
namespace {

RareReport report_in(const std::filesystem::path& file) {
  const std::string text = read_file(file);
  try {
    return rare_document().read(parse_json(text));
  } catch (const base::InputError& error) {
    throw located(error, text, file.string());
  }
}

/// An experiment with the swept values of a condition.
Json applied(Json experiment, const std::vector<Parameter>& parameters) {
  for (const Parameter& parameter : parameters) {
    experiment[Json::json_pointer(parameter.pointer)] = Json::parse(parameter.value);
  }
  return experiment;
}

/// What decides on the probability of an event, but for the intensity.
Json block_and_motion(Json experiment, const std::string& intensity) {
  for (const char* key : {"title", "sweep", "realisations", "seed", "confidence"}) experiment.erase(key);
  const Json::json_pointer place(intensity);
  if (experiment.contains(place)) experiment[place.parent_pointer()].erase(place.back());
  return experiment;
}

/// A curve of the run.
struct Subject {
  std::vector<Parameter> others;
  Json block_and_motion;
};

std::vector<Subject> subjects_of(const Experiment& experiment, const std::string& intensity) {
  const Json text = Json::parse(experiment.canonical_text);
  std::vector<Subject> subjects;
  for (const Condition& condition : experiment.conditions) {
    std::vector<Parameter> others = condition.parameters;
    std::erase_if(others, [&](const Parameter& each) { return each.pointer == intensity; });
    const bool is_known = std::ranges::any_of(subjects, [&](const Subject& known) {
      return std::ranges::equal(known.others, others, {}, &Parameter::value, &Parameter::value);
    });
    if (is_known) continue;
    subjects.push_back({others, block_and_motion(applied(text, others), intensity)});
  }
  return subjects;
}

}  // namespace

std::vector<RareOfCurve> rare_levels(const std::filesystem::path& file, const Experiment& experiment) {
  const RareReport report = report_in(file);
  const std::string intensity(intensity_of(experiment));
  if (intensity.empty()) refuse("rare", file.string(), "needs a run that sweeps the intensity of its excitation");
  if (!report.suites.empty()) {
    refuse("rare", file.string(), "is about a suite of ground motions; the rate of a suite does not take it");
  }
  const std::vector<Subject> subjects = subjects_of(experiment, intensity);
  std::vector<RareOfCurve> levels;
  for (const ReportedRare& condition : report.conditions) {
    const RareEstimate& found = condition.estimate;
    if (!found.probability || !found.relative_error || !(*found.probability > 0.0 && *found.probability < 1.0))
      continue;
    const Json whole = applied(report.input.experiment, condition.parameters);
    const Json::json_pointer place(intensity);
    if (!whole.contains(place) || !whole.at(place).is_number()) continue;
    const Json wanted = block_and_motion(whole, intensity);
    const auto subject = std::ranges::find(subjects, wanted, &Subject::block_and_motion);
    const auto strength = whole.at(place).get<double>();
    if (subject == subjects.end() || !(strength > 0.0)) continue;
    levels.push_back({.others = subject->others,
                      .event = {.peak_tilt = report.question.event.peak_tilt},
                      .level = {.intensity = strength,
                                .probability = *found.probability,
                                .interval = found.interval,
                                .relative_error = *found.relative_error,
                                .degrees_of_freedom = static_cast<double>(found.repetitions.size()) - 1.0}});
  }
  if (levels.empty()) {
    refuse("rare", file.string(),
           "has no probability > 0 of the same block, motion, horizon and accuracy as a condition of the run; estimate "
           "the experiment of the run with other values of " +
               intensity);
  }
  return levels;
}

}  // namespace rocking
