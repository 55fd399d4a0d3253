#include "rocking/plan/plan.hpp"
#include "rocking/random/draws.hpp"
#include "rocking/realisation/start.hpp"

namespace rocking {
namespace {

constexpr std::size_t most_conditions = 100;
constexpr std::uint64_t sampled_realisations = 4000;

/// Adds the clamps of one realisation; false if it draws nothing.
bool add_clamps_of(const Condition& condition, const random::Draws& draws, Clamps& clamps) {
  const Start start = start_of(condition.scene, draws);
  Beginning beginning = begin_realisation(condition, draws, start, Strobe::poincare, 1);
  SceneCoefficients& coefficients = beginning.coefficients;
  static_cast<void>(coefficients.restitution());
  static_cast<void>(coefficients.amplitude(beginning.clock));
  if (coefficients.has_friction()) static_cast<void>(coefficients.kinetic_friction(beginning.clock));
  OperationCounts operations{.initial_draws = start.draws};
  coefficients.add_to(operations);
  clamps += start.clamps;
  clamps += coefficients.clamps();
  return operations.draws() > 0;
}

}  // namespace

std::vector<SampledClamps> sample_clamps(const Experiment& experiment) {
  std::vector<SampledClamps> found;
  const std::size_t every = experiment.conditions.size() / most_conditions + 1;
  for (std::size_t i = 0; i < experiment.conditions.size(); i += every) {
    const Condition& condition = experiment.conditions[i];
    SampledClamps here{.condition = i};
    const random::Draws draws(seed_of(condition, experiment.seed), 0);
    for (std::uint64_t k = 0; k < sampled_realisations; ++k, ++here.realisations) {
      if (!add_clamps_of(condition, draws.of(k), here.clamps)) break;
    }
    if (here.realisations > 0) found.push_back(here);
  }
  return found;
}

}  // namespace rocking
