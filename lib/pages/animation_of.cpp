#include "pages/animation_of.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "rocking/dynamics/block.hpp"
#include "rocking/realisation/trajectory.hpp"

namespace rocking::pages {
namespace {

constexpr int smooth_samples = 48;            ///< samples per excitation period that look smooth
constexpr int most_samples_per_period = 400;  ///< where a period only counts time

int samples_per_period(bool periodic, const AnimationExtent& extent) {
  if (extent.samples_per_period) return *extent.samples_per_period;
  if (periodic) return smooth_samples;
  const auto affordable = static_cast<std::int64_t>(extent.most_samples) / extent.periods;
  return static_cast<int>(std::clamp<std::int64_t>(affordable, 1, most_samples_per_period));
}

/// The samples, and the end of an overturning. Times in seconds: tau/p.
std::vector<analysis::MotionSample> samples_of(const Trajectory& trajectory, double frequency_parameter) {
  std::vector<analysis::MotionSample> samples;
  for (const HistorySample& sample : trajectory.history) {
    samples.push_back({.time = sample.tau / frequency_parameter,
                       .tilt = sample.tilt,
                       .tilt_rate = sample.tilt_rate,
                       .slip = sample.slip,
                       .base_acceleration = sample.base_acceleration,
                       .contact = std::string(to_string(sample.contact))});
  }
  if (samples.empty() || trajectory.events.empty()) return samples;
  const TrajectoryEvent& last = trajectory.events.back();
  if (last.kind == dynamics::EventKind::overturn && last.tau / frequency_parameter > samples.back().time) {
    samples.push_back({.time = last.tau / frequency_parameter,
                       .tilt = last.tilt,
                       .tilt_rate = last.tilt_rate,
                       .slip = last.slip,
                       .base_acceleration = samples.back().base_acceleration,
                       .contact = std::string(to_string(dynamics::ContactState::overturned))});
  }
  return samples;
}

/// Drops the end of a motion where block and base are at rest, but for a twentieth of the rest.
void cut_rest(std::vector<analysis::MotionSample>& samples) {
  const auto moves = [](const analysis::MotionSample& sample) {
    return sample.contact != "rest" || sample.base_acceleration != 0.0;
  };
  const auto last = std::find_if(samples.rbegin(), samples.rend(), moves);
  const auto kept = static_cast<std::size_t>(samples.rend() - last);
  samples.resize(std::min(samples.size(), std::max<std::size_t>(kept + samples.size() / 20, 2)));
}

void keep_last(std::size_t number, std::vector<analysis::MotionSample>& samples) {
  if (samples.size() > number) samples.erase(samples.begin(), samples.end() - static_cast<std::ptrdiff_t>(number));
}

}  // namespace

std::int64_t shown_periods(const section::ResponseMode& mode) {
  constexpr std::int64_t usual = 12;
  return std::max<std::int64_t>(usual, 3 * std::int64_t{mode.periods});
}

std::optional<analysis::Animation> animation_of(const Experiment& experiment, const RealisationKey& key,
                                                const AnimationExtent& extent) {
  const Condition& condition = experiment.conditions.at(key.condition);
  const bool periodic = is_periodic(condition.scene.excitation);
  const int samples = samples_per_period(periodic, extent);
  const Trajectory trajectory = trajectory_of(condition, experiment.seed, key.realisation,
                                              TrajectoryExtent(extent.periods, samples, extent.stop));
  if (trajectory.history.size() < 2) return std::nullopt;
  const dynamics::Geometry geometry = dynamics::geometry_of(trajectory.block);
  const double p = geometry.frequency_parameter;
  const double period = trajectory.history[1].tau * samples / p;
  analysis::Animation motion{.name = "realisation " + std::to_string(key.realisation),
                             .command = "rocking trajectory EXPERIMENT.json --condition " +
                                        std::to_string(key.condition) + " --realisation " +
                                        std::to_string(key.realisation) + " --samples " + std::to_string(samples),
                             .block = trajectory.outline,
                             .shape_angles = {geometry.edges[0].shape_angle, geometry.edges[1].shape_angle},
                             .half_diagonal = geometry.half_diagonal,
                             .period = periodic ? period : 0.0,
                             .length = 0.0,
                             .samples = samples_of(trajectory, p)};
  motion.length = motion.samples.back().time;
  if (periodic) {
    keep_last(static_cast<std::size_t>(extent.shown_periods) * static_cast<std::size_t>(samples) + 1, motion.samples);
  } else {
    cut_rest(motion.samples);
  }
  keep_last(extent.most_samples + 1, motion.samples);
  return motion;
}

}  // namespace rocking::pages
