#include "rocking/experiment/record.hpp"

#include <algorithm>

#include "rocking/experiment/horizon_run.hpp"
#include "rocking/experiment/realisation.hpp"

namespace rocking::experiment {

Record realise(const Condition& condition, std::uint64_t seed, std::uint64_t realisation, base::StopRequest stop) {
  const random::Draws draws(seed, realisation);
  const Start start = start_of(condition.scene, draws);
  const Beginning beginning =
      begin_realisation(condition, draws, start, Strobe::poincare, strobes_before_copy(condition));
  HorizonRun run(condition,
                 [&](dynamics::Observer& observer) { return motion_of(condition.scene, beginning, observer); });
  Record record = run_alone(run, stop);
  record.effort.initial_draws = start.draws;
  return record;
}

std::optional<std::int64_t> parting_period(const Record& a, const Record& b) {
  constexpr double apart = 0.01;
  const std::size_t common = std::min(a.strobe.size(), b.strobe.size());
  for (std::size_t k = 0; k < common; ++k) {
    const double tilt = a.strobe[k].tilt - b.strobe[k].tilt;
    const double rate = a.strobe[k].tilt_rate - b.strobe[k].tilt_rate;
    if (tilt * tilt + rate * rate > apart * apart) return static_cast<std::int64_t>(k) + 1;
  }
  if (a.strobe.size() != b.strobe.size()) return static_cast<std::int64_t>(common) + 1;
  return std::nullopt;
}

}  // namespace rocking::experiment
