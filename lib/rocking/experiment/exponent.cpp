#include "rocking/experiment/exponent.hpp"

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "rocking/base/elementary.hpp"

namespace rocking::experiment {
namespace {

using HarmonicMotion = Motion<dynamics::HarmonicExcitation>;

constexpr double start_distance = 1e-7;   ///< well above the tolerance, well below the attractor
constexpr double least_distance = 1e-16;  ///< what arithmetic can tell apart
constexpr std::size_t batches = 8;
constexpr std::size_t shortest_batch = 4;  ///< periods
constexpr std::int64_t longest_run = 8;    ///< times the periods asked for

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

/// Mean growth and the standard error of the mean of batches in a row; absent with too few of them.
std::optional<section::ExponentEstimate> estimate_from(const std::vector<double>& growths) {
  const std::size_t batch = growths.size() / batches;
  if (batch < shortest_batch) return std::nullopt;
  std::array<double, batches> means{};
  for (std::size_t b = 0; b < batches; ++b) {
    const auto first = growths.begin() + static_cast<std::ptrdiff_t>(b * batch);
    means[b] = std::accumulate(first, first + static_cast<std::ptrdiff_t>(batch), 0.0) / static_cast<double>(batch);
  }
  const double mean = std::accumulate(means.begin(), means.end(), 0.0) / static_cast<double>(batches);
  double squares = 0.0;
  for (const double value : means) squares += (value - mean) * (value - mean);
  return section::ExponentEstimate{
      .exponent = mean, .standard_error = std::sqrt(squares / static_cast<double>(batches * (batches - 1)))};
}

/// Five standard errors of a mean of eight batches: chance gives that to an exponent of zero once in six hundred looks.
bool is_sure(const std::optional<section::ExponentEstimate>& estimate) {
  return estimate && std::abs(estimate->exponent) >= 5.0 * estimate->standard_error;
}

/// A realisation and its companion, side by side from strobe point to strobe point.
class Companion {
 public:
  Companion(const HarmonicMotion& from, double shape_angle) : leader_(from), shape_angle_(shape_angle) {}

  /// Goes on until `periods` in all are done. False if the run ended before.
  [[nodiscard]] bool run_until(std::int64_t periods) {
    while (done_ < periods) {
      if (!run_period()) return false;
    }
    return true;
  }

  /// ln of the growth of the distance over each period in which there was one.
  [[nodiscard]] const std::vector<double>& growths() const { return growths_; }
  [[nodiscard]] std::uint64_t periods_run() const { return 2 * static_cast<std::uint64_t>(done_); }

 private:
  [[nodiscard]] bool run_period() {
    LastStrobe leader_strobe;
    LastStrobe companion_strobe;
    leader_.observe_with(leader_strobe);
    leader_.move_to_last_strobe();
    HarmonicMotion companion = leader_;
    companion.observe_with(companion_strobe);
    const double before = length_of(companion.displace(direction_));
    leader_.extend(1);
    companion.extend(1);
    integrate::advance(leader_);
    integrate::advance(companion);
    ++done_;
    if (leader_.termination() != dynamics::Termination::reached_horizon) return false;
    if (companion.termination() != dynamics::Termination::reached_horizon) return false;
    if (before == 0.0) return true;  // at rest in full contact there is nothing to displace
    const dynamics::Displacement apart = difference(companion_strobe.state(), leader_strobe.state(), shape_angle_);
    const double after = length_of(apart);
    growths_.push_back(base::natural_logarithm(std::fmax(after, least_distance) / before));
    if (after > least_distance) {
      const double scale = start_distance / after;
      direction_ = {
          .tilt = apart.tilt * scale, .tilt_rate = apart.tilt_rate * scale, .slip_rate = apart.slip_rate * scale};
    }
    return true;
  }

  HarmonicMotion leader_;
  double shape_angle_;
  dynamics::Displacement direction_{.tilt = start_distance, .tilt_rate = 0.0, .slip_rate = 0.0};
  std::vector<double> growths_;
  std::int64_t done_ = 0;
};

}  // namespace

CompanionRun companion_exponent(const HarmonicMotion& from, double shape_angle, std::int64_t periods) {
  Companion companion(from, shape_angle);
  CompanionRun run;
  std::int64_t goal = periods;
  while (companion.run_until(goal)) {
    run.exponent = estimate_from(companion.growths());
    if (is_sure(run.exponent) || goal >= longest_run * periods) break;
    goal *= 2;
  }
  run.periods = companion.periods_run();
  return run;
}

}  // namespace rocking::experiment
