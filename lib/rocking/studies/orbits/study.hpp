#pragma once

#include "rocking/fields/document.hpp"
#include "rocking/fields/struct_type.hpp"
#include "rocking/fields/value_type.hpp"
#include "rocking/figures/figure.hpp"
#include "rocking/look/text_table.hpp"
#include "rocking/output/provenance.hpp"
#include "rocking/studies/orbits/question.hpp"
#include "rocking/study/study.hpp"

namespace rocking {

/// The periodic orbits of an experiment.
struct OrbitsReport {
  InputFacts input;
  OrbitStudy study;
};

/// The number that a condition has at this JSON pointer of the sweep; absent if there is none.
[[nodiscard]] std::optional<double> swept_number(const OrbitsOfCondition& condition, const std::string& pointer);

[[nodiscard]] OrbitsReport orbits_report(const Experiment& experiment, OrbitStudy study);

[[nodiscard]] const StructType& fields_of(const OrbitsReport*);

/// `orbits.json`, and the output of `rocking orbits --json`. Equal input gives equal bytes.
[[nodiscard]] const DocumentOf<OrbitsReport>& orbits_document();

/// Reports what contradicts itself: a place that leads to nothing, an orbit whose points are not as many as its period,
/// branches over a number that the conditions do not have.
void check_orbits_report(const OrbitsReport& report, const ReadingPlace& place);

/// Periodic orbits as text: how many stable ones coexist, and which response modes of runs are backed by an orbit; a row for
/// each orbit; the branches and their bifurcations. On one screen the stable orbits of each range of conditions, and of the
/// branches and bifurcations what fits there.
[[nodiscard]] std::string table_of(const OrbitStudy& study, Extent extent = Extent::all);

[[nodiscard]] const StructType& fields_of(const OrbitsQuestion*);

/// The question, with branches where there is something to follow. Throws as orbits() where it cannot be answered.
[[nodiscard]] OrbitsQuestion checked(const Experiment& experiment, OrbitsQuestion question);

[[nodiscard]] const Study& orbits_study();

}  // namespace rocking

namespace rocking::analysis {

/// The figure `branches` of periodic orbits: Theta at the section against the parameter, stable orbits as solid lines in
/// the colour of their response mode (the eight most frequent ones) and unstable ones as dashed lines, bifurcations as
/// markers, and the orbits on which the runs of the conditions ended as points. The axis of Theta shows the range of the
/// stable orbits and of these points. Precondition: the study has branches.
[[nodiscard]] Figure branch_figure(const OrbitsReport& report);

/// Draws the branches over each panel of a figure of `rocking bifurcation` over the same parameter. Precondition: the
/// study has branches.
void draw_branches_over(const OrbitStudy& study, Figure& figure);

}  // namespace rocking::analysis
