#include "rocking/studies/studies.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "rocking/base/error.hpp"
#include "rocking/figures/trajectory_figures.hpp"
#include "rocking/output/trajectory_report.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/locate.hpp"

namespace rocking::analysis {
namespace {

/// The study that writes documents of this format and draws them; null: there is none.
const Study* drawn_study(std::string_view format) {
  for (const Study* study : studies()) {
    if (study->figures != nullptr && study->document.format() == format) return study;
  }
  return nullptr;
}

Json parsed_output(std::string_view text) {
  std::vector<base::Problem> problems;
  Json output = parse_json(text, problems);
  if (!problems.empty()) throw base::InputError(std::move(problems));
  if (!output.is_object() || !output.contains("format") || !output["format"].is_string()) {
    throw base::InputError({"/format", "", "is missing: this is not a file that rocking wrote",
                            "give the output of `rocking trajectory`, `bifurcation`, `cost --json`, `fragility --json` "
                            "or `check-normal --json`"});
  }
  const auto format = output["format"].get<std::string>();
  if (format == trajectory_document().format() || drawn_study(format) != nullptr) return output;
  throw base::InputError(
      {"/format", '"' + format + '"', "has no figure in this command",
       "give a trajectory, a bifurcation, orbits with branches, thresholds, a cost, a fragility, a motion, rare "
       "events, inferred unknowns or a check-normal; `rocking report DIR` draws a run"});
}

template <class Use>
void located_in(const OutputFile& file, const Use& use) {
  try {
    use();
  } catch (const base::InputError& error) {
    throw located(error, file.text, file.path);
  }
}

void number_names(std::vector<Figure>& figures) {
  std::map<std::string, int> seen;
  for (Figure& figure : figures) {
    if (const int number = ++seen[figure.name]; number > 1) figure.name += '_' + std::to_string(number);
  }
}

std::vector<Figure> trajectory_figures(const std::vector<TrajectoryFile>& files, const Window& window) {
  std::vector<Figure> figures;
  std::vector<TrajectoryFile> with_history;
  for (const TrajectoryFile& file : files) {
    if (file.history.empty()) continue;
    figures.push_back(time_history(file, window));
    with_history.push_back(file);
  }
  if (with_history.size() > 1) figures.push_back(responses(with_history, window));
  if (!with_history.empty()) figures.push_back(phase_portrait(with_history, window));
  if (!files.empty()) figures.push_back(poincare(files, window));
  return figures;
}

}  // namespace

std::vector<Figure> output_figures(const std::vector<OutputFile>& files, const Window& window) {
  std::vector<Json> outputs;
  std::vector<TrajectoryFile> trajectories;
  for (const OutputFile& file : files) {
    located_in(file, [&] {
      outputs.push_back(parsed_output(file.text));
      if (outputs.back()["format"] != trajectory_document().format()) return;
      trajectories.push_back(
          shown(trajectory_document().read(outputs.back()), std::filesystem::path(file.path).stem().string()));
    });
  }
  std::vector<Figure> figures = trajectory_figures(trajectories, window);
  for (std::size_t i = 0; i < files.size(); ++i) {
    const Study* study = drawn_study(outputs[i]["format"].get<std::string>());
    if (study == nullptr) continue;
    located_in(files[i], [&] {
      std::vector<Figure> drawn = study->figures(outputs[i], outputs);
      if (drawn.empty()) throw base::InputError(study->without_figures);
      for (Figure& figure : drawn) figures.push_back(std::move(figure));
    });
  }
  number_names(figures);
  return figures;
}

std::vector<TextFile> output_tables(const std::vector<OutputFile>& files) {
  std::vector<TextFile> tables;
  std::map<std::string, int> seen;
  for (const OutputFile& file : files) {
    const Json output = parsed_output(file.text);
    const Study* study = drawn_study(output["format"].get<std::string>());
    if (study == nullptr) continue;
    for (TextFile& table : table_files(*study, output, {"csv", "latex"})) {
      if (const int number = ++seen[table.name]; number > 1) {
        table.name.insert(table.name.rfind('.'), '_' + std::to_string(number));
      }
      tables.push_back(std::move(table));
    }
  }
  return tables;
}

}  // namespace rocking::analysis
