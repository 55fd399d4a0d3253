#include <utility>

#include "rocking/api/question_check.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/api/system_facts.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/input/read_hazard.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/scene/hazard.hpp"
#include "rocking/store/store.hpp"
#include "rocking/studies/curves/hazard_integral.hpp"
#include "rocking/studies/fragility/fragility.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "rocking/text/files.hpp"

namespace rocking {
namespace {

/// Without repetition, the first one first.
std::vector<ResponseEvent> events_of(const FragilityQuestion& question, const Experiment& experiment) {
  std::vector<ResponseEvent> asked;
  for (const ResponseEvent& event : question.events) asked.push_back(in_units_of_balance(event, experiment.conditions));
  if (asked.empty()) asked.emplace_back();
  std::vector<ResponseEvent> events;
  for (const ResponseEvent& event : asked) {
    if (std::ranges::find(events, event) == events.end()) events.push_back(event);
  }
  return events;
}

/// The parts of all curves, and how far they are.
class Progress {
 public:
  Progress(const std::vector<StripeGroup>& groups, std::size_t events, const RunOptions& options) : options_(options) {
    for (const StripeGroup& group : groups) all_ += events * parts_of(group);
    how_ = {.threads = options.threads, .stop = options.stop_requested, .on_part = [this] { show(done_ + 1); }};
  }
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  [[nodiscard]] const base::ManyParts& how() const { return how_; }
  /// A curve of this group is finished; it may have had fewer parts than it could.
  void finish(const StripeGroup& group) { show(finished_ += parts_of(group)); }

 private:
  static std::uint64_t parts_of(const StripeGroup& group) {
    return group.is_suite() ? parts_of_suite_curve(group) : fragility_samples;
  }
  void show(std::uint64_t done) {
    done_ = done;
    if (options_.on_progress) options_.on_progress(done_, all_);
  }

  const RunOptions& options_;
  base::ManyParts how_;
  std::uint64_t all_ = 0, done_ = 0, finished_ = 0;
};

/// The rates of suites. Those about one event have one basis: a law that does not hold for each of them is none.
void set_rates(const HazardCurve& hazard, RunFragility& run) {
  const auto has_no_law = [](const ShownSuite& shown) {
    return shown.curve.outcome != stats::FragilityOutcome::fitted;
  };
  for (ShownSuite& shown : run.suites) {
    const bool is_by_law = std::ranges::none_of(run.suites, [&](const ShownSuite& other) {
      return other.curve.subject.event == shown.curve.subject.event && has_no_law(other);
    });
    shown.rate = annual_rate(shown.curve, hazard, is_by_law ? RateSource::law : RateSource::isotonic);
  }
}

/// Each suite of a later group with that of the first one about the same event.
void compare(const HazardCurve& hazard, RunFragility& run) {
  for (const ShownSuite& shown : run.suites) {
    const auto base = std::ranges::find_if(
        run.suites, [&](const ShownSuite& other) { return other.curve.subject.event == shown.curve.subject.event; });
    if (&*base == &shown) continue;
    run.comparisons.push_back(compared_rates(base->curve, shown.curve, hazard, shown.rate.value().chosen.source));
  }
}

/// The rare estimates of a curve, by growing intensity.
std::vector<RareOfCurve> rare_of(const CurveSubject& subject, const std::vector<RareOfCurve>& all) {
  std::vector<RareOfCurve> found;
  for (const RareOfCurve& one : all) {
    if (one.event == subject.event && have_equal_values(one.others, subject.others)) found.push_back(one);
  }
  std::ranges::sort(found, {}, [](const RareOfCurve& one) { return one.level.intensity; });
  return found;
}

void add_rare(const std::vector<RareOfCurve>& all, FragilityCurve& curve) {
  for (const RareOfCurve& one : rare_of(curve.subject, all)) curve.rare.push_back(one.level);
}

void add_rare(const std::vector<RareOfCurve>& all, SuiteCurve& curve) {
  for (const RareOfCurve& one : rare_of(curve.subject, all)) {
    curve.rare.push_back(one.level);
    for (const RareOfCurve::OfRecord& of_record : one.records) {
      const auto record = std::ranges::find(curve.records, of_record.name, &RecordCurve::name);
      if (record == curve.records.end()) {
        throw base::InputError({"rare", of_record.name, "is no ground motion of the run", "omit it"});
      }
      record->curve.rare.push_back(of_record.level);
    }
  }
}

void add_curve(const StripeGroup& group, const ResponseEvent& event, const FragilityQuestion& question,
               const base::ManyParts& how, RunFragility& run) {
  if (group.is_suite()) {
    ShownSuite& shown =
        run.suites.emplace_back(ShownSuite{.curve = suite_curve(group, event, run.experiment.seed, how)});
    add_rare(question.rare, shown.curve);
    if (!question.surface.empty()) {
      shown.surface = fragility_surface(group, shown.curve, question.surface, question.joint_hazard,
                                        {.threads = how.threads, .stop = how.stop});
    }
  } else {
    ShownCurve& shown = run.curves.emplace_back(ShownCurve{.curve = fragility(group, event, run.experiment.seed, how)});
    add_rare(question.rare, shown.curve);
    if (question.hazard) shown.rate = annual_rate(shown.curve, *question.hazard);
  }
}

/// Levels of a table as intensities of the hazard curve: those that it exceeds once in the return periods which the table
/// states. Throws where the curve does not reach them.
std::vector<StripeGroup> with_levels_of(const HazardCurve& hazard, const Experiment& experiment,
                                        std::vector<StripeGroup> groups) {
  const bool are_periods = has_return_periods(experiment);
  const double last = hazard.points.back().intensity;
  for (StripeGroup& group : groups) {
    for (Stripe& stripe : group.stripes) {
      const auto of_period = intensity_at(hazard, 1.0 / stripe.intensity);
      if (are_periods && of_period) {
        stripe.intensity = *of_period;
      } else if (are_periods || stripe.intensity > last) {
        throw base::InputError(
            {.place = hazard.name,
             .value = "",
             .reason = "does not reach the level " + base::shortest(stripe.intensity) + " of the run" +
                       (are_periods ? ", a return period in years" : ": it ends at " + base::shortest(last)),
             .remedy =
                 are_periods ? "give a hazard curve that reaches its rate"
                 : of_period
                     ? "levels are intensities; for return periods call the column return_period_years: once in " +
                           base::shortest(stripe.intensity) + " years " + hazard.intensity + " exceeds " +
                           base::significant(*of_period, 3)
                     : "give the levels in " + hazard.intensity + ", or a curve that reaches them",
             .where = {}});
      }
    }
  }
  return groups;
}

}  // namespace

RunFragility run_fragility(const Experiment& experiment, const std::vector<StripeGroup>& all_groups,
                           const FragilityQuestion& question, const RunOptions& options) {
  if (question.hazard) check_hazard(*question.hazard, experiment);
  const bool has_levels = question.hazard && intensity_of(experiment) == level_pointer;
  const std::vector<StripeGroup> groups =
      has_levels ? with_levels_of(*question.hazard, experiment, all_groups) : all_groups;
  const std::vector<ResponseEvent> events = events_of(question, experiment);
  for (const ResponseEvent& event : events) {
    for (const Condition& condition : experiment.conditions) check_friction(event, condition);
  }
  RunFragility run{.experiment = experiment};
  Progress progress(groups, events.size(), options);
  for (const StripeGroup& group : groups) {
    for (const ResponseEvent& event : events) {
      add_curve(group, event, question, progress.how(), run);
      progress.finish(group);
    }
    if (question.incremental) run.incremental.push_back(incremental_analysis(group));
  }
  const auto has_rare = [](const auto& shown) { return !shown.curve.rare.empty(); };
  if (!question.rare.empty() && std::ranges::none_of(run.curves, has_rare) &&
      std::ranges::none_of(run.suites, has_rare)) {
    throw base::InputError({"rare", "", "has no estimate of an event that is asked for", "ask for the same --event"});
  }
  if (question.hazard) {
    set_rates(*question.hazard, run);
    compare(*question.hazard, run);
    for (ShownCurve& shown : run.curves) shown.rate->in_years = in_years(*shown.rate, question.years);
    for (ShownSuite& shown : run.suites) shown.rate->chosen.in_years = in_years(shown.rate->chosen, question.years);
  }
  if (!question.surface.empty() && run.suites.empty()) {
    throw base::InputError({"surface", "", "needs a suite of ground motions", "omit it, or give a run of a suite"});
  }
  return run;
}

namespace {

/// Reports the numbers of a rare estimate that are none.
void check_level(const RareLevel& level, const std::string& place, QuestionCheck& check) {
  const auto expect = [&](bool holds, const char* key, double value, const char* reason) {
    check.expect(holds, place + '/' + key, base::shortest(value), reason);
  };
  expect(level.intensity > 0.0 && std::isfinite(level.intensity), "intensity", level.intensity, "must be positive");
  expect(level.probability > 0.0 && level.probability < 1.0, "probability", level.probability,
         "must be between 0 and 1");
  for (const auto& [key, end] : {std::pair{"low", level.interval.low}, std::pair{"high", level.interval.high}}) {
    expect(end >= 0.0 && end <= 1.0, key, end, "must be a share");
  }
  // All of the sum in one repetition gives 1, but for rounding.
  expect(level.relative_error > 0.0 && level.relative_error <= 1.000001, "relative_error", level.relative_error,
         "must be positive and at most 1");
  expect(level.degrees_of_freedom >= 1.0 && std::isfinite(level.degrees_of_freedom), "degrees_of_freedom",
         level.degrees_of_freedom, "must be at least 1");
}

void check(const FragilityQuestion& question) {
  QuestionCheck check(question);
  if (question.hazard) check.add(problems_of(*question.hazard));
  for (std::size_t i = 0; i < question.rare.size(); ++i) {
    const RareOfCurve& rare = question.rare[i];
    const std::string place = "rare/" + std::to_string(i);
    const double threshold = rare.event.threshold;
    check.expect(threshold >= 0.0 && std::isfinite(threshold), place + "/event", base::shortest(threshold),
                 "must not be negative");
    check_level(rare.level, place + "/level", check);
    for (std::size_t k = 0; k < rare.records.size(); ++k) {
      check_level(rare.records[k].level, place + "/records/" + std::to_string(k) + "/level", check);
    }
  }
  const std::vector<std::string>& measures = question.surface;
  check.expect(measures.empty() || (measures.size() == 2 && measures[0] != measures[1]), "surface", "",
               "must be two different measures");
  check.expect(!question.joint_hazard || !measures.empty(), "joint_hazard", "", "needs a surface");
  for (const JointCell& cell : question.joint_hazard ? question.joint_hazard->cells : std::vector<JointCell>{}) {
    check.expect(is_sensible(cell), "joint_hazard", base::shortest(cell.rate),
                 "must have positive measures, and rates that are not negative");
  }
  check.finish();
  if (const auto second = second_estimate(question.rare)) {
    const std::string intensity = base::shortest(question.rare[*second].level.intensity);
    refuse("rare/" + std::to_string(*second), "intensity " + intensity, "is a second estimate of the same probability");
  }
}

}  // namespace

RunFragility fragility(const Experiment& experiment, const RunResult& run, const FragilityQuestion& question,
                       const Execution& execution) {
  check_has_conditions(experiment);
  if (intensity_of(experiment).empty()) {
    refuse("/sweep", "",
           "sweeps no intensity of the excitation: /excitation/amplitude (or amplitude_g, amplitude_m_s2) or "
           "/excitation/scale (or pga_g, pgv_m_s)");
  }
  if (experiment.conditions.front().until) {
    refuse("/realisations", "until", "a fragility function needs a fixed number of realisations");
  }
  check(question);
  return run_fragility(with_text(experiment), stripes_of(experiment, store_of(run), execution.threads), question,
                       OptionsOfExecution(execution).options());
}

HazardCurve hazard_curve(const std::filesystem::path& file, const HazardReading& reading) {
  return hazard_curve_in(read_file(file, most_hazard_bytes), file.string(), reading);
}

HazardCurve hazard_curve_in(std::string_view text, const std::string& name, const HazardReading& reading) {
  return read_hazard(text, name, reading);
}

JointHazard joint_hazard(const std::filesystem::path& file, const std::vector<std::string>& measures) {
  return read_joint_hazard(read_file(file, most_hazard_bytes), file.string(), measures);
}

}  // namespace rocking
