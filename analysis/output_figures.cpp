#include "analysis/output_figures.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "analysis/bifurcation_figure.hpp"
#include "analysis/branch_figure.hpp"
#include "analysis/cost_figures.hpp"
#include "analysis/curve_figure.hpp"
#include "analysis/fragility_figure.hpp"
#include "analysis/histogram_figure.hpp"
#include "analysis/incremental_figure.hpp"
#include "analysis/infer_figures.hpp"
#include "analysis/motion_figure.hpp"
#include "analysis/output_file.hpp"
#include "analysis/rare_figures.hpp"
#include "analysis/trajectory_figures.hpp"
#include "rocking/base/error.hpp"
#include "rocking/output/check_normal_fields.hpp"
#include "rocking/output/motion_report.hpp"
#include "rocking/text/locate.hpp"

namespace rocking::analysis {
namespace {

/// Contents of the files, by kind.
struct Collection {
  std::vector<TrajectoryFile> trajectories;
  std::vector<Figure> figures;
  std::vector<BifurcationReport> bifurcations;
  std::vector<OrbitsReport> orbits;  ///< with branches
};

/// Branches are drawn over the strobe points of diagrams over the same parameter, and by themselves.
void draw_bifurcations(Collection& found) {
  for (const BifurcationReport& report : found.bifurcations) {
    for (Figure& figure : bifurcation_figures(report)) {
      for (const OrbitsReport& orbits : found.orbits) {
        if (orbits.study.branches->pointer == report.parameter) draw_branches_over(orbits.study, figure);
      }
      found.figures.push_back(std::move(figure));
    }
  }
  for (const OrbitsReport& orbits : found.orbits) {
    found.figures.push_back(branch_figure(orbits));
    if (orbits.study.curves && !orbits.study.curves->curves.empty()) found.figures.push_back(curve_figure(orbits));
  }
}

void collect(const OutputFile& file, Collection& found) {
  const Json output = parsed_output(file.text);
  const std::string format = format_of(output);
  if (format == "rocking.trajectory/1") {
    found.trajectories.push_back(
        shown(trajectory_document().read(output), std::filesystem::path(file.path).stem().string()));
  } else if (format == "rocking.bifurcation/1") {
    found.bifurcations.push_back(bifurcation_document().read(output));
  } else if (format == "rocking.orbits/1") {
    found.orbits.push_back(orbits_document().read(output));
    if (!found.orbits.back().study.branches) {
      throw base::InputError({.place = "/branches",
                              .value = "",
                              .reason = "are missing: a figure shows the branches of orbits",
                              .remedy = "sweep one number of the motion, and omit --no-branches"});
    }
  } else if (format == "rocking.cost/1") {
    for (Figure& figure : cost_figures(cost_document().read(output))) found.figures.push_back(std::move(figure));
  } else if (format == "rocking.fragility/1") {
    const FragilityReport report = fragility_document().read(output);
    found.figures.push_back(fragility_figure(report));
    if (auto figure = incremental_figure(report)) found.figures.push_back(std::move(*figure));
  } else if (format == "rocking.motion/1") {
    std::vector<Figure> figures = motion_figures(motion_document().read(output));
    if (figures.empty()) {
      throw base::InputError({.place = "/motions/0/series",
                              .value = "",
                              .reason = "is missing",
                              .remedy = "write the file with `rocking motion --json --series`"});
    }
    for (Figure& figure : figures) found.figures.push_back(std::move(figure));
  } else if (format == "rocking.rare/1") {
    std::vector<Figure> figures = rare_figures(rare_document().read(output));
    if (figures.empty()) {
      throw base::InputError({.place = "/conditions/0/paths",
                              .value = "",
                              .reason = "are missing: a figure shows how the event happens",
                              .remedy = "give `rocking rare` more time"});
    }
    for (Figure& figure : figures) found.figures.push_back(std::move(figure));
  } else if (format == "rocking.infer/1") {
    std::vector<Figure> figures = infer_figures(infer_document().read(output));
    if (figures.empty()) {
      throw base::InputError({.place = "/fit",
                              .value = "null",
                              .reason = "there is no answer yet: a figure shows the answer",
                              .remedy = "finish it with `rocking infer --resume`"});
    }
    for (Figure& figure : figures) found.figures.push_back(std::move(figure));
  } else if (format == "rocking.check_normal/1") {
    found.figures.push_back(normal_histogram(check_normal_document().read(output)));
  } else {
    throw base::InputError({.place = "/format",
                            .value = '"' + format + '"',
                            .reason = "has no figure in this command",
                            .remedy = "give a trajectory, a bifurcation, orbits with branches, a cost, a fragility, a "
                                      "motion, rare events, inferred unknowns or a check-normal; "
                                      "`rocking report DIR` draws a run"});
  }
}

void number_names(std::vector<Figure>& figures) {
  std::map<std::string, int> seen;
  for (Figure& figure : figures) {
    if (const int number = ++seen[figure.name]; number > 1) figure.name += '_' + std::to_string(number);
  }
}

}  // namespace

std::vector<Figure> output_figures(const std::vector<OutputFile>& files, const Window& window) {
  Collection found;
  for (const OutputFile& file : files) {
    try {
      collect(file, found);
    } catch (const base::InputError& error) {
      throw located(error, file.text, file.path);
    }
  }
  draw_bifurcations(found);
  std::vector<Figure> figures;
  std::vector<TrajectoryFile> with_history;
  for (const TrajectoryFile& file : found.trajectories) {
    if (file.history.empty()) continue;
    figures.push_back(time_history(file, window));
    with_history.push_back(file);
  }
  if (with_history.size() > 1) figures.push_back(responses(with_history, window));
  if (!with_history.empty()) figures.push_back(phase_portrait(with_history, window));
  if (!found.trajectories.empty()) figures.push_back(poincare(found.trajectories, window));
  for (Figure& figure : found.figures) figures.push_back(std::move(figure));
  number_names(figures);
  return figures;
}

}  // namespace rocking::analysis
