#include "rocking/realisation/exponent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "rocking/base/elementary.hpp"

namespace rocking {
namespace {

constexpr double least_growth = 1e-9;  ///< in a period; also where the motion loses its memory of the state
constexpr double largest_size = 0x1p64;
constexpr std::size_t batches = 8;
constexpr std::size_t most_batches = 32;   ///< of several runs
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
std::optional<section::ExponentEstimate> estimate_from(const std::vector<double>& growths,
                                                       std::size_t count = batches) {
  const std::size_t batch = growths.size() / count;
  if (batch < shortest_batch) return std::nullopt;
  std::array<double, most_batches> values{};
  const std::span<double> means = std::span(values).first(count);
  for (std::size_t b = 0; b < count; ++b) {
    const auto first = growths.begin() + static_cast<std::ptrdiff_t>(b * batch);
    means[b] = std::accumulate(first, first + static_cast<std::ptrdiff_t>(batch), 0.0) / static_cast<double>(batch);
  }
  const double mean = std::accumulate(means.begin(), means.end(), 0.0) / static_cast<double>(count);
  double squares = 0.0;
  for (const double value : means) squares += (value - mean) * (value - mean);
  return section::ExponentEstimate{.exponent = mean,
                                   .standard_error = std::sqrt(squares / static_cast<double>(count * (count - 1)))};
}

/// Whether two exponents differ by more than chance.
bool differ(const section::ExponentEstimate& a, const section::ExponentEstimate& b) {
  const double error = std::sqrt(a.standard_error * a.standard_error + b.standard_error * b.standard_error);
  return std::abs(a.exponent - b.exponent) > 3.0 * error;
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
    return pending.wants_more_points && pending.wants_more_points({.points = points_, .exponent = over_all_});
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
          .growths = std::move(growths_),
          .stayed_unclear = goal_ >= longest_run * window_ && is_undecided_,
          .has_ended = motion_.termination() != dynamics::Termination::reached_horizon};
}

void ExponentRecord::add(std::int64_t begin, const ExponentRun& run) {
  const auto before = estimate();
  const bool is_another = before && run.over_all && differ(*before, *run.over_all);
  if (is_another) growths_.clear();
  const auto known = static_cast<std::size_t>(is_another ? 0 : std::max<std::int64_t>(covered_ - begin, 0));
  if (known < run.growths.size()) {
    growths_.insert(growths_.end(), run.growths.begin() + static_cast<std::ptrdiff_t>(known), run.growths.end());
  }
  covered_ = std::max(covered_, begin + static_cast<std::int64_t>(run.points.size()));
  ++looks_;
}

std::optional<section::ExponentEstimate> ExponentRecord::estimate() const {
  // As many batches as a run has, and more where they are no shorter than those of several runs.
  const std::size_t count = std::clamp(batches * static_cast<std::size_t>(looks_), batches, most_batches);
  auto all = estimate_from(growths_, count);
  if (all && looks_ > 1) {
    all->periods = static_cast<std::int64_t>(growths_.size());
    all->looks = looks_;
  }
  return all;
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
