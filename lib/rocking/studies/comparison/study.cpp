#include "rocking/studies/comparison/study.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "rocking/output/parameter_text.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/scene/shaking.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

using look::number;
using look::percentage;

std::string level_of(const Comparison& found) {
  return found.confidence ? level_text(*found.confidence) + " % interval"
                          : "interval at the confidence of each condition";
}

/// ` = 1.1 g`, the other form of a swept amplitude or frequency; empty for other parameters.
std::string form_beside(const Parameter& parameter, const std::optional<Shaking>& shaking) {
  for (const ShakingNumber& each : shaking_numbers) {
    if (!shaking || parameter.pointer != "/excitation/" + std::string(each.key)) continue;
    const std::string_view other = other_form_of(each.key);
    return " = " + in_unit(other, significant(number_of(*shaking, other), 3));
  }
  return "";
}

std::string name_of(const Experiment& first, std::size_t condition) {
  std::string name;
  const auto shaking = shaking_of(first.conditions[condition].scene);
  for (const Parameter& parameter : first.conditions[condition].parameters) {
    name += (name.empty() ? "" : ", ") + short_value(parameter) + form_beside(parameter, shaking);
  }
  return name.empty() ? std::to_string(condition) : name;
}

/// `34 of 1000 realisations changed their response mode`, and the share of each mode in both runs.
std::string answer_of(const Comparison& found) {
  std::uint64_t realisations = 0, changed = 0;
  std::map<section::ResponseMode, std::pair<std::uint64_t, std::uint64_t>> counts;
  for (const ConditionComparison& condition : found.conditions) {
    realisations += condition.realisations;
    changed += condition.changed.counts.successes;
    for (const auto& [mode, pair] : condition.modes) {
      counts[mode].first += pair.counts.both + pair.counts.first_only;
      counts[mode].second += pair.counts.both + pair.counts.second_only;
    }
  }
  std::string text = std::to_string(changed) + " of " + counted(realisations, "realisation") +
                     " changed their response mode (" + per_cent_of(changed, realisations) + " %)";
  for (const auto& [mode, both] : counts) {
    text += "; " + to_string(mode) + ": " + std::to_string(both.first) + " and " + std::to_string(both.second);
  }
  return text + '\n';
}

struct ComparedMode {
  std::size_t condition = 0;
  section::ResponseMode mode;
  const ModeComparison* pair = nullptr;
};

/// Every mode of every condition in order; on one screen those of smallest p.
std::vector<ComparedMode> compared_modes(const Comparison& found, Extent extent) {
  std::vector<ComparedMode> modes;
  for (std::size_t i = 0; i < found.conditions.size(); ++i) {
    for (const auto& [mode, pair] : found.conditions[i].modes) modes.push_back({i, mode, &pair});
  }
  if (extent == Extent::all || modes.size() <= most_screen_rows) return modes;
  std::ranges::stable_sort(modes, {}, [](const ComparedMode& each) { return each.pair->test.p_value; });
  modes.resize(most_screen_rows);
  std::ranges::stable_sort(modes, {}, &ComparedMode::condition);
  return modes;
}

}  // namespace

/// The comparison as text: differences between the experiments, how many realisations changed their response mode, and a row
/// for each condition and mode; on one screen the rows of smallest p. `first`: the experiment of the first run.
static std::string comparison_table(const Comparison& found, const Experiment& first, Extent extent) {
  std::string text = answer_of(found);
  for (const std::string& difference : found.settings) {
    text += "first run: " + difference + " as in the second\n";
  }
  text += '\n';
  std::uint64_t most = 0;
  for (const ConditionComparison& condition : found.conditions) most = std::max(most, condition.realisations);
  look::Table table;
  add_columns(table, {"condition", "n", "changed", "mode", "first", "second", "difference", "interval", "p", "worth"});
  for (const auto& [i, mode, pair] : compared_modes(found, extent)) {
    const ConditionComparison& compared = found.conditions[i];
    const auto share = [all = compared.realisations](double share_in, std::uint64_t count) {
      return number(share_in, percentage(), count_if_open(count, all));
    };
    const auto& factor = pair->variance_reduction;
    table.rows.push_back(
        {name_of(first, i), look::whole(compared.realisations), look::whole(compared.changed.counts.successes),
         to_string(mode), share(pair->in_first, pair->counts.both + pair->counts.first_only),
         share(pair->in_second, pair->counts.both + pair->counts.second_only), number(pair->difference, percentage()),
         look::interval(pair->exact, percentage()), number(pair->test.p_value, 2), number(factor, 2, "x")});
  }
  const std::size_t tests = number_of_tests(found.conditions);
  text += to_terminal(table);
  if (table.rows.size() < tests) {
    text += "the " + std::to_string(table.rows.size()) + " rows of smallest p of " + std::to_string(tests) +
            "; all: --all, and --json\n";
  }
  return text + "\nper cent of n realisations with common random numbers; difference = first - second with its exact " +
         level_of(found) + ";\np: exact McNemar test, one of " + std::to_string(tests) +
         "; worth: variance with independent random numbers over that with common ones" + count_legend(most) + '\n';
}

namespace {

struct NoQuestion {};

const StructType& fields_of(const NoQuestion*) {
  static const StructType fields{"NoQuestion"};
  return fields;
}

void check(const Subject& subject, NoQuestion&) {
  const NamedRun& first = subject.runs[0];
  const NamedRun& second = subject.runs[1];
  const auto found =
      why_not_comparable({first.stored.experiment, first.folder}, {second.stored.experiment, second.folder});
  if (found) throw UnfitQuestion(found->place, "", found->reason);
}

Answer find(const Subject& subject, const NoQuestion&, const Circumstances& circumstances) {
  const StoredRun& first = subject.runs[0].stored;
  const Comparison found = compare(first, subject.runs[1].stored);
  return {.document = comparison_document().text(found),
          .table = comparison_table(found, first.experiment, circumstances.extent)};
}

constexpr StudyFunctions<NoQuestion> functions{.check = check, .find = find};

}  // namespace

const Study& comparison_study() {
  static const Study study = study_of<NoQuestion, functions>({
      .name = "compare",
      .sentence = "Compare two runs, pairwise with common random numbers",
      .example = "out tighter",
      .text = "compares each realisation of out with the realisation of tighter that has the same random numbers. Both "
              "runs have the same seed, number of conditions and records; they may differ in anything else (amplitude, "
              "tolerance, formulation, sigma).",
      .python_notes = "The runs have the same seed, number of conditions and records of a suite; they may differ in "
                      "anything else. Realisations that only one run has are left out. Intervals have the confidence "
                      "of the first run. Raises InputError if the seeds, the numbers of conditions or the records "
                      "differ, OSError or StoreError as open_run().",
      .python_example = R"(>>> import rocking
>>> slab = {"format": "rocking.experiment/1", "block": {"width_m": 1, "height_m": 4},
...     "excitation": {"kind": "harmonic", "amplitude": 2.0, "frequency_ratio": 10.0,
...                    "phase_rad": {"uniform": [0, 6.28]}}, "restitution": 0.9,
...     "horizon": {"transient_periods": 20, "sampled_periods": 20}, "realisations": 10, "seed": "0x1"}
>>> found = rocking.compare(rocking.run(slab), rocking.run({**slab, "restitution": 0.5}))
>>> found.settings
['/restitution is 0.9, not 0.5']
>>> found.conditions[0].realisations
10)",
      .subject = SubjectKind::two_runs,
      .has_long_table = true,
      .document = comparison_document(),
  });
  return study;
}

}  // namespace rocking
