#include "rocking/experiment/exponent.hpp"

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "rocking/base/elementary.hpp"

namespace rocking::experiment {
namespace {

constexpr double start_distance = 1e-7;   ///< well above the tolerance, well below the attractor
constexpr double least_distance = 1e-16;  ///< what arithmetic can tell apart
constexpr std::size_t batches = 8;
constexpr std::size_t shortest_batch = 4;  ///< periods
constexpr std::int64_t longest_run = 8;    ///< times the periods asked for

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
  return section::ExponentEstimate{.exponent = mean,
                                   .standard_error = std::sqrt(squares / static_cast<double>(batches * (batches - 1)))};
}

/// Five standard errors of a mean of eight batches: chance gives that to an exponent of zero once in six hundred looks.
bool is_sure(const std::optional<section::ExponentEstimate>& estimate) {
  return estimate && std::abs(estimate->exponent) >= 5.0 * estimate->standard_error;
}

}  // namespace

CompanionPair::CompanionPair(const Motion& from, double shape_angle, std::int64_t periods)
    : leader_(from),
      companion_(from),
      shape_angle_(shape_angle),
      longest_(longest_run * periods),
      goal_(periods),
      direction_{.tilt = start_distance, .tilt_rate = 0.0, .slip_rate = 0.0} {
  leader_.observe_with(leader_strobe_);
  begin_period();
}

void CompanionPair::begin_period() {
  leader_.move_to_last_strobe();
  companion_ = leader_;
  companion_.observe_with(companion_strobe_);
  distance_ = length_of(companion_.displace(direction_));
  leader_.extend(1);
  companion_.extend(1);
}

bool CompanionPair::go_on() {
  ++done_;
  if (leader_.termination() != dynamics::Termination::reached_horizon) return false;
  if (companion_.termination() != dynamics::Termination::reached_horizon) return false;
  if (distance_ > 0.0) measure_growth();  // at rest in full contact there is nothing to displace
  if (done_ == goal_) {
    exponent_ = estimate_from(growths_);
    if (is_sure(exponent_) || goal_ >= longest_) return false;
    goal_ *= 2;
  }
  begin_period();
  return true;
}

void CompanionPair::measure_growth() {
  const dynamics::Displacement apart = difference(companion_strobe_.state(), leader_strobe_.state(), shape_angle_);
  const double after = length_of(apart);
  growths_.push_back(base::natural_logarithm(std::fmax(after, least_distance) / distance_));
  if (after <= least_distance) return;
  const double scale = start_distance / after;
  direction_ = {.tilt = apart.tilt * scale, .tilt_rate = apart.tilt_rate * scale, .slip_rate = apart.slip_rate * scale};
}

CompanionRun CompanionPair::result() const {
  return {.exponent = exponent_, .periods = 2 * static_cast<std::uint64_t>(done_)};
}

void run_alone(CompanionPair& pair, base::StopRequest stop) {
  do {
    stop.check();
    integrate::advance(pair.leader());
    integrate::advance(pair.companion());
  } while (pair.go_on());
}

}  // namespace rocking::experiment
