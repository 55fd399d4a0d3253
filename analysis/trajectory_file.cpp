#include "analysis/trajectory_file.hpp"

#include <algorithm>

#include "analysis/output_file.hpp"
#include "rocking/base/error.hpp"

namespace rocking::analysis {
namespace {

/// The contact state after an event of this kind; empty: unchanged.
std::string contact_after(const std::string& kind) {
  if (kind == "lift" || kind == "impact_stick" || kind == "slip_stop") return "rock";
  if (kind == "impact_slip" || kind == "slip_start" || kind == "tip") return "rock_slide";
  if (kind == "slide_start" || kind == "to_slide") return "slide";
  if (kind == "slide_stop" || kind == "to_rest") return "rest";
  if (kind == "overturn") return "overturned";
  return "";
}

std::vector<ContactSpan> spans_of(const std::string& initial, const std::vector<EventRow>& events, double end) {
  std::vector<ContactSpan> spans{{.from = 0.0, .to = end, .contact = initial}};
  for (const EventRow& event : events) {
    const std::string next = contact_after(event.kind);
    if (next.empty() || next == spans.back().contact) continue;
    spans.back().to = event.time;
    if (spans.back().from == event.time) spans.pop_back();
    spans.push_back({.from = event.time, .to = end, .contact = next});
  }
  return spans;
}

/// Names of the quantities in a file, and the units of a normalised trajectory in those of the file.
struct FileUnits {
  const char* time = "tau";
  const char* tilt = "tilt";
  const char* tilt_rate = "tilt_rate";
  const char* slip = "slip";
  double shape_angle = 1.0, frequency_parameter = 1.0, half_diagonal = 1.0;

  [[nodiscard]] double tilt_of(const Json& state) const { return state.at(tilt).get<double>() / shape_angle; }
  [[nodiscard]] double tilt_rate_of(const Json& state) const {
    return state.at(tilt_rate).get<double>() / (shape_angle * frequency_parameter);
  }
  [[nodiscard]] double slip_of(const Json& state) const { return state.at(slip).get<double>() / half_diagonal; }
};

FileUnits units_of(const Json& output) {
  if (output.value("units", "normalised") != "si") return {};
  const Json& block = output.at("block");
  return {.time = "time_s",
          .tilt = "tilt_rad",
          .tilt_rate = "tilt_rate_rad_s",
          .slip = "slip_m",
          .shape_angle = block.at("shape_angle_rad"),
          .frequency_parameter = block.at("frequency_parameter_rad_s"),
          .half_diagonal = block.at("half_diagonal_m")};
}

void read_history(const Json& output, const FileUnits& units, TrajectoryFile& file) {
  const Json& history = output.at("history");
  const auto samples = output.at("samples_per_period").get<std::size_t>();
  if (samples == 0 || history.size() <= samples) {
    throw base::InputError(base::Problem{.place = "/history",
                                         .value = "",
                                         .reason = "is shorter than one period",
                                         .remedy = "run `rocking trajectory` over at least one period"});
  }
  const double period = history.at(samples).at(units.time).get<double>();  // 2 pi/Omega_h, or that over p
  const auto add = [&file, &units, period](const Json& state) {
    file.history.push_back({.time = state.at(units.time).get<double>() / period,
                            .tilt = units.tilt_of(state),
                            .tilt_rate = units.tilt_rate_of(state),
                            .slip = units.slip_of(state)});
  };
  for (const Json& sample : history) add(sample);
  for (const Json& event : output.at("events")) {
    add(event);
    file.events.push_back({.time = file.history.back().time, .kind = event.at("kind")});
  }
  std::stable_sort(file.history.begin(), file.history.end(),
                   [](const HistoryRow& a, const HistoryRow& b) { return a.time < b.time; });
  file.contacts = spans_of(history.at(0).at("contact"), file.events, file.history.back().time);
}

}  // namespace

TrajectoryFile read_trajectory(const Json& output, const std::string& name) {
  TrajectoryFile file;
  file.name = name;
  read_or_refuse(output, [&] {
    file.condition = output.at("condition");
    file.realisation = output.at("realisation");
    const FileUnits units = units_of(output);
    for (const Json& point : output.at("strobe")) {
      file.strobe.push_back(
          {.period = point.at("period"), .tilt = units.tilt_of(point), .tilt_rate = units.tilt_rate_of(point)});
    }
    if (output.contains("history")) read_history(output, units, file);
  });
  return file;
}

}  // namespace rocking::analysis
