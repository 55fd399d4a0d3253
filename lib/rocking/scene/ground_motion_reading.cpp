#include "rocking/scene/ground_motion_reading.hpp"

#include <algorithm>
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

std::string record_units_in_words() {
  std::string words;
  for (const std::string_view name : record_unit_names) {
    if (!words.empty()) words += name == record_unit_names.back() ? " or " : ", ";
    words += name;
  }
  return words;
}

std::optional<Refusal> refuse_columns(const std::vector<RecordColumn>& columns, bool has_time_step) {
  const auto count = [&columns](RecordColumn column) { return std::ranges::count(columns, column); };
  if (count(RecordColumn::horizontal) != 1) {
    return Refusal{"must name the horizontal component once", R"(give, for example, ["time", "horizontal"])"};
  }
  if (count(RecordColumn::vertical) > 1 || count(RecordColumn::time) > 1) {
    return Refusal{"names a column twice", R"(call the columns that are not to be used "other")"};
  }
  const bool has_times = count(RecordColumn::time) == 1;
  if (has_times == has_time_step) {
    return has_times
               ? Refusal{"has a column of times beside a time step",
                         R"(omit the time step, or call the column "other" to use the time step)"}
               : Refusal{"has no column of times, and there is no time step", R"(name "time", or give the time step)"};
  }
  return std::nullopt;
}

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
  return Refusal{
      "exceeds 1e6 m/s^2 in absolute value",
      "check \"units\", m/s^2 without it; if it marks a missing sample, fill the gap, or cut the record before it"};
}

std::optional<Refusal> refuse_samples(const Samples& samples) {
  if (samples.empty()) return Refusal{"contains no sample", "give one line of numbers, without text, for each sample"};
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
