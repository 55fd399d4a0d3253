#pragma once

#include <functional>
#include <string>

#include "rocking/api/export.hpp"
#include "rocking/api/run.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/plan/plan.hpp"

/// What a run would do, before it starts.
namespace rocking {

/// Numbers of conditions, realisations and periods of a run, its disk space and memory, which effects are on and, with a
/// clock, its time: from a sample of the realisations, which takes at most two seconds. `elapsed_seconds` gives the time
/// since some instant [s] and is called by two threads; the library reads no clock itself. Uses `threads`, `shard` and
/// `stop` of the execution; writes nothing. Throws base::InputError if a condition or the shard is not valid, and
/// base::Stopped if it is asked to stop.
[[nodiscard]] ROCKING_API Plan plan(const Experiment& experiment, const std::function<double()>& elapsed_seconds = {},
                                    const Execution& execution = {});

/// A plan in words, as `rocking run --dry-run` prints it.
[[nodiscard]] ROCKING_API std::string describe(const Plan& plan);

/// The same as JSON text, as with `--json`.
[[nodiscard]] ROCKING_API std::string describe_as_json(const Plan& plan);

}  // namespace rocking
