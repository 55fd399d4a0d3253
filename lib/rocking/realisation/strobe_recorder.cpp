#include "rocking/realisation/strobe_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rocking {

using dynamics::ContactState;
using dynamics::EventKind;

StrobeRecorder::StrobeRecorder(const dynamics::Geometry& block, std::int64_t periods)
    : shape_angles_{block.edges[0].shape_angle, block.edges[1].shape_angle}, is_at_wall_(block.open_side != 0.0) {
  periods_.reserve(static_cast<std::size_t>(periods));
}

void StrobeRecorder::event(EventKind kind, double, const dynamics::State& state) {
  ++events_[static_cast<std::size_t>(kind)];
  current_.moved = true;
  switch (kind) {
    case EventKind::impact_stick:
    case EventKind::impact_slip: count_impact(state); break;
    case EventKind::to_rest:
    case EventKind::to_slide: merge_chatter(); break;
    default: break;
  }
  side_ = state.side;
}

void StrobeRecorder::strobe(const dynamics::State& state) {
  const double psi = shape_angles_[state.side < 0.0 ? 1 : 0];
  current_.point = {.tilt = state.tilt / psi, .tilt_rate = state.tilt_rate / psi, .slip_rate = state.slip_rate};
  periods_.push_back(current_);
  current_ = {.point = {}, .impacts = 0, .moved = state.contact != ContactState::rest};
  side_ = state.side;
}

std::size_t StrobeRecorder::unfinished() const {
  if (run_.size() < 2) return 0;
  return periods_.size() - (std::max(run_.front(), forgotten_) - forgotten_);
}

void StrobeRecorder::forget() {
  forgotten_ += periods_.size();
  periods_.clear();
}

void StrobeRecorder::count_impact(const dynamics::State& after) {
  const double rate = std::abs(after.tilt_rate);
  if (rate >= last_rates_[is_at_wall_ ? 0 : 1]) run_.clear();
  last_rates_ = {rate, last_rates_[0]};
  if (after.side == side_ && !is_at_wall_) return;
  if (current_.impacts < std::numeric_limits<std::uint16_t>::max() - 1) current_.impacts += impacts_of_one();
  run_.push_back(forgotten_ + periods_.size());
}

void StrobeRecorder::merge_chatter() {
  for (std::size_t i = 1; i < run_.size(); ++i) {
    if (run_[i] < forgotten_) continue;
    const std::size_t period = run_[i] - forgotten_;
    auto& impacts = period < periods_.size() ? periods_[period].impacts : current_.impacts;
    impacts -= impacts_of_one();
  }
  run_.clear();
  last_rates_ = no_rates;
}

}  // namespace rocking
