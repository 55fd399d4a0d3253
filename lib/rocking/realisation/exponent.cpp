#include "rocking/realisation/exponent.hpp"

#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "rocking/base/elementary.hpp"

namespace rocking {
namespace {

constexpr double start_distance = 1e-7;   ///< far above the tolerance, far below the size of the attractor
constexpr double least_distance = 1e-16;  ///< smallest distance that the arithmetic resolves
constexpr std::size_t batches = 8;
constexpr std::size_t shortest_batch = 4;  ///< periods
constexpr std::int64_t longest_run = 8;    ///< in units of the periods requested

double length_of(const dynamics::Displacement& d) {
  return std::sqrt(d.tilt * d.tilt + d.tilt_rate * d.tilt_rate + d.slip_rate * d.slip_rate);
}

dynamics::Displacement difference(const dynamics::State& a, const dynamics::State& b, double shape_angle) {
  return {.tilt = (a.tilt - b.tilt) / shape_angle,
          .tilt_rate = (a.tilt_rate - b.tilt_rate) / shape_angle,
          .slip_rate = a.slip_rate - b.slip_rate};
}

/// Mean growth and its standard error from means of successive batches; absent if there are too few periods.
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

/// Five standard errors of a mean of eight batches: an exponent of zero exceeds this by chance once in 600 tests.
bool is_sure(const std::optional<section::ExponentEstimate>& estimate) {
  return estimate && std::abs(estimate->exponent) >= 5.0 * estimate->standard_error;
}

}  // namespace

PerturbedPair::PerturbedPair(const Motion& from, double shape_angle, std::int64_t periods)
    : reference_(from),
      perturbed_(from),
      shape_angle_(shape_angle),
      longest_(longest_run * periods),
      goal_(periods),
      direction_{.tilt = start_distance, .tilt_rate = 0.0, .slip_rate = 0.0} {
  reference_.observe_with(reference_strobe_);
  reference_.ignore_peaks();  // so are those of its copy, the perturbed trajectory
  begin_period();
}

void PerturbedPair::begin_period() {
  reference_.move_to_last_strobe();
  perturbed_ = reference_;
  perturbed_.observe_with(perturbed_strobe_);
  distance_ = length_of(perturbed_.displace(direction_));
  reference_.extend(1);
  perturbed_.extend(1);
}

bool PerturbedPair::go_on() {
  ++done_;
  if (reference_.termination() != dynamics::Termination::reached_horizon) return false;
  if (perturbed_.termination() != dynamics::Termination::reached_horizon) return false;
  if (distance_ > 0.0) measure_growth();  // at rest in full contact there is nothing to perturb
  if (done_ == goal_) {
    exponent_ = estimate_from(growths_);
    if (is_sure(exponent_) || goal_ >= longest_) return false;
    goal_ *= 2;
  }
  begin_period();
  return true;
}

void PerturbedPair::measure_growth() {
  const dynamics::Displacement apart = difference(perturbed_strobe_.state(), reference_strobe_.state(), shape_angle_);
  const double after = length_of(apart);
  growths_.push_back(base::natural_logarithm(std::fmax(after, least_distance) / distance_));
  if (after <= least_distance) return;
  const double scale = start_distance / after;
  direction_ = {.tilt = apart.tilt * scale, .tilt_rate = apart.tilt_rate * scale, .slip_rate = apart.slip_rate * scale};
}

ExponentRun PerturbedPair::result() const {
  return {.exponent = exponent_,
          .periods = 2 * static_cast<std::uint64_t>(done_),
          .stayed_unclear = done_ >= longest_ && !is_sure(exponent_)};
}

void run_alone(PerturbedPair& pair, base::StopRequest stop) {
  do {
    stop.check();
    integrate::advance(pair.reference());
    integrate::advance(pair.perturbed());
  } while (pair.go_on());
}

}  // namespace rocking
