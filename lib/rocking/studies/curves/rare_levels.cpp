#include <algorithm>
#include <iterator>
#include <utility>

#include "rocking/api/refuse.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/scene/hazard.hpp"
#include "rocking/stats/repetitions.hpp"
#include "rocking/studies/curves/annual_rate.hpp"
#include "rocking/studies/curves/curves.hpp"
#include "rocking/studies/rare/study.hpp"
#include "rocking/text/files.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/locate.hpp"

namespace rocking {
namespace {

/// Throws where motions ended without an answer: the probability is known up to theirs only.
void check_answers(const RareReport& report) {
  for (std::size_t i = 0; i < report.conditions.size(); ++i) {
    const double unresolved = report.conditions[i].estimate.unresolved;
    if (unresolved == 0.0) continue;
    throw base::InputError({"/conditions/" + std::to_string(i) + "/unresolved", Json(unresolved).dump(),
                            "is the probability of motions that ended without an answer, which may all have the event",
                            "leave the condition out, or avoid what ended them: by a budget of steps, more slip in a "
                            "cell of friction; by Painleve's paradox, less friction"});
  }
}

RareReport report_in(const std::string& text, const std::string& name) {
  try {
    RareReport report = rare_document().read(parse_json(text));
    check_answers(report);
    return report;
  } catch (const base::InputError& error) {
    throw located(error, text, name);
  }
}

/// What decides on the probability of an event, but for the intensity.
Json block_and_motion(Json experiment, const std::string& intensity) {
  for (const char* key : {"title", "sweep", "realisations", "seed", "confidence"}) experiment.erase(key);
  const Json::json_pointer place(intensity);
  if (experiment.contains(place)) experiment[place.parent_pointer()].erase(place.back());
  return experiment;
}

/// A block under a motion of the run.
struct BlockAndMotion {
  std::vector<Parameter> others;  ///< CurveSubject::others
  std::string record;             ///< name of the ground motion; empty: the run has one motion
  Json block_and_motion;
};

std::vector<BlockAndMotion> subjects_of(const Experiment& experiment, const std::string& intensity) {
  const Json text = Json::parse(experiment.canonical_text);
  std::vector<BlockAndMotion> subjects;
  for (const Condition& condition : experiment.conditions) {
    std::vector<Parameter> others = condition.parameters;
    std::erase_if(others, [&](const Parameter& each) { return each.pointer == intensity; });
    BlockAndMotion subject{
        .others = others, .record = {}, .block_and_motion = block_and_motion(applied(text, others), intensity)};
    const bool is_of_suite =
        std::erase_if(subject.others, [](const Parameter& each) { return each.pointer == record_pointer; }) > 0;
    if (is_of_suite) subject.record = record_of(condition.scene);
    const bool is_known = std::ranges::any_of(subjects, [&](const BlockAndMotion& known) {
      return known.record == subject.record && have_equal_values(known.others, subject.others);
    });
    if (!is_known) subjects.push_back(std::move(subject));
  }
  return subjects;
}

/// Estimates at one intensity, of one motion or of records of a suite.
struct Estimates {
  struct OfSubject {
    const BlockAndMotion* subject;
    const RareEstimate* found;
  };
  double intensity = 0.0;
  std::vector<Parameter> parameters;  ///< of rare.json, without the ground motion
  std::vector<OfSubject> all;

  [[nodiscard]] const BlockAndMotion& subject() const { return *all.front().subject; }
  [[nodiscard]] bool is_of_suite() const { return !subject().record.empty(); }
};

/// The estimates whose block and motion are those of a subject.
std::vector<Estimates> estimates_of(const RareReport& report, const std::vector<BlockAndMotion>& subjects,
                                    const std::string& intensity) {
  std::vector<Estimates> groups;
  for (const ReportedRare& condition : report.conditions) {
    const Json whole = applied(report.input.experiment, condition.parameters);
    const Json::json_pointer place(intensity);
    if (!whole.contains(place) || !whole.at(place).is_number()) continue;
    const auto strength = whole.at(place).get<double>();
    const auto subject =
        std::ranges::find(subjects, block_and_motion(whole, intensity), &BlockAndMotion::block_and_motion);
    if (subject == subjects.end() || !(strength > 0.0)) continue;
    std::vector<Parameter> parameters = condition.parameters;
    std::erase_if(parameters, [](const Parameter& each) { return each.pointer == record_pointer; });
    auto group = std::ranges::find_if(groups, [&](const Estimates& known) {
      return known.is_of_suite() && known.intensity == strength && have_equal_values(known.parameters, parameters);
    });
    if (group == groups.end()) {
      groups.push_back({.intensity = strength, .parameters = std::move(parameters), .all = {}});
      group = std::prev(groups.end());
    }
    group->all.push_back({&*subject, &condition.estimate});
  }
  return groups;
}

/// Whether the estimate is > 0 and has an error.
bool is_sure(const RareEstimate& found) {
  return found.probability && found.relative_error && *found.probability > 0.0 && *found.probability < 1.0;
}

/// Whether it is as good as 0, since no repetition of the usual number saw the event.
bool is_never_seen(const RareEstimate& found) {
  return found.probability == 0.0 && found.diagnosis != RareDiagnosis::few_repetitions;
}

RareLevel level_of(double intensity, const RareEstimate& found) {
  return {.intensity = intensity,
          .probability = *found.probability,
          .interval = found.interval,
          .relative_error = *found.relative_error,
          .degrees_of_freedom = static_cast<double>(found.repetitions.size()) - 1.0};
}

/// The mean over all records of the run, by which the sampling is stratified; absent if the error of one is not known.
std::optional<RareOfCurve> mean_over_records(const Estimates& estimates, const RareReport& report,
                                             const std::vector<BlockAndMotion>& subjects, const std::string& file) {
  const auto wanted = std::ranges::count_if(
      subjects, [&](const BlockAndMotion& each) { return have_equal_values(each.others, estimates.subject().others); });
  if (std::ssize(estimates.all) != wanted) {
    refuse("rare", file,
           "has estimates under " + std::to_string(estimates.all.size()) + " of the " + std::to_string(wanted) +
               " ground motions of the run; estimate the probability under each of them");
  }
  const auto suite = std::ranges::find_if(
      report.suites, [&](const RareSuite& each) { return have_equal_values(each.parameters, estimates.parameters); });
  if (suite == report.suites.end() || !suite->probability || !suite->relative_error) return std::nullopt;
  RareOfCurve mean{.others = estimates.subject().others,
                   .event = report.question.event,
                   .level = {.intensity = estimates.intensity,
                             .probability = *suite->probability,
                             .interval = suite->interval,
                             .relative_error = *suite->relative_error}};
  std::vector<stats::Stratum> strata;
  for (const auto& [subject, found] : estimates.all) {
    if (is_never_seen(*found)) continue;
    if (!is_sure(*found)) return std::nullopt;
    const RareLevel level = level_of(estimates.intensity, *found);
    strata.push_back({.mean = level.probability,
                      .standard_error = level.probability * level.relative_error,
                      .degrees_of_freedom = level.degrees_of_freedom});
    mean.records.push_back({.name = subject->record, .level = level});
  }
  mean.level.degrees_of_freedom = stats::sum_of_strata(strata, suite->confidence).degrees_of_freedom;
  return mean;
}

}  // namespace

std::optional<std::size_t> second_estimate(const std::vector<RareOfCurve>& rare) {
  for (std::size_t i = 0; i < rare.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const bool is_same = rare[i].level.intensity == rare[j].level.intensity && rare[i].event == rare[j].event;
      if (is_same && have_equal_values(rare[i].others, rare[j].others)) return i;
    }
  }
  return std::nullopt;
}

std::vector<RareOfCurve> rare_levels(const std::filesystem::path& file, const Experiment& experiment) {
  return rare_levels(read_file(file), file.string(), experiment);
}

std::vector<RareOfCurve> rare_levels(const std::string& text, const std::string& name, const Experiment& experiment) {
  const RareReport report = report_in(text, name);
  const std::string intensity(intensity_of(experiment));
  if (intensity.empty()) refuse("rare", name, "needs a run that sweeps the intensity of its excitation");
  const std::vector<BlockAndMotion> subjects = subjects_of(experiment, intensity);
  std::vector<RareOfCurve> levels;
  for (const Estimates& estimates : estimates_of(report, subjects, intensity)) {
    if (estimates.is_of_suite()) {
      if (auto mean = mean_over_records(estimates, report, subjects, name)) levels.push_back(std::move(*mean));
    } else if (const RareEstimate& found = *estimates.all.front().found; is_sure(found)) {
      levels.push_back({.others = estimates.subject().others,
                        .event = report.question.event,
                        .level = level_of(estimates.intensity, found)});
    }
  }
  if (const auto second = second_estimate(levels)) {
    refuse("rare", name,
           "has two estimates of one probability, at " + intensity + ' ' +
               base::shortest(levels[*second].level.intensity) +
               "; sweep no key that changes nothing of the block and its motion, such as /confidence or /realisations");
  }
  if (levels.empty()) {
    refuse("rare", name,
           "has no probability > 0 of the same block, motion, horizon and accuracy as a condition of the run; estimate "
           "the experiment of the run with other values of " +
               intensity);
  }
  return levels;
}

}  // namespace rocking
