#include "rocking/studies/orbits/study.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string_view>
#include <utility>

#include "rocking/api/question_check.hpp"
#include "rocking/api/refuse.hpp"
#include "rocking/api/run_options.hpp"
#include "rocking/api/written_experiment.hpp"
#include "rocking/base/error.hpp"
#include "rocking/base/number_text.hpp"
#include "rocking/input/condition_family.hpp"
#include "rocking/scene/check_condition.hpp"
#include "rocking/studies/orbits/bifurcation_curves.hpp"
#include "rocking/studies/orbits/branches.hpp"
#include "rocking/studies/orbits/orbits.hpp"
#include "rocking/studies/orbits/result.hpp"
#include "rocking/studies/orbits/table.hpp"

namespace rocking {
namespace {

/// The swept number over which orbits can be followed; absent if there is none.
std::optional<SweptNumber> followed_number(const Experiment& experiment) {
  if (experiment.canonical_text.empty()) return std::nullopt;
  auto swept = only_swept_number(experiment);
  return swept && can_be_continued(swept->pointer) ? swept : std::nullopt;
}

/// What is asked of branches. Throws where there are none.
BranchQuestion branch_question(const Experiment& experiment, const OrbitsRequest& request) {
  const auto swept = followed_number(experiment);
  if (!swept) {
    refuse(request.from || request.to ? "from" : "branches", "",
           "are followed over the sweep of one number of the motion alone; the experiment has none");
  }
  const auto [least, greatest] = std::ranges::minmax(swept->values);
  const ParameterRange range{.low = request.from.value_or(least), .high = request.to.value_or(greatest)};
  if (!(range.low < range.high)) {
    refuse("from", base::shortest(range.low),
           "must be less than the upper end of the range of branches, " + base::shortest(range.high));
  }
  return {.conditions = condition_family(experiment, swept->pointer),
          .values = swept->values,
          .range = range,
          .most_points = request.most_points,
          .most_branches = request.most_branches};
}

/// Adds the orbits on branches at the conditions to those that are known.
FoundBranches followed(const Experiment& experiment, const OrbitsRequest& request, base::StopRequest stop,
                       const std::function<void()>& on_point, std::vector<OrbitsOfCondition>& conditions) {
  BranchQuestion question = branch_question(experiment, request);
  question.on_point = on_point;
  return {.pointer = followed_number(experiment)->pointer,
          .range = question.range,
          .most_points = request.most_points,
          .study = branches_of(question, conditions, stop)};
}

/// The second parameter and its range, without the curves. Throws where they cannot be followed.
FoundCurves curve_request(const Experiment& experiment, const OrbitsRequest& request) {
  if (!request.branches) refuse("second", request.second.front(), "needs branches, whose bifurcations are followed");
  if (!request.second_from || !request.second_to || !(*request.second_from < *request.second_to)) {
    refuse("second_from", "",
           "and the upper end of the range of the second parameter must be given, the first below the second");
  }
  for (const std::string& pointer : request.second) {
    if (can_be_continued(pointer)) continue;
    refuse("second", pointer,
           "is no real number on which the motion depends continuously, such as /excitation/frequency_ratio or "
           "/friction/static");
  }
  FoundCurves found{.pointers = request.second,
                    .value = second_parameter(experiment, request.second).value,
                    .range = {.low = *request.second_from, .high = *request.second_to},
                    .most_points = request.most_curve_points,
                    .curves = {}};
  if (found.value >= found.range.low && found.value <= found.range.high) return found;
  refuse("second_from", base::shortest(found.range.low),
         "and " + base::shortest(found.range.high) + ", the range, must enclose the value of the experiment, " +
             base::shortest(found.value));
}

std::vector<BifurcationCurve> followed_curves(const Experiment& experiment, const FoundBranches& branches,
                                              const FoundCurves& asked, base::StopRequest stop,
                                              const std::function<void()>& on_point) {
  const SecondParameter second{.pointers = asked.pointers, .value = asked.value};
  const CurveQuestion question{.conditions = condition_plane(experiment, branches.pointer, second),
                               .ranges = {branches.range, asked.range},
                               .second = asked.value,
                               .most_points = asked.most_points,
                               .on_point = on_point};
  return bifurcation_curves(question, branches.study, stop);
}

}  // namespace

bool has_branches(const Experiment& experiment) {
  const auto swept = followed_number(experiment);
  return swept && std::ranges::min(swept->values) < std::ranges::max(swept->values);
}

void check_request(const Experiment& experiment, const OrbitsRequest& request) {
  check_has_conditions(experiment);
  check_fields(request);
  check_orbits(experiment);
  if (request.branches) static_cast<void>(branch_question(experiment, request));
  if (!request.second.empty()) static_cast<void>(curve_request(experiment, request));
}

OrbitStudy orbits(const Experiment& experiment, const OrbitsRequest& request, const Execution& execution) {
  check_request(experiment, request);
  const OptionsOfExecution asked(execution);
  auto conditions = orbits(experiment, request.longest, asked.options());
  if (!conditions) throw base::Stopped();
  OrbitStudy study{.longest = request.longest, .conditions = std::move(*conditions)};
  std::uint64_t points = 0;
  const auto on_point = [&points, &asked] {
    if (asked.options().on_progress) asked.options().on_progress(++points, 0);
  };
  if (request.branches) study.branches = followed(experiment, request, asked.stop(), on_point, study.conditions);
  if (request.second.empty()) return study;
  study.curves = curve_request(experiment, request);
  study.curves->curves = followed_curves(experiment, *study.branches, *study.curves, asked.stop(), on_point);
  return study;
}

std::string orbits_text(const Experiment& experiment, const OrbitStudy& study) {
  return orbits_document().text(orbits_report(with_text(experiment), study));
}

std::string orbits_table(const OrbitStudy& study) { return table_of(study); }

}  // namespace rocking
