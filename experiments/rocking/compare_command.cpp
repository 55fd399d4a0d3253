#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "commands.hpp"
#include "output.hpp"
#include "rocking/api/run_folder.hpp"
#include "rocking/output/comparison.hpp"
#include "rocking/studies/comparison.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking::program {
namespace {

struct CompareRequest {
  std::string first;
  std::string second;
  Extent extent = Extent::one_screen;
  Loudness loudness;
};

struct FinishedRun {
  Store store;
  Experiment experiment;
};

FinishedRun finished_run(const std::string& folder) {
  Store store = RunFolder(folder).open_valid_store();
  Experiment experiment = experiment_of(store.identity());
  return {std::move(store), std::move(experiment)};
}

ExitCode compare(const CompareRequest& request) {
  const FinishedRun first = finished_run(request.first);
  const FinishedRun second = finished_run(request.second);
  if (first.experiment.seed != second.experiment.seed) {
    throw UsageError(fmt::format(
        "{} and {} have different seeds, so no common random numbers; run one of them again with the seed of the "
        "other",
        request.first, request.second));
  }
  const std::size_t conditions = first.experiment.conditions.size();
  if (second.experiment.conditions.size() != conditions) {
    throw UsageError(fmt::format("{} has {}, {} has {}; compare runs with the same number of conditions", request.first,
                                 counted(conditions, "condition"), request.second,
                                 counted(second.experiment.conditions.size(), "condition")));
  }
  if (const auto place = condition_with_other_record(first.experiment, second.experiment)) {
    throw UsageError(fmt::format(
        "condition {} of {} and of {} has different records of a suite, so no common random numbers; compare runs with "
        "the same records in the same order",
        *place, request.first, request.second));
  }
  std::vector<double> confidences;
  for (const Condition& condition : first.experiment.conditions) confidences.push_back(condition.confidence);
  const Comparison found =
      comparison_of(first.experiment, second.experiment, compare(first.store, second.store, confidences));
  print_result(request.loudness.json ? comparison_document().text(found)
                                     : base::printable(comparison_table(found, first.experiment, request.extent)));
  return ExitCode::done;
}

}  // namespace

void add_compare(CLI::App& app, Action& action) {
  const auto request = std::make_shared<CompareRequest>();
  CLI::App* command = app.add_subcommand("compare", "Compare two runs, pairwise with common random numbers");
  command->footer(
      "Example: rocking compare out tighter\n"
      "compares each realisation of out with the realisation of tighter that has the same random numbers. Both runs "
      "have the same seed, number of conditions and records; they may differ in anything else (amplitude, tolerance, "
      "formulation, sigma).");
  command->add_option("DIR_A", request->first, "Folder of a run")->required();
  command->add_option("DIR_B", request->second, "Folder of another run")->required();
  add_extent(*command, request->extent);
  add_loudness(*command, request->loudness);
  command->final_callback([&action, request] { action = [request] { return compare(*request); }; });
}

}  // namespace rocking::program
