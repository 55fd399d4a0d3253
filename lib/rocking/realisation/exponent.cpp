#include "rocking/realisation/exponent.hpp"

#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "rocking/base/elementary.hpp"

namespace rocking {
namespace {

constexpr double least_growth = 1e-9;  ///< in a period; also where the motion loses its memory of the state
constexpr double largest_size = 0x1p64;
constexpr std::size_t batches = 8;
constexpr std::size_t shortest_batch = 4;  ///< periods
constexpr std::int64_t longest_run = 8;    ///< in units of the periods of the window

/// Changes of Theta, Theta' and V by 1.
TangentRun::Motion::Tangents unit_vectors(double shape_angle) {
  return {{{.tilt = shape_angle}, {.tilt_rate = shape_angle}, {.slip_rate = 1.0}}};
}

double norm_of(const TangentRun::Motion::Tangents& vectors, double shape_angle) {
  double squares = 0.0;
  for (const auto& vector : vectors) {
    const double tilt = vector.tilt / shape_angle;
    const double rate = vector.tilt_rate / shape_angle;
    squares += tilt * tilt + rate * rate + vector.slip_rate * vector.slip_rate;
  }
  return std::sqrt(squares);
}

/// Norm of the unit vectors, as far as they keep the contact state.
double unit_norm(const dynamics::State& state, double shape_angle) {
  auto vectors = unit_vectors(shape_angle);
  for (auto& vector : vectors) vector = within_contact(vector, state);
  return norm_of(vectors, shape_angle);
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

}  // namespace

TangentRun::TangentRun(const rocking::Motion& from, double shape_angle, std::int64_t periods,
                       dynamics::Observer* recorder)
    : shape_angle_(shape_angle),
      window_(periods),
      goal_(periods),
      size_(unit_norm(from.state(), shape_angle)),
      recorder_(recorder),
      motion_(from, unit_vectors(shape_angle)) {
  motion_.observe_with(*this);
  if (recorder == nullptr) end_recording();
  motion_.extend(periods);
}

void TangentRun::end_recording() {
  recorder_ = nullptr;
  motion_.ignore_peaks();
}

void TangentRun::strobe(const dynamics::State& state) {
  if (recorder_ != nullptr) recorder_->strobe(state);
  points_.push_back(
      {.tilt = state.tilt / shape_angle_, .tilt_rate = state.tilt_rate / shape_angle_, .slip_rate = state.slip_rate});
  const double size = norm_of(motion_.at_strobe(), shape_angle_);
  const bool is_measured = size_ > 0.0 && std::isfinite(size);
  if (is_measured) growths_.push_back(base::natural_logarithm(std::fmax(size / size_, least_growth)));
  size_ = size;
  if (size == 0.0 || !std::isfinite(size)) {
    motion_.restart(unit_vectors(shape_angle_));
    size_ = unit_norm(state, shape_angle_);
  } else if (size > largest_size || size < 1.0 / largest_size) {
    const double scale = std::ldexp(1.0, -std::ilogb(size));
    motion_.scale(scale);
    size_ = size * scale;
  }
}

bool TangentRun::go_on(const section::PendingClassification& pending) {
  if (motion_.termination() != dynamics::Termination::reached_horizon) return false;
  over_all_ = estimate_from(growths_);
  if (is_undecided_) {
    exponent_ = over_all_;
    is_undecided_ = !exponent_ || pending.may_be_decided_later(*exponent_);
  }
  const auto wants_points = [&] {
    return pending.may_be_quasi_periodic && pending.may_be_quasi_periodic({.points = points_, .exponent = over_all_});
  };
  if (goal_ >= longest_run * window_ || !(is_undecided_ || wants_points())) return false;
  motion_.extend(goal_);
  goal_ *= 2;
  return true;
}

ExponentRun TangentRun::result() {
  return {.exponent = exponent_,
          .over_all = over_all_,
          .points = std::move(points_),
          .stayed_unclear = goal_ >= longest_run * window_ && is_undecided_};
}

void run_alone(TangentRun& run, const section::PendingClassification& pending, base::StopRequest stop) {
  integrate::LoopCounts counts;  // not reported
  do {
    while (!run.motion().ended()) {
      stop.check();
      integrate::step(run.motion(), counts);
    }
  } while (run.go_on(pending));
}

}  // namespace rocking
