#include "rocking/studies/bifurcation/study.hpp"

#include <algorithm>
#include <mutex>

#include "rocking/api/refuse.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/many_parts.hpp"
#include "rocking/input/quantities_in_text.hpp"
#include "rocking/realisation/continuation.hpp"
#include "rocking/scene/check_condition.hpp"

namespace rocking {
namespace {

/// Steps that must run one after the other: the unit of work.
struct Chain {
  Diagram* diagram;
  DiagramBranch branch;
  std::size_t first;  ///< places in the diagram's conditions
  std::size_t count;
};

std::vector<DiagramStep>& steps_of(const Chain& chain) {
  return chain.diagram->branches[static_cast<std::size_t>(chain.branch)];
}

/// Long chains first.
std::vector<Chain> chains_of(std::vector<Diagram>& diagrams) {
  std::vector<Chain> chains;
  for (Diagram& diagram : diagrams) {
    const std::size_t size = diagram.conditions.size();
    for (auto& steps : diagram.branches) steps.resize(size);
    chains.push_back({&diagram, DiagramBranch::upwards, 0, size});
    chains.push_back({&diagram, DiagramBranch::downwards, 0, size});
  }
  for (Diagram& diagram : diagrams) {
    for (std::size_t i = 0; i < diagram.conditions.size(); ++i)
      chains.push_back({&diagram, DiagramBranch::initial, i, 1});
  }
  return chains;
}

DiagramStep step_of(const RealisationResult& result, bool continued, const Horizon& horizon) {
  DiagramStep step{
      .continued = continued, .termination = result.termination, .classification = result.classification, .points = {}};
  if (result.termination != dynamics::Termination::reached_horizon) return step;
  step.points.assign(result.strobe.end() - horizon.sampled_periods, result.strobe.end());
  return step;
}

/// The value of the first swept parameter; absent if it is not a number.
std::optional<double> diagram_value(const Condition& condition) {
  return number_in(condition.parameters.front().value);
}

void check_diagrams(const Experiment& experiment) {
  if (experiment.sweep_sizes.empty()) {
    throw base::InputError(
        {"/sweep", "", "is missing: a diagram needs a swept parameter",
         "add one, as [{\"parameter\": \"/excitation/amplitude\", \"from\": 3, \"to\": 5, \"step\": 0.1}]"});
  }
  for (const Condition& condition : experiment.conditions) {
    if (!diagram_value(condition)) {
      throw base::InputError({"/sweep/0", json_text_of(condition.parameters.front().value),
                              "is not a number: the first swept parameter must take numbers",
                              "make a parameter with numerical values the first entry"});
    }
    if (!is_periodic(condition.scene.excitation)) {
      throw base::InputError({"/excitation/kind", '"' + std::string(name_of(condition.scene.excitation)) + '"',
                              "has no periods at which a diagram could be sampled", "give a harmonic excitation"});
    }
  }
}

}  // namespace

std::vector<Diagram> diagrams_of(const Experiment& experiment) {
  check_diagrams(experiment);
  check_strobe(experiment);
  const std::size_t stride = experiment.conditions.size() / experiment.sweep_sizes.front();
  std::vector<Diagram> diagrams(stride);
  for (std::size_t i = 0; i < experiment.conditions.size(); ++i) diagrams[i % stride].conditions.push_back(i);
  const auto value = [&experiment](std::size_t i) { return *diagram_value(experiment.conditions[i]); };
  for (Diagram& diagram : diagrams) std::ranges::stable_sort(diagram.conditions, {}, value);
  return diagrams;
}

std::vector<Diagram> bifurcation(const Experiment& experiment, std::uint64_t realisation, const Execution& execution) {
  expect("realisation", realisation, std::uint64_t{0}, std::uint64_t{999'999'999});
  check_has_conditions(experiment);
  std::vector<Diagram> diagrams = diagrams_of(experiment);
  const OptionsOfExecution asked(execution);
  const std::vector<Chain> chains = chains_of(diagrams);
  const std::uint64_t all = all_branches.size() * experiment.conditions.size();
  std::uint64_t done = 0;
  std::mutex mutex;
  base::for_each_part({.threads = asked.options().threads, .stop = asked.stop()}, chains.size(), [&](std::size_t c) {
    const Chain& chain = chains[c];
    Continuation continuation(random::Draws(experiment.seed, realisation), asked.stop());
    for (std::size_t i = 0; i < chain.count; ++i) {
      asked.stop().check();
      const std::size_t place = chain.branch == DiagramBranch::downwards ? chain.count - 1 - i : chain.first + i;
      const std::size_t index = chain.diagram->conditions[place];
      const Condition& condition = experiment.conditions[index];
      const bool continued = continuation.can_go_on();
      DiagramStep step = step_of(continuation.run(condition), continued, condition.horizon);
      step.condition = index;
      steps_of(chain)[place] = std::move(step);
      const std::lock_guard lock(mutex);
      ++done;
      if (asked.options().on_progress) asked.options().on_progress(done, all);
    }
  });
  return diagrams;
}

}  // namespace rocking
