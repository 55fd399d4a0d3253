#include "dry_run.hpp"

#include <fmt/format.h>

#include "ground_motion_notes.hpp"
#include "interrupt.hpp"
#include "machine.hpp"
#include "rocking/output/ground_motion_facts.hpp"
#include "rocking/output/plan_text.hpp"
#include "study_file.hpp"

namespace rocking::program {

ExitCode show_plan(const Experiment& experiment, const std::optional<Shard>& shard, const ExecutionOptions& execution) {
  const Means means{.threads = execution.threads, .shard = shard, .page = execution.page == PageChoice::drawn};
  Plan plan = plan_of(experiment, means);
  plan.time = estimate_time(experiment, means, {.elapsed_seconds = seconds_from_now(), .stop = stop_on_signal()});
  if (why_stopped() == StopReason::signal) return ExitCode::interrupted;
  if (plan.time) plan.time->seconds /= execution.pool.processes;
  if (!plan.time) {
    print_notice(fmt::format("the time is not known: no realisation was finished within {:g} s", longest_sample_s));
  }
  print_study(execution.loudness, facts_text(plan_facts(plan)), plan_text(plan) + ground_motion_text(experiment));
  return ExitCode::done;
}

}  // namespace rocking::program
