#include "rocking/studies/bifurcation/study.hpp"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <mutex>
#include <string>

#include "rocking/base/error.hpp"
#include "rocking/base/many_parts.hpp"
#include "rocking/realisation/continuation.hpp"

namespace rocking {
namespace {

/// Steps that must run one after the other: the unit of work.
struct Chain {
  Diagram* diagram;
  Branch branch;
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
    chains.push_back({&diagram, Branch::upwards, 0, size});
    chains.push_back({&diagram, Branch::downwards, 0, size});
  }
  for (Diagram& diagram : diagrams) {
    for (std::size_t i = 0; i < diagram.conditions.size(); ++i) chains.push_back({&diagram, Branch::initial, i, 1});
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

class DiagramWorkers {
 public:
  DiagramWorkers(const Experiment& experiment, std::uint64_t realisation, const RunOptions& options)
      : experiment_(&experiment), draws_(experiment.seed, realisation), options_(&options) {}

  /// Whether all steps were run.
  [[nodiscard]] bool run(std::vector<Diagram>& diagrams) {
    chains_ = chains_of(diagrams);
    for (const Chain& chain : chains_) all_ += chain.count;
    base::on_threads(
        options_->threads, [this](unsigned) { work(); }, [this] { has_failed_ = true; });
    return done_ == all_;
  }

 private:
  void work() {
    try {
      for (std::size_t i = next_++; i < chains_.size() && !is_to_stop(); i = next_++) follow(chains_[i]);
    } catch (const base::Stopped&) {
      // run() notices that steps are missing.
    }
  }

  void follow(const Chain& chain) {
    Continuation continuation(draws_, options_->stop_requested);
    for (std::size_t i = 0; i < chain.count && !is_to_stop(); ++i) {
      const std::size_t place = chain.branch == Branch::downwards ? chain.count - 1 - i : chain.first + i;
      const std::size_t index = chain.diagram->conditions[place];
      const Condition& condition = experiment_->conditions[index];
      const bool continued = continuation.can_go_on();
      DiagramStep step = step_of(continuation.run(condition), continued, condition.horizon);
      step.condition = index;
      steps_of(chain)[place] = std::move(step);
      const std::lock_guard lock(mutex_);
      ++done_;
      if (options_->on_progress) options_->on_progress(done_, all_);
    }
  }

  [[nodiscard]] bool is_to_stop() const { return has_failed_ || options_->stop_requested.is_made(); }

  const Experiment* experiment_;
  random::Draws draws_;
  const RunOptions* options_;
  std::vector<Chain> chains_;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::uint64_t done_ = 0;
  std::uint64_t all_ = 0;
  std::atomic<bool> has_failed_ = false;
};

void check_diagrams(const Experiment& experiment) {
  if (experiment.sweep_sizes.empty()) {
    throw base::InputError({"/sweep", "", "is missing: a diagram needs a swept parameter",
                            "add one, as [{\"parameter\": \"/excitation/amplitude\", \"from\": 3, \"to\": 5, "
                            "\"step\": 0.1}]"});
  }
  for (const Condition& condition : experiment.conditions) {
    if (!diagram_value(condition)) {
      throw base::InputError({"/sweep/0", condition.parameters.front().value,
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

std::optional<double> diagram_value(const Condition& condition) {
  const std::string& text = condition.parameters.front().value;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::vector<Diagram> diagrams_of(const Experiment& experiment) {
  check_diagrams(experiment);
  const std::size_t stride = experiment.conditions.size() / experiment.sweep_sizes.front();
  std::vector<Diagram> diagrams(stride);
  for (std::size_t i = 0; i < experiment.conditions.size(); ++i) diagrams[i % stride].conditions.push_back(i);
  const auto value = [&experiment](std::size_t i) { return *diagram_value(experiment.conditions[i]); };
  for (Diagram& diagram : diagrams) std::ranges::stable_sort(diagram.conditions, {}, value);
  return diagrams;
}

std::optional<std::vector<Diagram>> bifurcation(const Experiment& experiment, std::uint64_t realisation,
                                                const RunOptions& options) {
  std::vector<Diagram> diagrams = diagrams_of(experiment);
  if (!DiagramWorkers(experiment, realisation, options).run(diagrams)) return std::nullopt;
  return diagrams;
}

}  // namespace rocking
