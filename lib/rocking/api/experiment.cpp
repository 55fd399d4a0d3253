#include "rocking/api/experiment.hpp"

#include <utility>

#include "rocking/base/build_info.hpp"
#include "rocking/input/read_experiment.hpp"
#include "rocking/output/mode_look.hpp"
#include "rocking/output/write_facts.hpp"
#include "rocking/scene/check_condition.hpp"

namespace rocking {

Experiment read_experiment(const std::filesystem::path& file, const Overrides& overrides) {
  return read_experiment_file(file, overrides);
}

Experiment parse_experiment(std::string_view text, const std::filesystem::path& folder, const std::string& name,
                            const Overrides& overrides) {
  return experiment_in(ExperimentText{.text = std::string(text), .name = name, .folder = folder}, overrides);
}

Experiment experiment_of(std::vector<Condition> conditions, const Declaration& declaration) {
  if (conditions.empty()) {
    throw base::InputError({"", "", "the experiment has no condition", "give at least one"});
  }
  Experiment experiment{
      .title = declaration.title, .seed = declaration.seed, .conditions = std::move(conditions), .canonical_text = {}};
  check_experiment(experiment);
  return experiment;
}

std::string describe_as_json(const Experiment& experiment) { return validation_text(experiment); }

std::string describe_as_json(const base::InputError& error) { return validation_text(error.problems()); }

std::string name_of(const section::ResponseMode& mode) { return to_string(mode); }

std::string_view colour_of(const section::ResponseMode& mode) { return look_of(mode).colour; }

std::optional<section::ResponseMode> mode_named(std::string_view name) { return section::response_mode_named(name); }

std::string version() { return base::build_info().version; }

}  // namespace rocking
