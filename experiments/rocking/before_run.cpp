#include "before_run.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <variant>

#include <fmt/format.h>

#include "arguments.hpp"
#include "interrupt.hpp"
#include "machine.hpp"
#include "output.hpp"
#include "rocking/api/checks.hpp"
#include "rocking/output/ground_motion_facts.hpp"
#include "rocking/output/plan_text.hpp"
#include "rocking/plan/plan.hpp"
#include "rocking/text/number_text.hpp"
#include "study_file.hpp"

namespace rocking::program {
namespace {

/// A ground motion in all conditions that have it.
struct UsedMotion {
  std::shared_ptr<const GroundMotion> motion;
  double largest_scale = 0.0;
  bool may_move = false;                 ///< in some condition the block moves, or may do so
  std::optional<double> uplift_scale{};  ///< the least one of all blocks
};

/// Whether a block at rest starts to move at no smaller acceleration than that of uplift.
bool only_uplift_starts(const Scene& scene, const dynamics::Geometry& block) {
  const auto is_zero = [](const Quantity& quantity) {
    const auto* number = std::get_if<double>(&quantity);
    return number != nullptr && *number == 0.0;
  };
  const bool at_rest =
      is_zero(scene.initial.tilt) && is_zero(scene.initial.tilt_rate) && is_zero(scene.initial.slip_rate);
  const double largest = std::ranges::max(block.tangents());
  const bool holds = !scene.friction || (scene.fluctuation.static_friction == 0.0 &&
                                         reach_of(scene.friction->static_coefficient).least >= largest);
  return at_rest && !is_drawn(scene.block) && holds;
}

void take_in(const Condition& condition, const Recorded& recorded, UsedMotion& used) {
  const dynamics::Geometry block = dynamics::geometry_of(mean_block(condition.scene));
  const auto uplift = least_uplift_scale(recorded.ground_motion->samples, block.tangents());
  const double largest_scale = reach_of(recorded.scale).largest;
  used.largest_scale = std::max(used.largest_scale, largest_scale);
  used.may_move = used.may_move || recorded.building || !only_uplift_starts(condition.scene, block) ||
                  (uplift && largest_scale >= *uplift);
  if (uplift) used.uplift_scale = used.uplift_scale ? std::min(*used.uplift_scale, *uplift) : *uplift;
}

std::vector<UsedMotion> used_motions(const Experiment& experiment) {
  std::vector<UsedMotion> motions;
  for (const Condition& condition : experiment.conditions) {
    const auto* recorded = std::get_if<Recorded>(&condition.scene.excitation);
    if (recorded == nullptr || !recorded->ground_motion) continue;
    const auto is_same = [recorded](const UsedMotion& used) { return used.motion == recorded->ground_motion; };
    auto place = std::ranges::find_if(motions, is_same);
    if (place == motions.end()) {
      motions.push_back({.motion = recorded->ground_motion});
      place = std::prev(motions.end());
    }
    take_in(condition, *recorded, *place);
  }
  return motions;
}

/// What is suspicious, without what a run counts itself.
std::vector<Finding> suspicions_of(const Experiment& experiment) {
  std::vector<Finding> findings = suspicious_numbers(experiment);
  std::ranges::move(too_few_periods(experiment), std::back_inserter(findings));
  return findings;
}

}  // namespace

void tell_ground_motion_notes(const Experiment& experiment) {
  for (const std::string& name : experiment.left_out) {
    print_notice(name + ": cannot be read; it is left out of the suite");
  }
  for (const UsedMotion& used : used_motions(experiment)) {
    const std::string& name = used.motion->name;
    for (const std::string& warning : used.motion->warnings) print_notice(name + ": " + warning);
    if (used.may_move) continue;
    print_notice(name + (used.uplift_scale
                             ? ": is too weak to lift the block at any scale of this run, at most " +
                                   significant(used.largest_scale, 3) + "; it lifts the block from a scale of " +
                                   significant(*used.uplift_scale, 4) + " on"
                             : ": lifts the block at no scale"));
  }
}

std::vector<Finding> findings_before_run(const Experiment& experiment) {
  std::vector<Finding> findings = suspicions_of(experiment);
  std::ranges::move(foreseen_clamps(experiment), std::back_inserter(findings));
  return findings;
}

void tell(const std::vector<Finding>& findings) {
  for (const Finding& each : findings) print_notice("warning: " + in_words(each));
}

void tell_notes(const Experiment& experiment) {
  tell_ground_motion_notes(experiment);
  tell(suspicions_of(experiment));
}

std::string checked_text(const Experiment& experiment) {
  return ground_motion_text(experiment) + warning_lines(findings_before_run(experiment));
}

ExitCode show_plan(const Experiment& experiment, const std::optional<Shard>& shard, const ExecutionOptions& execution) {
  if (!execution.loudness.quiet) tell_ground_motion_notes(experiment);
  const Means means{.threads = execution.threads, .shard = shard, .page = execution.page == PageChoice::drawn};
  Plan plan = plan_of(experiment, means);
  plan.time = estimate_time(experiment, means, {.elapsed_seconds = seconds_from_now(), .stop = stop_on_signal()});
  if (why_stopped() == StopReason::signal) return ExitCode::interrupted;
  if (plan.time) plan.time->seconds /= execution.pool.processes;
  if (!plan.time) {
    print_notice(fmt::format("the time is not known: no realisation was finished within {:g} s", longest_sample_s));
  }
  print_study(execution.loudness, facts_text(plan_facts(plan)), plan_text(plan) + checked_text(experiment));
  return ExitCode::done;
}

CLI::Option* add_status(CLI::App& command, std::string& folder) {
  const std::vector<CLI::Option*> others = command.get_options();
  CLI::Option* status = command
                            .add_option("--status", folder,
                                        "Print how many realisations of the run in DIR are finished, missing and "
                                        "failed, also while it is in progress, and its remaining time; only reads")
                            ->transform(run_folder())
                            ->type_name("DIR");
  for (CLI::Option* other : others) status->excludes(other);
  return status;
}

ExitCode show_status(const std::string& folder, const Loudness& loudness) {
  const RunStatus found = status_of(folder);
  print_study(loudness, describe_as_json(found), describe(found, folder));
  return ExitCode::done;
}

}  // namespace rocking::program
