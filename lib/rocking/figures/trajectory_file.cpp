#include "rocking/figures/trajectory_file.hpp"

#include <algorithm>
#include <optional>

#include "rocking/base/error.hpp"

namespace rocking::analysis {
namespace {

using dynamics::ContactState;
using dynamics::EventKind;

/// The contact state after an event of this kind; absent: unchanged.
std::optional<ContactState> contact_after(EventKind kind) {
  switch (kind) {
    case EventKind::lift:
    case EventKind::impact_stick:
    case EventKind::slip_stop: return ContactState::rock;
    case EventKind::impact_slip:
    case EventKind::slip_start:
    case EventKind::tip: return ContactState::rock_slide;
    case EventKind::slide_start:
    case EventKind::to_slide: return ContactState::slide;
    case EventKind::slide_stop:
    case EventKind::to_rest: return ContactState::rest;
    case EventKind::overturn: return ContactState::overturned;
    case EventKind::slip_reverse:
    case EventKind::past_balance: return std::nullopt;
  }
  return std::nullopt;
}

std::vector<ContactSpan> spans_of(ContactState initial, const std::vector<EventRow>& events, double end) {
  std::vector<ContactSpan> spans{{.from = 0.0, .to = end, .contact = initial}};
  for (const EventRow& event : events) {
    const auto next = contact_after(event.kind);
    if (!next || *next == spans.back().contact) continue;
    spans.back().to = event.time;
    if (spans.back().from == event.time) spans.pop_back();
    spans.push_back({.from = event.time, .to = end, .contact = *next});
  }
  return spans;
}

HistoryRow row_of(double time, const ReportedState& state, double period, const TrajectoryScales& scales) {
  const double share = scales.share(state.tilt, state.tilt_rate);
  return {.time = time / period,
          .tilt = state.tilt / scales.tilt / share,
          .tilt_rate = state.tilt_rate / scales.tilt_rate / share,
          .slip = state.slip / scales.slip};
}

void add_history(const TrajectoryReport& report, TrajectoryFile& file) {
  const TrajectoryScales scales = report.scales();
  const auto samples = static_cast<std::size_t>(report.samples_per_period.value());
  if (report.history.size() <= samples) {
    throw base::InputError(base::Problem{"/history", "", "is shorter than one period",
                                         "run `rocking trajectory` over at least one period"});
  }
  const double period = report.history[samples].time;  // 2 pi/Omega_h, or that over p
  for (const ReportedSample& sample : report.history) {
    file.history.push_back(row_of(sample.time, sample.state, period, scales));
  }
  for (const ReportedEvent& event : report.events) {
    file.history.push_back(row_of(event.time, event.state, period, scales));
    file.events.push_back({.time = file.history.back().time, .kind = event.kind});
  }
  std::ranges::stable_sort(file.history, {}, &HistoryRow::time);
  file.contacts = spans_of(report.history.front().contact, file.events, file.history.back().time);
}

}  // namespace

TrajectoryFile shown(const TrajectoryReport& report, const std::string& name) {
  TrajectoryFile file;
  file.name = name;
  file.condition = report.key.condition;
  file.realisation = report.key.realisation;
  const TrajectoryScales scales = report.scales();
  for (const ReportedStrobe& strobe : report.strobe) {
    const double share = scales.share(strobe.state.tilt, strobe.state.tilt_rate);
    file.strobe.push_back({.period = static_cast<double>(strobe.period),
                           .tilt = strobe.state.tilt / scales.tilt / share,
                           .tilt_rate = strobe.state.tilt_rate / scales.tilt_rate / share});
  }
  if (!report.history.empty()) add_history(report, file);
  return file;
}

}  // namespace rocking::analysis
