#include "rocking/realisation/realisation_result.hpp"

#include <algorithm>
#include <cstddef>

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
  HorizonRun run(condition, draws, beginning,
                 [&](dynamics::Observer& observer) { return motion_of(condition.scene, beginning, observer); });
  if (has_long_run(condition, realisation)) run.observe_long_run();
  return run_alone(run, stop);
}

std::optional<std::int64_t> divergence_period(const RealisationResult& a, const RealisationResult& b) {
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

base::Sha256 digest_of(const RealisationResult& result, std::uint64_t realisation) {
  base::Sha256Builder builder;
  builder.add(realisation);
  builder.add(to_string(result.termination));
  builder.add(to_string(result.classification.mode));
  for (const section::StrobePoint& point : result.strobe) {
    builder.add(point.tilt);
    builder.add(point.tilt_rate);
    builder.add(point.slip_rate);
  }
  if (result.settling && result.settling->was_continued()) builder.add(result.settling->continued);
  if (result.settling && result.settling->long_run) builder.add(to_string(*result.settling->long_run));
  for (const std::uint64_t count : result.operations.events) builder.add(count);
  return builder.finish();
}

}  // namespace rocking
