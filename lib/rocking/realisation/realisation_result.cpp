#include "rocking/realisation/realisation_result.hpp"

#include "rocking/realisation/horizon_run.hpp"
#include "rocking/realisation/start.hpp"
#include "rocking/scene/check_condition.hpp"

namespace rocking {

RealisationResult realise(const Condition& condition, std::uint64_t seed, std::uint64_t realisation,
                          base::StopRequest stop) {
  check_condition(condition);
  return realise_unchecked(condition, seed, realisation, stop);
}

RealisationResult realise_unchecked(const Condition& condition, std::uint64_t seed, std::uint64_t realisation,
                                    base::StopRequest stop) {
  const random::Draws draws(seed_of(condition, seed), realisation);
  const Start start = start_of(condition.scene, draws);
  const Beginning beginning =
      begin_realisation(condition, draws, start, Strobe::poincare, strobes_before_window(condition));
  HorizonRun run(condition, beginning,
                 [&](dynamics::Observer& observer) { return motion_of(condition.scene, beginning, observer); });
  if (has_long_run(condition, realisation)) run.observe_long_run();
  return run_alone(run, stop);
}

}  // namespace rocking
