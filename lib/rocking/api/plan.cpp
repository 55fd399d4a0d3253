#include "rocking/api/run.hpp"

#include "rocking/api/run_options.hpp"
#include "rocking/api/shard.hpp"
#include "rocking/base/stop_request.hpp"
#include "rocking/output/plan_text.hpp"
#include "rocking/output/write_facts.hpp"
#include "rocking/scene/check_condition.hpp"

namespace rocking {

Plan plan(const Experiment& experiment, const std::function<double()>& elapsed_seconds, const Execution& execution) {
  check_experiment(experiment);
  if (execution.shard) check_shard(experiment, *execution.shard);
  const OptionsOfExecution asked(execution);
  const Means means{.threads = asked.options().threads, .shard = execution.shard};
  Plan found = plan_of(experiment, means);
  if (!elapsed_seconds) return found;
  found.time = estimate_time(experiment, means, {.elapsed_seconds = elapsed_seconds, .stop = asked.stop()});
  asked.stop().check();
  return found;
}

std::string describe(const Plan& plan) { return plan_text(plan); }

std::string describe_as_json(const Plan& plan) { return facts_text(plan_facts(plan)); }

}  // namespace rocking
