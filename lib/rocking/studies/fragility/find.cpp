#include <algorithm>
#include <string>
#include <utility>

#include "rocking/api/question_check.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_options.hpp"
#include "rocking/api/run_store.hpp"
#include "rocking/api/written_experiment.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/input/read_hazard.hpp"
#include "rocking/input/read_record_metadata.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/scene/hazard.hpp"
#include "rocking/store/store.hpp"
#include "rocking/studies/fragility/question.hpp"
#include "rocking/studies/fragility/rare_of_curves.hpp"
#include "rocking/studies/fragility/result.hpp"
#include "rocking/studies/fragility/study.hpp"
#include "rocking/text/files.hpp"

namespace rocking {
namespace {

void check(const FragilityQuestion& question) {
  QuestionCheck check(question);
  if (question.hazard) check.add(problems_of(*question.hazard));
  check.finish();
  if (const auto second = second_estimate(question.rare)) {
    const std::string intensity = base::shortest(question.rare[*second].level.intensity);
    refuse("rare/" + std::to_string(*second), "intensity " + intensity, "is a second estimate of the same probability");
  }
}

}  // namespace

RunFragility fragility(const Experiment& experiment, const RunResult& run, const FragilityQuestion& question,
                       const Execution& execution) {
  check_has_conditions(experiment);
  if (intensity_of(experiment).empty()) {
    refuse("/sweep", "",
           "sweeps no intensity of the excitation: /excitation/amplitude (or amplitude_g, amplitude_m_s2) or "
           "/excitation/scale (or pga_g, pgv_m_s)");
  }
  if (experiment.conditions.front().until) {
    refuse("/realisations", "until", "a fragility function needs a fixed number of realisations");
  }
  check(question);
  return run_fragility(with_text(experiment), stripes_of(experiment, store_of(run)), question,
                       OptionsOfExecution(execution).options());
}

std::string fragility_text(const RunFragility& found) { return fragility_document().text(fragility_report({found})); }

HazardCurve hazard_curve(const std::filesystem::path& file, const HazardReading& reading) {
  return read_hazard(read_file(file, most_hazard_bytes), file.string(), reading);
}

std::vector<RecordMetadata> record_metadata(const std::filesystem::path& file) {
  return read_record_metadata(read_file(file, most_metadata_bytes), file.string());
}

}  // namespace rocking
