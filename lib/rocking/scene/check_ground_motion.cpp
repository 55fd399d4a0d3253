#include "rocking/scene/check_ground_motion.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "rocking/base/number_text.hpp"
#include "rocking/scene/rules.hpp"

namespace rocking {
namespace {

using Samples = std::vector<dynamics::GroundMotionSample>;

struct BadSample {
  double value;
  Refusal refusal;
};

std::optional<BadSample> refuse_sample(const Samples& samples, std::size_t index, double gravity) {
  const dynamics::GroundMotionSample& sample = samples[index];
  if (auto refusal = refuse_sample_time(sample.time)) return BadSample{sample.time, *std::move(refusal)};
  if (index > 0 && sample.time < samples[index - 1].time) {
    return BadSample{sample.time, sample_falls_back(base::shortest(samples[index - 1].time))};
  }
  for (const double acceleration : {sample.horizontal, sample.vertical}) {
    auto refusal = refuse_acceleration(acceleration, gravity);
    if (refusal) return BadSample{acceleration, *std::move(refusal)};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Refusal> refuse_sample_time(double time) {
  if (0.0 <= time && time <= rules::latest_sample) return std::nullopt;
  return Refusal{"is not a time from 0 to 1e7 s", "let the ground motion begin at 0 s"};
}

Refusal sample_falls_back(std::string_view previous) {
  return {"is earlier than the time of the previous sample, " + std::string(previous),
          "put the samples in the order of their times"};
}

std::optional<Refusal> refuse_acceleration(double acceleration, double unit) {
  if (std::abs(acceleration) <= rules::largest_acceleration / unit) return std::nullopt;
  return Refusal{"exceeds 1e6 m/s^2 in absolute value", "give accelerations in m/s^2"};
}

std::optional<Refusal> refuse_samples(const Samples& samples) {
  if (samples.empty()) return Refusal{"contains no sample", "give one line for each sample"};
  if (samples.size() == 1) {
    return Refusal{"contains only one sample", "give at least two: the motion is linear between samples"};
  }
  if (samples.size() > rules::most_samples) {
    return Refusal{"contains more than 1000000 samples", "give a shorter or coarser ground motion"};
  }
  if (!(samples.back().time > samples.front().time)) {
    return Refusal{"has a duration of zero", "give samples at different times"};
  }
  return std::nullopt;
}

void check_ground_motion(const Samples& samples, double gravity, Problems& problems) {
  for (std::size_t i = 0; i < samples.size() && i <= rules::most_samples; ++i) {
    auto bad = refuse_sample(samples, i, gravity);
    if (!bad) continue;
    problems.push_back({"/excitation/file", base::shortest(bad->value),
                        bad->refusal.reason + " (sample " + std::to_string(i + 1) + ')',
                        std::move(bad->refusal.remedy)});
    return;
  }
  auto refusal = refuse_samples(samples);
  if (refusal) problems.push_back({"/excitation/file", "", std::move(refusal->reason), std::move(refusal->remedy)});
}

}  // namespace rocking
