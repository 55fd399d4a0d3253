#include "benchmarks/follow.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "benchmarks/odeint_block.hpp"
#include "rocking/lanes/lane_scheduler.hpp"
#include "rocking/realisation/start.hpp"
#include "support/excitation.hpp"

namespace rocking::benchmarks {

using differential::Question;

namespace {

/// Keeps the last strobe point.
class LastStrobe final : public dynamics::Observer {
 public:
  void event(dynamics::EventKind, double, const dynamics::State&) override {}
  void strobe(const dynamics::State& state) override { last_ = state; }
  [[nodiscard]] const dynamics::State& last() const { return last_; }

 private:
  dynamics::State last_;
};

/// Distance of end states; infinite if one of the two did not reach the horizon.
double distance(const EndState& a, const EndState& b) {
  if (!a.reached || !b.reached) return HUGE_VAL;
  return std::max(
      {std::abs(a.tilt - b.tilt), std::abs(a.tilt_rate - b.tilt_rate), std::abs(a.slip_rate - b.slip_rate)});
}

Calibration errors_at(const Case& c, const Follow& follow, double tolerance) {
  std::vector<double> errors;
  for (int start = 0; start < starts; ++start) {
    const Question question = question_of(c, start);
    errors.push_back(distance(follow(question, tolerance), follow_by_ours(question, 1e-15)));
  }
  std::sort(errors.begin(), errors.end());
  return {tolerance, errors[starts / 2], errors.back()};
}

/// A realisation in the lane scheduler.
class LaneRun {
 public:
  explicit LaneRun(const Question& question)
      : motion_(motion_of(question.condition.scene, beginning_of(question), observer_)) {}
  LaneRun(const LaneRun&) = delete;
  LaneRun& operator=(const LaneRun&) = delete;

  [[nodiscard]] auto& motion() { return motion_; }
  [[nodiscard]] integrate::LoopCounts& counts() { return counts_; }
  [[nodiscard]] static bool go_on() { return false; }
  [[nodiscard]] bool reached_horizon() const { return motion_.termination() == dynamics::Termination::reached_horizon; }

 private:
  static Beginning beginning_of(const Question& question) {
    const Condition& condition = question.condition;
    const random::Draws draws(question.seed, question.realisation);
    return begin_realisation(condition, draws, start_of(condition.scene, draws), Strobe::poincare, question.periods);
  }

  LastStrobe observer_;
  Motion motion_;
  integrate::LoopCounts counts_;
};

}  // namespace

Question question_of(const Case& c, int start) {
  Question question{
      .condition = {}, .seed = 0x2012, .realisation = static_cast<std::uint64_t>(start), .periods = periods};
  Scene& scene = question.condition.scene;
  support::harmonic(scene).amplitude = c.amplitude;
  support::harmonic(scene).frequency_ratio = 10.0;
  if (c.slides) scene.friction = Friction{.static_coefficient = 0.40, .kinetic_coefficient = 0.35};
  scene.fluctuation.static_friction = scene.fluctuation.kinetic_friction = c.sigma;
  scene.initial.tilt = 0.05 + 0.02 * start;
  return question;
}

EndState follow_by_ours(const Question& question, double tolerance) {
  Condition condition = question.condition;
  condition.tolerance = tolerance;
  const random::Draws draws(question.seed, question.realisation);
  LastStrobe observer;
  const Start start = start_of(condition.scene, draws);
  const auto beginning = begin_realisation(condition, draws, start, Strobe::poincare, question.periods);
  Motion motion = motion_of(condition.scene, beginning, observer);
  integrate::advance(motion);
  const double psi = beginning.setting.block.shape_angle;
  const dynamics::State& last = observer.last();
  return {last.tilt / psi, last.tilt_rate / psi, last.slip_rate,
          motion.termination() == dynamics::Termination::reached_horizon};
}

class SideBySide::Implementation {
 public:
  Implementation(const Case& c, double tolerance, const lanes::Kernels& kernels)
      : case_(c), tolerance_(tolerance), scheduler_(kernels), runs_(scheduler_.wanted_size()) {
    for (auto& run : runs_) begin(run);
  }

  int finish(int count) {
    int reached = 0;
    for (int finished = 0; finished < count;) {
      scheduler_.step();
      while (const LaneRun* ended = scheduler_.take_finished()) {
        reached += ended->reached_horizon() ? 1 : 0;
        ++finished;
        begin(*std::ranges::find_if(runs_, [ended](const auto& run) { return &*run == ended; }));
      }
    }
    return reached;
  }

 private:
  void begin(std::optional<LaneRun>& run) {
    Question question = question_of(case_, begun_ % starts);
    question.realisation = static_cast<std::uint64_t>(begun_++);
    question.condition.tolerance = tolerance_;
    scheduler_.add(run.emplace(question));
  }

  Case case_;
  double tolerance_;
  lanes::LaneScheduler<LaneRun> scheduler_;
  std::vector<std::optional<LaneRun>> runs_;
  int begun_ = 0;
};

SideBySide::SideBySide(const Case& c, double tolerance, const lanes::Kernels& kernels)
    : implementation_(std::make_unique<Implementation>(c, tolerance, kernels)) {}
SideBySide::~SideBySide() = default;
int SideBySide::finish(int count) { return implementation_->finish(count); }

EndState follow_by_odeint(const Question& question, double tolerance) {
  const auto last = follow_by_odeint(differential::peer_scene(question), question.periods, tolerance);
  return last ? EndState{last->tilt, last->tilt_rate, last->slip_rate, true} : EndState{};
}

Calibration calibrate(const Case& c, const Follow& follow, double wanted) {
  constexpr int first = 28;
  constexpr int last = 58;
  Calibration best{.tolerance = 0.0, .median = HUGE_VAL, .largest = HUGE_VAL};
  for (int rung = first; rung <= last && best.median > wanted; ++rung) {  // four tolerances a decade, from 1e-7
    const Calibration found = errors_at(c, follow, std::pow(10.0, -0.25 * rung));
    if (found.median < best.median) best = found;
  }
  return best;
}

}  // namespace rocking::benchmarks
