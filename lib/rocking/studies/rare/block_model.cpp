#include "rocking/studies/rare/block_model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rocking/dynamics/edge_angle.hpp"
#include "rocking/integrate/hybrid.hpp"
#include "rocking/scene/drawn_quantities.hpp"
#include "rocking/studies/rare/splitting.hpp"

namespace rocking::rare {
namespace {

using random::DrawHistory;
using random::Source;

/// Whether draw 0 of a source is a uniform number. The coefficients along the way are functions of normal ones.
bool is_uniform(const Scene& scene, Source source) {
  bool uniform = false;
  for_each_quantity(scene, [&](const QuantityPlace& what, const Quantity& quantity) {
    if (what.source == source) uniform = is_drawn(quantity) && drawn_from(quantity) == BasicDraw::uniform;
  });
  return uniform;
}

double first_draw(const Scene& scene, Source source, const random::Draws& draws) {
  return is_uniform(scene, source) ? draws.uniform(source, 0) : draws.standard_normal(source, 0);
}

/// Reflected into [0, 1): a symmetric step stays symmetric.
double reflected(double number) {
  if (number < 0.0) number = -number;
  if (number >= 1.0) number = 2.0 - number;
  return std::min(number, 1.0 - 0x1p-53);
}

/// A step of size s in (0, 1], for which the law of the number is invariant and reversible. s = 1: an independent
/// number.
double moved(const Scene& scene, Source source, double number, double s, const random::Draws& draws) {
  if (is_uniform(scene, source)) return reflected(number + s * (2.0 * draws.uniform(source, 0) - 1.0));
  return std::sqrt(1.0 - s * s) * number + s * draws.standard_normal(source, 0);
}

/// Step sizes 1, 1/2, ..., 2^-7, each as likely as another: no size has to be tuned, and far steps remain possible.
double step_size(const random::Draws& draws) {
  double size = 1.0;
  for (std::uint64_t k = draws.bits(Source::rare_choice, 0) % 8; k > 0; --k) size *= 0.5;
  return size;
}

}  // namespace

Moves moves_of(const Scene& scene) {
  Moves moves;
  for_each_quantity(scene, [&moves](const QuantityPlace& what, const Quantity& quantity) {
    if (is_drawn(quantity)) moves.once.push_back(what.source);
  });
  const Fluctuation& f = scene.fluctuation;
  const bool amplitude_once = amplitude_draws(scene.excitation) == AmplitudeDraws::once;
  if (f.amplitude > 0.0 && amplitude_once) moves.once.push_back(Source::amplitude);
  const bool often = f.kinetic_friction > 0.0 || f.restitution > 0.0 || (f.amplitude > 0.0 && !amplitude_once);
  moves.along_the_way = often || f.static_friction > 0.0;
  // A block that never comes to a stop has the static friction of its start only.
  if (f.static_friction > 0.0 && !often) moves.once.push_back(Source::static_friction);
  return moves;
}

BlockModel::BlockModel(const Condition& condition, const Settings& settings, Halt halt)
    : condition_(&condition), settings_(settings), halt_(std::move(halt)), moves_(moves_of(condition.scene)) {}

BlockModel::Particle BlockModel::start(const Stream& stream, double target) const {
  const std::uint64_t number = number_of(stream);
  const random::Draws draws(settings_.seed, number);
  auto history = std::make_shared<DrawHistory>();
  for (const Source source : moves_.once) {
    history->given.push_back({source, first_draw(condition_->scene, source, draws)});
  }
  Particle particle = begin(std::move(history), number);
  advance(particle, target);
  return particle;
}

BlockModel::Particle BlockModel::go_on(const Particle& parent, const Stream& stream, double level,
                                       double target) const {
  Particle particle = parent;
  double work = 0.0;
  for (int step = 0; step < settings_.chain_steps; ++step) {
    Stream of_step = stream;
    of_step.move = static_cast<std::uint64_t>(step) + 1;
    Particle candidate = begin(proposal(particle, of_step), particle.number);
    advance(candidate, level);
    work += candidate.work;
    if (candidate.score >= level) particle = std::move(candidate);
  }
  particle.work = work;
  if (moves_.along_the_way) branch(particle, number_of(stream));
  advance(particle, target);
  return particle;
}

BlockModel::Particle BlockModel::replay(const Particle& particle) const {
  Particle again = begin(particle.history, particle.number);
  const bool to_end = particle.motion->ended();
  advance(again, to_end ? event_score : particle.score);
  return again;
}

BlockModel::Particle BlockModel::begin(std::shared_ptr<const DrawHistory> history, std::uint64_t number) const {
  Particle particle{.history = std::move(history), .number = number, .motion = {}, .score = 0.0, .work = 0.0};
  const random::BranchedDraws draws(random::Draws(settings_.seed, number), particle.history.get());
  const Horizon& horizon = condition_->horizon;
  const Start start = start_of(condition_->scene, draws);
  const Beginning beginning = begin_realisation(*condition_, draws, start, Strobe::poincare,
                                                horizon.transient_periods + horizon.sampled_periods);
  particle.motion.emplace(motion_of(condition_->scene, beginning, observer_));
  particle.score = score_now(*particle.motion);
  return particle;
}

std::shared_ptr<DrawHistory> BlockModel::proposal(const Particle& particle, const Stream& stream) const {
  const random::Draws draws(settings_.seed, number_of(stream));
  auto history = std::make_shared<DrawHistory>(*particle.history);
  const double size = step_size(draws);
  for (random::GivenDraw& draw : history->given) {
    draw.number = moved(condition_->scene, draw.source, draw.number, size, draws);
  }
  if (moves_.along_the_way) history->branches.push_back({.number = number_of(stream), .from = {}, .size = size});
  return history;
}

void BlockModel::branch(Particle& particle, std::uint64_t number) const {
  if (particle.motion->ended()) return;
  SceneCoefficients coefficients = particle.motion->coefficients();
  auto history = std::make_shared<DrawHistory>(*particle.history);
  history->branches.push_back({.number = number, .from = coefficients.first_unused()});
  particle.history = std::move(history);
  coefficients.continue_with({random::Draws(settings_.seed, particle.number), particle.history.get()});
  particle.motion->continue_with(coefficients);
}

void BlockModel::advance(Particle& particle, double target) const {
  Motion& motion = *particle.motion;
  const Horizon& horizon = condition_->horizon;
  const double length = motion.clock().period_length() * (horizon.transient_periods + horizon.sampled_periods);
  const double from = motion.clock().tau();
  constexpr std::uint64_t steps_per_look = 64;  // at the clock
  integrate::LoopCounts counts;
  halt_.check();
  while (particle.score < target && !motion.ended()) {
    counts.steps % steps_per_look == 0 ? halt_.check() : halt_.check_request();
    integrate::step(motion, counts);
    particle.score = std::max(particle.score, score_now(motion));
  }
  particle.work += (motion.clock().tau() - from) / length;
}

double BlockModel::score_now(const Motion& motion) const {
  const double shape_angle = motion.setting().block.shape_angle;
  const double peak = motion.peaks().tilt / shape_angle;
  if (motion.termination() == dynamics::Termination::overturned) return event_score;
  if (settings_.event.peak_tilt && peak > *settings_.event.peak_tilt) return event_score;
  if (settings_.score == Score::tilt) return peak;
  const dynamics::State& state = motion.state();
  const auto constants = equation_constants(motion.setting());
  const double tilt = std::abs(state.tilt);
  const double potential = tilt < shape_angle ? dynamics::edge_angle(tilt, constants).cosine : 1.0;
  const double kinetic = 0.5 * state.tilt_rate * state.tilt_rate;
  return (kinetic + potential - constants.cosine) / (1.0 - constants.cosine);
}

}  // namespace rocking::rare
