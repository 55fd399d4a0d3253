#include "rocking/experiment/exponent.hpp"

#include <cmath>
#include <vector>

#include "rocking/base/elementary.hpp"

namespace rocking::experiment {
namespace {

using HarmonicMotion = Motion<dynamics::HarmonicExcitation>;

constexpr double start_distance = 1e-7;   ///< well above the tolerance, well below the attractor
constexpr double least_distance = 1e-16;  ///< what arithmetic can tell apart
constexpr std::size_t batches = 8;

/// Keeps the last strobe state.
class LastStrobe final : public dynamics::Observer {
 public:
  void event(dynamics::EventKind, double, const dynamics::State&) override {}
  void strobe(const dynamics::State& state) override { state_ = state; }
  [[nodiscard]] const dynamics::State& state() const { return state_; }

 private:
  dynamics::State state_;
};

double length_of(const dynamics::Displacement& d) {
  return std::sqrt(d.tilt * d.tilt + d.tilt_rate * d.tilt_rate + d.slip_rate * d.slip_rate);
}

dynamics::Displacement difference(const dynamics::State& a, const dynamics::State& b, double shape_angle) {
  return {.tilt = (a.tilt - b.tilt) / shape_angle,
          .tilt_rate = (a.tilt_rate - b.tilt_rate) / shape_angle,
          .slip_rate = a.slip_rate - b.slip_rate};
}

section::ExponentEstimate estimate_from(const std::vector<double>& growths) {
  const std::size_t batch = growths.size() / batches;
  double means[batches];
  double mean = 0.0;
  for (std::size_t b = 0; b < batches; ++b) {
    double sum = 0.0;
    for (std::size_t i = b * batch; i < (b + 1) * batch; ++i) sum += growths[i];
    means[b] = sum / static_cast<double>(batch);
    mean += means[b] / static_cast<double>(batches);
  }
  double squares = 0.0;
  for (const double value : means) squares += (value - mean) * (value - mean);
  return {.exponent = mean, .standard_error = std::sqrt(squares / static_cast<double>(batches * (batches - 1)))};
}

}  // namespace

CompanionRun companion_exponent(const HarmonicMotion& from, double shape_angle, std::int64_t periods) {
  CompanionRun run;
  LastStrobe leader_strobe;
  LastStrobe companion_strobe;
  HarmonicMotion leader = from;
  leader.observe_with(leader_strobe);
  std::vector<double> growths;
  growths.reserve(static_cast<std::size_t>(periods));
  dynamics::Displacement direction{.tilt = start_distance, .tilt_rate = 0.0, .slip_rate = 0.0};
  for (std::int64_t period = 0; period < periods; ++period) {
    leader.move_to_last_strobe();
    HarmonicMotion companion = leader;
    companion.observe_with(companion_strobe);
    const double before = length_of(companion.displace(direction));
    leader.extend(1);
    companion.extend(1);
    integrate::advance(leader);
    integrate::advance(companion);
    run.periods += 2;
    const bool both_go_on = leader.termination() == dynamics::Termination::reached_horizon &&
                            companion.termination() == dynamics::Termination::reached_horizon;
    if (!both_go_on) break;
    if (before == 0.0) continue;  // in full contact at rest there is nothing to displace
    dynamics::Displacement apart = difference(companion_strobe.state(), leader_strobe.state(), shape_angle);
    const double after = length_of(apart);
    growths.push_back(base::natural_logarithm(std::fmax(after, least_distance) / before));
    if (after > least_distance) {
      const double scale = start_distance / after;
      direction = {.tilt = apart.tilt * scale, .tilt_rate = apart.tilt_rate * scale,
                   .slip_rate = apart.slip_rate * scale};
    }
  }
  if (growths.size() >= 4 * batches) run.exponent = estimate_from(growths);
  return run;
}

}  // namespace rocking::experiment
