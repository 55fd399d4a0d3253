// Cost of a period of motion at a given error of the end state, on one thread. Our integrator, alone and in lanes (the
// same bits), is compared with Boost.odeint (odeint_block.hpp). Both use the coarsest tolerance of a sequence at which
// the median error of their end states, compared with ours at 1e-15, is at most `wanted_error`. The pipeline is the work
// of a run for realisations of 620 periods: motion in lanes, classification, digest, row of the store. The last lines
// give times, errors and ratios.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "benchmarks/follow.hpp"
#include "rocking/realisation/realisation_result.hpp"
#include "rocking/realisation/realisation_scheduler.hpp"
#include "rocking/store/store.hpp"
#include "support/temporary_folder.hpp"

namespace {

using namespace rocking;
using namespace rocking::benchmarks;

constexpr double wanted_error = 2e-11;

struct Integrator {
  std::string name;
  Follow follow;
};

void follow_all(benchmark::State& state, const Case& c, const Follow& follow, const Calibration& calibration) {
  std::vector<differential::Question> questions;
  for (int start = 0; start < starts; ++start) questions.push_back(question_of(c, start));
  for (auto _ : state) {
    for (const auto& question : questions) benchmark::DoNotOptimize(follow(question, calibration.tolerance));
  }
  state.SetItemsProcessed(state.iterations() * starts * periods);
}

void follow_in_lanes(benchmark::State& state, const Case& c, const Calibration& calibration) {
  constexpr int at_a_time = 128;
  SideBySide realisations(c, calibration.tolerance, lanes::available_kernels().back());
  for (auto _ : state) benchmark::DoNotOptimize(realisations.finish(at_a_time));
  state.SetItemsProcessed(state.iterations() * at_a_time * periods);
}

void run_pipeline(benchmark::State& state, const Case& c, const Calibration& calibration) {
  constexpr std::size_t at_a_time = 128;
  const support::TemporaryFolder folder;
  auto store = Store::create(folder / "benchmark.sqlite", {});
  std::vector<Condition> conditions;
  for (int start = 0; start < starts; ++start) {
    conditions.push_back(question_of(c, start).condition);
    conditions.back().tolerance = calibration.tolerance;
  }
  RealisationScheduler scheduler(0x2012, lanes::available_kernels().back());
  std::size_t id = 0;
  std::int64_t done = 0;
  for (auto _ : state) {  // the scheduler stays full from one iteration to the next
    for (std::size_t finished = 0; finished < at_a_time;) {
      for (; scheduler.wants_more(); ++id) scheduler.start({&conditions[id % starts], id}, id);
      for (const auto& [number, result] : scheduler.work()) {
        store.add({.condition = 0, .realisation = number}, summarise(result, number));
        done += static_cast<std::int64_t>(result.strobe.size());
        ++finished;
      }
    }
  }
  store.commit();
  state.SetItemsProcessed(done);
}

/// Prints the usual table and keeps the shortest time per period of each benchmark.
class Table : public benchmark::ConsoleReporter {
 public:
  void expect(const std::string& scene, const std::string& integrator, const Calibration& calibration) {
    order_.push_back(scene + ": " + integrator);
    rows_[order_.back()] = {.peer = scene + ": odeint", .calibration = calibration};
  }

  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      double& least = rows_.at(run.benchmark_name()).microseconds;
      const double microseconds = 1e6 / run.counters.at("items_per_second");
      least = least == 0.0 ? microseconds : std::min(least, microseconds);
    }
  }

  void print() const {
    std::printf("\n%-44s %9s %9s %9s %10s %10s\n", "", "tolerance", "median", "largest", "us a", "odeint's");
    std::printf("%-44s %9s %9s %9s %10s %10s\n", "", "", "error", "error", "period", "time over");
    for (const std::string& name : order_) {
      const Row& row = rows_.at(name);
      if (row.microseconds == 0.0) continue;
      std::printf("%-44s %9.1e %9.1e %9.1e %10.3f %10.2f\n", name.c_str(), row.calibration.tolerance,
                  row.calibration.median, row.calibration.largest, row.microseconds,
                  rows_.at(row.peer).microseconds / row.microseconds);
    }
  }

 private:
  struct Row {
    std::string peer;
    Calibration calibration{};
    double microseconds = 0.0;  ///< 0: not run
  };
  std::vector<std::string> order_;
  std::map<std::string, Row> rows_;
};

void register_all(Table& table) {
  const std::array<Integrator, 2> integrators{{{"ours alone", follow_by_ours}, {"odeint", follow_by_odeint}}};
  for (const Case& c : usual_cases()) {
    const auto enlist = [&](const std::string& name, const Calibration& calibration, auto run) {
      table.expect(c.name, name, calibration);
      benchmark::RegisterBenchmark((c.name + ": " + name).c_str(), run)->Unit(benchmark::kMicrosecond);
    };
    for (const Integrator& integrator : integrators) {
      const Calibration calibration = calibrate(c, integrator.follow, wanted_error);
      enlist(integrator.name, calibration, [c, integrator, calibration](benchmark::State& state) {
        follow_all(state, c, integrator.follow, calibration);
      });
      if (integrator.name != "ours alone") continue;
      enlist("ours in lanes", calibration,
             [c, calibration](benchmark::State& state) { follow_in_lanes(state, c, calibration); });
      enlist("our pipeline", calibration,
             [c, calibration](benchmark::State& state) { run_pipeline(state, c, calibration); });
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 64;
  Table table;
  register_all(table);
  benchmark::RunSpecifiedBenchmarks(&table);
  table.print();
  return 0;
}
