#include <cstddef>
#include <string>
#include <vector>

#include "rocking/api/refuse.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/api/written_experiment.hpp"
#include "rocking/store/store.hpp"
#include "rocking/studies/comparison/comparison.hpp"
#include "rocking/studies/comparison/result.hpp"

namespace rocking {

Comparison compare(const StoredRun& first, const StoredRun& second) {
  const Experiment& experiment = first.experiment;
  if (second.experiment.seed != experiment.seed) {
    refuse("/seed", std::to_string(second.experiment.seed),
           "is another than that of the first run (" + std::to_string(experiment.seed) +
               "), so that the runs have no common random numbers; run one of them with the seed of the other");
  }
  if (second.experiment.conditions.size() != experiment.conditions.size()) {
    refuse("/sweep", "",
           "gives the runs different numbers of conditions: " + std::to_string(experiment.conditions.size()) + " and " +
               std::to_string(second.experiment.conditions.size()));
  }
  if (const auto place = condition_with_other_record(experiment, second.experiment)) {
    refuse("/excitation/suite", "",
           "gives condition " + std::to_string(*place) +
               " of the runs different records, so that they have no common random numbers; run both with the same "
               "records in the same order");
  }
  std::vector<double> confidences;
  for (const Condition& condition : experiment.conditions) confidences.push_back(condition.confidence);
  return comparison_of(with_text(experiment), with_text(second.experiment),
                       compare(store_of(first.run), store_of(second.run), confidences));
}

std::string compare_text(const Comparison& found) { return comparison_document().text(found); }

}  // namespace rocking
