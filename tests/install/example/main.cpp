// Reads an experiment, runs it, looks at the result; makes one in C++; stops one. Prints the digest of the first.
//
// usage: example EXPERIMENT

#include <atomic>
#include <cstdint>
#include <iostream>
#include <string>

#include <rocking/rocking.hpp>

namespace {

/// The example of the file, made in C++.
rocking::Condition condition() {
  rocking::Condition condition;
  condition.scene.block = {.width = 1.0, .height = 4.0};
  condition.scene.restitution = 0.9;
  condition.scene.excitation =
      rocking::Harmonic{.amplitude = 2.0, .frequency_ratio = 10.0, .phase = rocking::Uniform{0.0, 6.28}};
  condition.horizon = {.transient_periods = 20, .sampled_periods = 20};
  condition.realisations = 10;
  return condition;
}

int failures = 0;

void expect(bool holds, const char* what) {
  if (holds) return;
  std::cerr << "does not hold: " << what << '\n';
  ++failures;
}

void refuses_a_bad_block() {
  rocking::Condition bad = condition();
  bad.scene.block.width = -1.0;
  try {
    static_cast<void>(rocking::experiment_of({bad}));
    expect(false, "a width of -1 is refused");
  } catch (const rocking::base::InputError& error) {
    expect(error.problems().front().place == "/block/width_m", "the error has the place");
  }
}

void stops(const rocking::Experiment& experiment) {
  std::atomic<bool> stop{true};
  const rocking::RunResult run = rocking::run(experiment, {.stop = &stop});
  expect(!run.is_complete() && run.all == 10 && run.done < run.all, "a flag stops the run");
  const rocking::RunResult told =
      rocking::run(experiment, {.on_progress = [](std::uint64_t, std::uint64_t) { return rocking::Decision::stop; }});
  expect(told.done <= told.all, "the function that is called with the progress stops the run");
}

}  // namespace

int main(int, char** argv) {
  const rocking::Experiment experiment = rocking::read_experiment(argv[1]);
  const rocking::RunResult run = rocking::run(experiment, {.threads = 2});
  for (const auto& [mode, probability] : run.result->conditions[0].modes) {
    std::cerr << rocking::name_of(mode) << ' ' << probability.estimate << '\n';
  }
  const rocking::Experiment made = rocking::experiment_of({condition()}, {.seed = 1});
  expect(rocking::digest_of(rocking::run(made)) == rocking::digest_of(run), "C++ and the file give the same bits");
  expect(rocking::trajectory(experiment, {.periods = 5}).strobe.size() == 5, "a trajectory has its strobe points");
  expect(rocking::report(made, rocking::run(made)).find("\"digest\"") != std::string::npos, "a report is written");
  expect(rocking::plan(experiment).realisations == 10, "a plan has the realisations");
  expect(rocking::table(experiment, run).find("10 realisations") != std::string::npos, "a table is written");
  const rocking::RunCheck check = rocking::verify_report(rocking::report(experiment, run));
  expect(check.checked == 10 && check.findings.empty(), "a report is verified without a store");
  refuses_a_bad_block();
  stops(experiment);
  std::cout << rocking::digest_of(run) << '\n';
  return failures == 0 ? 0 : 1;
}
