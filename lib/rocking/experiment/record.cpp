#include "rocking/experiment/record.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "rocking/experiment/exponent.hpp"
#include "rocking/experiment/realisation.hpp"
#include "rocking/experiment/strobe_recorder.hpp"
#include "rocking/section/classify.hpp"

namespace rocking::experiment {
namespace {

void add(Effort& effort, const integrate::LoopCounts& counts) {
  effort.steps += counts.steps;
  effort.root_isolations += counts.root_isolations;
}

/// A strobe point is about as accurate as the step times a few hundred of them; better than 1e-9 is never needed.
double resolution_of(double tolerance) { return std::max(1e-9, 1e3 * tolerance); }

}  // namespace

Record realise(const Condition& condition, std::uint64_t seed, std::uint64_t realisation) {
  const random::Draws draws(seed, realisation);
  const Start start = start_of(condition.scene, draws);
  const double shape_angle = dynamics::geometry_of(condition.scene.block).shape_angle;
  const std::int64_t transient = condition.horizon.transient_periods;
  const std::int64_t sampled = condition.horizon.sampled_periods;
  Record record;
  record.effort.initial_draws = start.draws;

  StrobeRecorder recorder(shape_angle, transient + sampled);
  const std::int64_t before_copy = std::max<std::int64_t>(transient, 1);
  Motion motion = begin_realisation(condition, draws, start, Strobe::poincare, before_copy, recorder);
  add(record.effort, integrate::advance(motion));
  const Motion after_transient = motion;
  if (transient + sampled > before_copy) {
    motion.extend(transient + sampled - before_copy);
    add(record.effort, integrate::advance(motion));
  }

  record.termination = motion.termination().value_or(dynamics::Termination::stopped);
  record.losses_of_contact = motion.losses_of_contact();
  record.first_loss_of_contact = motion.first_loss_of_contact();
  record.was_past_balance = motion.was_past_balance();
  record.effort.slip_steps = motion.slip_steps();
  record.effort.events = recorder.events();
  motion.coefficients().add_to(record.effort);
  record.clamps = motion.coefficients().clamps();
  const auto& periods = recorder.periods();
  record.strobe.reserve(periods.size());
  for (const section::Period& period : periods) record.strobe.push_back(period.point);

  if (record.termination == dynamics::Termination::overturned) {
    record.verdict.mode = {.kind = section::ResponseKind::overturned};
  } else if (record.termination == dynamics::Termination::reached_horizon) {
    const auto exponent = [&]() -> std::optional<section::ExponentEstimate> {
      const CompanionRun run = companion_exponent(after_transient, shape_angle, sampled);
      record.effort.companion_periods += run.periods;
      return run.exponent;
    };
    record.verdict = section::classify({.periods = std::span(periods).last(static_cast<std::size_t>(sampled)),
                                        .random = is_random(condition.scene),
                                        .resolution = resolution_of(condition.tolerance)},
                                       exponent);
  }
  return record;
}

base::Sha256 digest_of(const Record& record, std::uint64_t realisation) {
  base::Sha256Builder builder;
  builder.add(realisation);
  builder.add(to_string(record.termination));
  builder.add(to_string(record.verdict.mode));
  for (const section::StrobePoint& point : record.strobe) {
    builder.add(point.tilt);
    builder.add(point.tilt_rate);
    builder.add(point.slip_rate);
  }
  for (const std::uint64_t count : record.effort.events) builder.add(count);
  return builder.finish();
}

std::optional<std::int64_t> parting_period(const Record& a, const Record& b) {
  constexpr double apart = 0.01;
  const std::size_t common = std::min(a.strobe.size(), b.strobe.size());
  for (std::size_t k = 0; k < common; ++k) {
    const double tilt = a.strobe[k].tilt - b.strobe[k].tilt;
    const double rate = a.strobe[k].tilt_rate - b.strobe[k].tilt_rate;
    if (tilt * tilt + rate * rate > apart * apart) return static_cast<std::int64_t>(k) + 1;
  }
  if (a.strobe.size() != b.strobe.size()) return static_cast<std::int64_t>(common) + 1;
  return std::nullopt;
}

}  // namespace rocking::experiment
