#include "analysis/check_output.hpp"

#include <map>
#include <string>
#include <utility>

#include "analysis/output_file.hpp"
#include "rocking/base/error.hpp"
#include "rocking/input/check_document.hpp"
#include "rocking/section/response_mode.hpp"

namespace rocking::analysis {
namespace {

void reject(Problems& problems, const std::string& place, const std::string& reason) {
  problems.push_back({place, "", reason, "write the file again with the command that made it"});
}

/// Checks the title of the experiment that is contained in an output.
void check_quoted_experiment(const Json& output, Problems& problems) {
  const Json& experiment = output["input"]["experiment"];
  if (!experiment.contains("title") || !experiment["title"].is_string()) {
    reject(problems, "/input/experiment/title", "is missing, or is not text");
  }
}

/// Each branch's points have as many states as its period, and places lead to what they name.
void check_orbits_output(const Json& output, Problems& problems) {
  check_quoted_experiment(output, problems);
  const std::size_t branches = output.contains("branches") ? output["branches"].size() : 0;
  for (std::size_t i = 0; i < branches && problems.empty(); ++i) {
    const Json& branch = output["branches"][i];
    for (std::size_t j = 0; j < branch["points"].size() && problems.empty(); ++j) {
      if (branch["points"][j]["points"].size() == branch["period"].get<std::size_t>()) continue;
      reject(problems, "/branches/" + std::to_string(i) + "/points/" + std::to_string(j) + "/points",
             "differs in length from the period of the branch");
    }
  }
  for (std::size_t i = 0; i < output["conditions"].size() && problems.empty(); ++i) {
    const Json& condition = output["conditions"][i];
    const std::string place = "/conditions/" + std::to_string(i);
    const Json& orbit = condition["run"]["orbit"];
    if (!orbit.is_null() && orbit.get<std::size_t>() >= condition["orbits"].size()) {
      reject(problems, place + "/run/orbit", "is not the place of an orbit");
    }
    if (branches == 0) continue;
    const std::string parameter = output["parameter"];
    if (!condition["parameters"].contains(parameter) || !condition["parameters"][parameter].is_number()) {
      reject(problems, place + "/parameters", "lacks a number for the parameter of the branches");
    }
  }
}

bool is_in_si_units(const Json& trajectory) { return trajectory.value("units", "normalised") == "si"; }

/// Every state must have the units that the file names, and the scales of the block must be there to convert them.
void check_units(const Json& trajectory, Problems& problems) {
  const bool si = is_in_si_units(trajectory);
  if (si && !(trajectory["block"].contains("shape_angle_rad") && trajectory["block"].contains("half_diagonal_m") &&
              trajectory["block"].contains("frequency_parameter_rad_s"))) {
    return reject(problems, "/block", "lacks the scales that belong to the units");
  }
  for (const char* list : {"strobe", "events", "history"}) {
    if (!trajectory.contains(list)) continue;
    const Json& states = trajectory[list];
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (states[i].contains(si ? "tilt_rad" : "tilt")) continue;
      return reject(problems, std::string("/") + list + '/' + std::to_string(i), "has other units than /units says");
    }
  }
}

void check_trajectory(const Json& output, Problems& problems) {
  const bool sampled = output.contains("samples_per_period");
  if (output.contains("history") != sampled) {
    return reject(problems, "/history", "and samples_per_period must both be given or both be absent");
  }
  check_units(output, problems);
  if (!sampled || !problems.empty()) return;
  const Json& history = output["history"];
  const char* time = is_in_si_units(output) ? "time_s" : "tau";
  for (std::size_t i = 1; i < history.size(); ++i) {
    if (history[i][time] > history[i - 1][time]) continue;
    return reject(problems, "/history/" + std::to_string(i) + '/' + time, "is not later than the previous sample");
  }
}

struct Format {
  const char* schema;
  void (*check)(const Json&, Problems&);
};

}  // namespace

void check_output(const Json& output) {
  static const std::map<std::string, Format> formats{{"rocking.trajectory/1", {"trajectory", check_trajectory}},
                                                     {"rocking.orbits/1", {"orbits", check_orbits_output}}};
  const auto format = formats.find(format_of(output));
  if (format == formats.end()) return;
  Problems problems;
  check_document(output, format->second.schema, "", problems);
  if (problems.empty()) format->second.check(output, problems);
  if (!problems.empty()) throw base::InputError(std::move(problems));
}

}  // namespace rocking::analysis
