#include "rocking/studies/rare/block_paths.hpp"

#include <atomic>

#include "rocking/base/many_parts.hpp"
#include "rocking/base/normal_law.hpp"
#include "rocking/studies/rare/importance.hpp"

namespace rocking::rare {
namespace {

using random::DrawHistory;
using random::Source;

const lanes::Kernels& fastest_kernels() { return lanes::available_kernels().back(); }

/// A displacement is that where the motion is now: at the end of the horizon.
Image::Fate fate_of(const Motion& motion, const ResponseEvent& event) {
  if (motion.termination() == dynamics::Termination::overturned) return Image::Fate::event;
  if (event.is_exceeded(peaks_of(motion, motion.setting().block))) return Image::Fate::event;
  const bool goes_on = !motion.ended() || motion.termination() == dynamics::Termination::reached_horizon;
  return goes_on ? Image::Fate::moves_on : Image::Fate::ends;
}

SectionPoint point_of(const StrobedMotion& motion) {
  const dynamics::State& state = motion.at_strobe();
  const double psi = motion.motion().setting().block.tilt_unit(state.tilt, state.tilt_rate);
  return {.tilt = state.tilt / psi, .tilt_rate = state.tilt_rate / psi, .slip_rate = state.slip_rate};
}

/// Standard deviations.
constexpr double amplitude_reach = 6.0;

/// The samples of a transition: their weights, and what each has instead of a draw.
struct Samples {
  std::vector<double> weights;
  std::vector<double> amplitudes;  ///< as those of Transitions
  std::vector<DrawHistory> given;
  std::vector<Start> starts;
};

Samples samples_of(const BlockPaths& paths, std::int64_t k, std::size_t count, const Proposal* proposal) {
  Samples samples;
  const Scene& scene = paths.condition->scene;
  const bool has_amplitude = redraws_amplitude(scene);
  double sum = 0.0;
  for (std::size_t j = 0; j < count; ++j) {
    const double z =
        count < 2 ? 0.0 : amplitude_reach * (2.0 * static_cast<double>(j) / (static_cast<double>(count) - 1.0) - 1.0);
    DrawHistory history;
    if (has_amplitude) {
      history.given.push_back({Source::amplitude, z, static_cast<std::uint64_t>(k)});
      samples.amplitudes.push_back(z);
    }
    samples.given.push_back(std::move(history));
    samples.weights.push_back(has_amplitude ? base::normal_density(z) : 1.0);
    sum += samples.weights.back();
    const Stream stream{.repetition = 0, .stage = stage_limit - 1, .particle = j, .move = 0};
    const random::Draws own(paths.seed, number_of(stream));
    DrawHistory once;
    if (proposal != nullptr) once = given_draws(scene, paths.numbers.once, proposal->draw(own));
    Start start = start_of(scene, random::BranchedDraws(own, &once));
    start.phase = 0.0;
    samples.starts.push_back(std::move(start));
  }
  for (double& weight : samples.weights) weight /= sum;
  return samples;
}

/// Images of some nodes at a time, on one thread.
class NodeRuns {
 public:
  NodeRuns(const BlockPaths& paths, const SectionGrid& grid, const Samples& samples, std::int64_t k)
      : paths_(&paths), grid_(&grid), samples_(&samples), k_(k), lanes_(fastest_kernels()) {}

  void run(std::size_t from, std::size_t to, std::vector<Image>& images) {
    const std::size_t count = samples_->weights.size();
    std::vector<std::unique_ptr<StrobedMotion>> motions;
    std::vector<StrobedMotion*> pointers;
    for (std::size_t i = from * count; i < to * count; ++i) {
      motions.push_back(begin(i / count, i % count));
      pointers.push_back(motions.back().get());
    }
    lanes_.run(pointers, [this] { paths_->halt.check(); });
    paths_->note_work(static_cast<double>(motions.size()) / static_cast<double>(paths_->periods()));
    for (std::size_t i = from * count; i < to * count; ++i) {
      const StrobedMotion& motion = *motions[i - from * count];
      images[i] = {.fate = fate_of(motion.motion(), paths_->event), .point = point_of(motion)};
    }
  }

 private:
  [[nodiscard]] std::unique_ptr<StrobedMotion> begin(std::size_t node, std::size_t sample) {
    const Condition& condition = *paths_->condition;
    const std::size_t number = node * samples_->weights.size() + sample;
    const auto period = static_cast<std::uint64_t>(k_);
    const Stream stream{.repetition = repetition_limit - 1 - period % (repetition_limit / 2),
                        .stage = number / particle_limit,
                        .particle = number % particle_limit,
                        .move = 0};
    const random::BranchedDraws draws(random::Draws(paths_->seed, number_of(stream)), &samples_->given[sample]);
    Beginning beginning = begin_realisation(condition, draws, samples_->starts[sample], Strobe::poincare, 1);
    const SectionPoint at = grid_->node(node);
    const double psi = beginning.setting.block.tilt_unit(at.tilt, at.tilt_rate);
    beginning.state = {.tilt = psi * at.tilt, .tilt_rate = psi * at.tilt_rate, .slip_rate = at.slip_rate};
    beginning.clock.set({.period = k_, .time = 0.0});
    beginning.schedule.first_strobe = {.period = k_ + 1, .time = 0.0};
    const dynamics::Excitation& excitation = excitation_.of(condition.scene, beginning);
    auto motion = std::make_unique<StrobedMotion>(
        [&](dynamics::Observer& observer) { return motion_of(beginning, observer, excitation); });
    if (paths_->event.is_overturning()) motion->motion().ignore_peaks();
    return motion;
  }

  const BlockPaths* paths_;
  const SectionGrid* grid_;
  const Samples* samples_;
  std::int64_t k_;
  Lockstep lanes_;
  SharedExcitation excitation_;
};

}  // namespace

bool redraws_amplitude(const Scene& scene) {
  return scene.fluctuation.amplitude > 0.0 && amplitude_draws(scene.excitation) == AmplitudeDraws::each_period;
}

double Guide::score(std::int64_t k, const SectionPoint& point) const {
  const double root = std::max(committor.eighth_root(k, point), eighth_root(least));
  const double square = root * root;
  return square * square * square * root;
}

Transitions transitions_of(const BlockPaths& paths, const SectionGrid& grid, std::int64_t k, std::size_t samples,
                           unsigned threads, const Proposal* proposal) {
  const Samples all = samples_of(paths, k, samples, proposal);
  Transitions transitions{
      .weights = all.weights, .images = std::vector<Image>(grid.size() * samples), .amplitudes = all.amplitudes};
  constexpr std::size_t nodes_at_once = 64;
  std::atomic<std::size_t> next = 0;
  base::on_threads(
      threads,
      [&](unsigned) {
        NodeRuns runs(paths, grid, all, k);
        for (std::size_t from = next.fetch_add(nodes_at_once); from < grid.size();
             from = next.fetch_add(nodes_at_once)) {
          runs.run(from, std::min(from + nodes_at_once, grid.size()), transitions.images);
        }
      },
      [&] { next = grid.size(); });
  return transitions;
}

std::vector<double> BlockPoints::scores(const std::vector<Point>& points) const {
  const Condition& condition = *paths_->condition;
  constexpr std::size_t at_once = 256;
  Lockstep lanes(fastest_kernels());
  SharedExcitation excitation;
  std::vector<double> scores;
  for (std::size_t from = 0; from < points.size(); from += at_once) {
    std::vector<DrawHistory> histories;
    histories.reserve(at_once);
    std::vector<std::unique_ptr<StrobedMotion>> motions;
    std::vector<StrobedMotion*> pointers;
    for (std::size_t i = from; i < std::min(from + at_once, points.size()); ++i) {
      histories.push_back(given_draws(condition.scene, paths_->numbers.once, points[i]));
      const random::BranchedDraws draws(random::Draws(paths_->seed, 0), &histories.back());
      const Start start = start_of(condition.scene, draws);
      const Beginning beginning = begin_realisation(condition, draws, start, Strobe::poincare, paths_->periods());
      const dynamics::Excitation& shaking = excitation.of(condition.scene, beginning);
      motions.push_back(std::make_unique<StrobedMotion>(
          [&](dynamics::Observer& observer) { return motion_of(beginning, observer, shaking); }));
      pointers.push_back(motions.back().get());
    }
    lanes.run(pointers, [this] { paths_->halt.check(); });
    paths_->note_work(static_cast<double>(pointers.size()));
    for (const StrobedMotion* motion : pointers) {
      const Motion& ended = motion->motion();
      const Image::Fate fate = fate_of(ended, paths_->event);
      scores.push_back(fate == Image::Fate::event  ? event_score
                       : fate == Image::Fate::ends ? unresolved_score
                                                   : paths_->event.measured(peaks_of(ended, ended.setting().block)));
    }
  }
  return scores;
}

BlockPopulation::BlockPopulation(const BlockPaths& paths, const PopulationPlan& plan)
    : paths_(&paths), plan_(plan), lanes_(fastest_kernels()) {
  SharedExcitation excitation;
  std::vector<StrobedMotion*> all;
  for (std::size_t i = 0; i < plan.particles; ++i) {
    particles_.push_back(begin(i, excitation));
    all.push_back(particles_.back().motion.get());
  }
  run(all);
}

BlockPopulation::Particle BlockPopulation::begin(std::size_t i, SharedExcitation& excitation) {
  const Condition& condition = *paths_->condition;
  Particle particle;
  particle.number = number_of({.repetition = plan_.repetition, .stage = 0, .particle = i, .move = 0});
  particle.history = std::make_unique<DrawHistory>();
  const random::Draws own(paths_->seed, particle.number);
  if (plan_.proposal != nullptr) {
    const Point& point = drawn_at_first_.emplace_back(plan_.proposal->draw(own));
    particle.likelihood_ratio = plan_.proposal->likelihood_ratio(point);
    const double root = std::sqrt(particle.likelihood_ratio);
    particle.first_score = 1.0 / (root * std::sqrt(root));
    *particle.history = given_draws(condition.scene, paths_->numbers.once, point);
  }
  if (redraws_amplitude(condition.scene)) static_cast<void>(draw_amplitude(particle, 0, plan_.first_amplitude));
  const random::BranchedDraws draws(own, particle.history.get());
  const Start start = start_of(condition.scene, draws);
  const Beginning beginning = begin_realisation(condition, draws, start, Strobe::poincare, plan_.strobe_points);
  const dynamics::Excitation& shaking = excitation.of(condition.scene, beginning);
  particle.motion = std::make_unique<StrobedMotion>(
      [&](dynamics::Observer& observer) { return motion_of(beginning, observer, shaking); });
  if (paths_->event.is_overturning()) particle.motion->motion().ignore_peaks();
  return particle;
}

/// Draws the normal number of the amplitude of a period by this law, in a part of the cases by its own one, so that the
/// likelihood ratio, by which it multiplies that of the particle, is at most 1/own_share. Whether the number is another
/// one than that of the particle's draws.
bool BlockPopulation::draw_amplitude(Particle& particle, std::int64_t period, const NormalLaw& law) const {
  constexpr double own_share = 0.5;  // a wrong law makes weights spread by this in each period
  constexpr double like_own = 0.05;
  constexpr std::uint64_t choices = std::uint64_t{1} << 32U;
  if (std::abs(law.mean) < like_own && std::abs(law.width - 1.0) < like_own) return false;
  const auto index = static_cast<std::uint64_t>(period);
  const auto& branches = particle.history->branches;
  const random::Draws draws(paths_->seed, branches.empty() ? particle.number : branches.back().number);
  const bool is_own = draws.uniform(Source::rare_choice, choices + index) < own_share;
  double number = draws.standard_normal(Source::amplitude, index);
  if (!is_own) {
    number = law.mean + law.width * number;
    particle.history->given.push_back({Source::amplitude, number, index});
  }
  const double own = base::normal_density(number);
  const double other = base::normal_density((number - law.mean) / law.width) / law.width;
  particle.likelihood_ratio *= own / (own_share * own + (1.0 - own_share) * other);
  return !is_own;
}

double BlockPopulation::first_amplitude(std::size_t i) const {
  const random::Draws own(paths_->seed, particles_[i].number);
  return random::BranchedDraws(own, particles_[i].history.get()).standard_normal(Source::amplitude, 0);
}

Image::Fate BlockPopulation::fate(std::size_t i) const {
  return fate_of(particles_[i].motion->motion(), paths_->event);
}

SectionPoint BlockPopulation::point(std::size_t i) const { return point_of(*particles_[i].motion); }

double BlockPopulation::score(std::int64_t k, std::size_t i) {
  const SectionPoint at = point(i);
  constexpr double nearly_sure = 0.9;
  if (plan_.guide == nullptr || plan_.guide->committor(k, at) < nearly_sure) {
    reach_.tilt = std::max(reach_.tilt, std::abs(at.tilt));
    reach_.tilt_rate = std::max(reach_.tilt_rate, std::abs(at.tilt_rate));
    reach_.slip_rate = std::max(reach_.slip_rate, std::abs(at.slip_rate));
  }
  return plan_.guide == nullptr ? 1.0 : plan_.guide->score(k, at) * particles_[i].first_score;
}

void BlockPopulation::branch(std::size_t i, std::size_t parent, const Stream& stream) {
  Particle& child = particles_[i];
  const Particle& from = particles_[parent];
  child.motion->become(*from.motion);
  child.number = from.number;
  *child.history = *from.history;
  child.first_score = from.first_score;
  child.has_left = false;
  Motion& motion = child.motion->motion();
  SceneCoefficients coefficients = motion.coefficients();
  coefficients.draw_amplitude_again(motion.clock());
  child.history->branches.push_back({.number = number_of(stream), .from = coefficients.first_unused()});
  coefficients.continue_with({random::Draws(paths_->seed, child.number), child.history.get()});
  motion.continue_with(coefficients);
}

void BlockPopulation::advance() {
  std::vector<StrobedMotion*> going;
  for (Particle& particle : particles_) {
    Motion& motion = particle.motion->motion();
    if (particle.has_left || fate_of(motion, paths_->event) != Image::Fate::moves_on) continue;
    particle.likelihood_ratio = 1.0;
    const NormalLaw law = plan_.guide == nullptr
                              ? NormalLaw{}
                              : plan_.guide->committor.amplitude(strobe_point_, point_of(*particle.motion));
    if (draw_amplitude(particle, strobe_point_, law)) {
      SceneCoefficients coefficients = motion.coefficients();
      coefficients.draw_amplitude_again(motion.clock());
      motion.continue_with(coefficients);
    }
    motion.extend(1);
    going.push_back(particle.motion.get());
  }
  ++strobe_point_;
  run(going);
}

void BlockPopulation::run(const std::vector<StrobedMotion*>& motions) {
  const auto time = [&] {
    double sum = 0.0;
    for (const StrobedMotion* motion : motions) {
      const dynamics::Clock& clock = motion->motion().clock();
      sum += clock.tau() / clock.period_length();
    }
    return sum;
  };
  const double before = time();
  lanes_.run(motions, [this] { paths_->halt.check(); });
  const double work = (time() - before) / static_cast<double>(paths_->periods());
  work_ += work;
  paths_->note_work(work);
}

}  // namespace rocking::rare
