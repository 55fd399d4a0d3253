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

void read_history(const Json& output, TrajectoryFile& file) {
  const Json& history = output.at("history");
  const auto samples = output.at("samples_per_period").get<std::size_t>();
  if (samples == 0 || history.size() <= samples) {
    throw base::InputError(base::Problem{.place = "/history",
                                         .value = "",
                                         .reason = "is shorter than one period",
                                         .remedy = "run `rocking trajectory` over at least one period"});
  }
  const double period = history.at(samples).at("tau").get<double>();  // 2 pi/Omega_h
  const auto add = [&file, period](const Json& state) {
    file.history.push_back({.time = state.at("tau").get<double>() / period,
                            .tilt = state.at("tilt"),
                            .tilt_rate = state.at("tilt_rate"),
                            .slip = state.at("slip")});
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
    for (const Json& point : output.at("strobe")) {
      file.strobe.push_back(
          {.period = point.at("period"), .tilt = point.at("tilt"), .tilt_rate = point.at("tilt_rate")});
    }
    if (output.contains("history")) read_history(output, file);
  });
  return file;
}

}  // namespace rocking::analysis
