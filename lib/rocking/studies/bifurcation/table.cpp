#include "rocking/studies/bifurcation/study.hpp"

#include <algorithm>
#include <set>

#include "rocking/input/quantities_in_text.hpp"
#include "rocking/output/parameter_text.hpp"
#include "rocking/output/shaking_text.hpp"
#include "rocking/text/json.hpp"
#include "rocking/text/number_text.hpp"

namespace rocking {
namespace {

const std::vector<Parameter>& parameters_of(const Experiment& experiment, std::size_t condition) {
  return experiment.conditions[condition].parameters;
}

/// With an asterisk if the previous step of the continuation did not reach its horizon.
std::string cell(const Diagram& diagram, DiagramBranch branch, std::size_t place) {
  const auto& steps = diagram.branches[static_cast<std::size_t>(branch)];
  const bool is_first = place == (branch == DiagramBranch::downwards ? steps.size() - 1 : 0);
  const bool restarts = branch != DiagramBranch::initial && !is_first && !steps[place].continued;
  return to_string(steps[place].classification.mode) + (restarts ? " *" : "");
}

/// Where the response depends on the start.
std::vector<std::size_t> coexistences(const Diagram& diagram) {
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < diagram.conditions.size(); ++i) {
    std::set<section::ResponseMode> modes;
    for (const auto& branch : diagram.branches) modes.insert(branch[i].classification.mode);
    if (modes.size() > 1) places.push_back(i);
  }
  return places;
}

/// `the response depends on the start at 12 of 25 values, from 0.45 to 0.75`.
std::string coexistence_in(const Experiment& experiment, const Diagram& diagram) {
  const std::vector<std::size_t> places = coexistences(diagram);
  const std::string all = counted(diagram.conditions.size(), "value");
  if (places.empty()) return "from each start the response is the same, at all of " + all + '\n';
  const auto value = [&](std::size_t place) {
    return short_value(parameters_of(experiment, diagram.conditions[place]).front());
  };
  return "the response depends on the start at " + std::to_string(places.size()) + " of " + all + ", from " +
         last_key(parameters_of(experiment, diagram.conditions.front()).front().pointer) + ' ' + value(places.front()) +
         " to " + value(places.back()) + '\n';
}

std::string table_of(const Experiment& experiment, const Diagram& diagram, Extent extent) {
  std::vector<std::string> swept;
  for (const Parameter& parameter : parameters_of(experiment, diagram.conditions.front()))
    swept.push_back(parameter.pointer);
  std::vector<std::optional<Shaking>> shakings;
  for (const std::size_t i : diagram.conditions) shakings.push_back(shaking_of(experiment.conditions[i].scene));
  const auto beside = shaking_columns(swept, shakings);
  look::Table table;
  add_columns(table, {last_key(swept.front())});
  add_columns(table, {beside.begin(), beside.end()});
  for (const DiagramBranch branch : all_branches) add_columns(table, {std::string(to_string(branch))});
  for (std::size_t i = 0; i < diagram.conditions.size(); ++i) {
    look::Row& row =
        table.rows.emplace_back(look::Row{short_value(parameters_of(experiment, diagram.conditions[i]).front())});
    for (const std::string_view key : beside) row.emplace_back(column_cell(shakings[i], key));
    for (const DiagramBranch branch : all_branches) row.emplace_back(cell(diagram, branch, i));
  }
  const std::string common = common_shaking(swept, shakings);
  if (!common.empty()) table.notes = "shaking: " + common + '\n';
  if (extent == Extent::one_screen) merge_rows(table, 0, 1 + beside.size());
  return coexistence_in(experiment, diagram) + '\n' + to_terminal(table);
}

/// The table of each diagram; on one screen of as many as fit there.
std::string all_tables(const Experiment& experiment, const std::vector<Diagram>& diagrams, Extent extent) {
  const auto depends = std::ranges::count_if(diagrams, [](const auto& each) { return !coexistences(each).empty(); });
  std::string text;
  if (diagrams.size() > 1) {
    text = "the response depends on the start in " + std::to_string(depends) + " of " +
           counted(diagrams.size(), "diagram") + "\n\n";
  }
  for (std::size_t i = 0; i < diagrams.size(); ++i) {
    const Diagram& diagram = diagrams[i];
    const auto& parameters = parameters_of(experiment, diagram.conditions.front());
    std::string name;
    for (std::size_t k = 1; k < parameters.size(); ++k) {
      const auto& [pointer, value, given] = parameters[k];
      name += (name.empty() ? "" : ", ") + (given.empty() ? pointer + " = " + json_text_of(value) : given);
    }
    const std::string next = (name.empty() ? "" : name + '\n') + table_of(experiment, diagram, extent) + '\n';
    if (i > 0 && !is_printed_whole(text + next, extent)) {
      text += counted(diagrams.size() - i, "more diagram") + '\n';
      break;
    }
    text += next;
  }
  text +=
      "initial: each step from the initial state of the file; upwards, downwards: from the end of the previous step\n";
  if (text.find(" *\n") != std::string::npos || text.find(" * ") != std::string::npos) {
    text += "*: from the initial state of the file, because the previous step did not reach its horizon\n";
  }
  return text;
}

}  // namespace

std::string bifurcation_csv(const Experiment& experiment, const std::vector<Diagram>& diagrams) {
  std::string text = "parameter,branch,tilt,tilt_rate,diagram\n";
  for (std::size_t i = 0; i < diagrams.size(); ++i) {
    for (const DiagramBranch branch : all_branches) {
      for (const DiagramStep& step : diagrams[i].branches[static_cast<std::size_t>(branch)]) {
        const std::string start = json_text_of(parameters_of(experiment, step.condition).front().value) + ',' +
                                  std::string(to_string(branch));
        for (const auto& point : step.points) {
          text += start + ',' + Json(point.tilt).dump() + ',' + Json(point.tilt_rate).dump() + ',' + std::to_string(i) +
                  '\n';
        }
      }
    }
  }
  return text;
}

std::string bifurcation_table(const Experiment& experiment, const std::vector<Diagram>& diagrams, Extent extent) {
  const std::string whole = all_tables(experiment, diagrams, Extent::all);
  if (is_printed_whole(whole, extent)) return whole;
  return all_tables(experiment, diagrams, Extent::one_screen) + "more rows: --all, and the files\n";
}

}  // namespace rocking
