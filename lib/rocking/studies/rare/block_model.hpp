#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "rocking/dynamics/observer.hpp"
#include "rocking/random/branched_draws.hpp"
#include "rocking/realisation/start.hpp"
#include "rocking/scene/experiment.hpp"
#include "rocking/studies/rare/estimate.hpp"
#include "rocking/studies/rare/halt.hpp"
#include "rocking/studies/rare/stream.hpp"

namespace rocking::rare {

/// How the random numbers of a scene are changed from particle to particle.
struct Moves {
  std::vector<random::Source> once;  ///< drawn once: changed by a Markov chain
  bool along_the_way = false;        ///< drawn along the way: drawn anew from the level on
};
[[nodiscard]] Moves moves_of(const Scene& scene);

/// Keeps nothing: one object serves all motions and threads.
struct Unobserved final : dynamics::Observer {
  void event(dynamics::EventKind, double, const dynamics::State&) override {}
  void strobe(const dynamics::State&) override {}
};

/// The motions of one condition, for splitting (SplittingModel).
class BlockModel {
 public:
  struct Settings {
    std::uint64_t seed = 0;
    Event event;
    Score score = Score::tilt;
    int chain_steps = 2;  ///< Markov chain steps of a particle at a level; 0 only where all draws are along the way
  };

  /// A trajectory as far as it has been run. The motion refers to the random numbers.
  struct Particle {
    std::shared_ptr<const random::DrawHistory> history;
    std::uint64_t number = 0;  ///< realisation number of the draws before the first branch
    std::optional<Motion> motion;
    double score = 0.0;
    double work = 0.0;  ///< of the call that made it; a realisation to its horizon is 1
  };

  /// Precondition: the condition passes check_rare. It must outlive the model, and the model its particles.
  /// The functions throw as Halt::check.
  BlockModel(const Condition& condition, const Settings& settings, Halt halt = {});

  [[nodiscard]] Particle start(const Stream& stream, double target) const;
  /// Changes all numbers by `chain_steps` Metropolis steps, given that the level is reached, then draws those along the
  /// way anew from there on.
  [[nodiscard]] Particle go_on(const Particle& parent, const Stream& stream, double level, double target) const;
  /// The same trajectory, run again from its start with its random numbers, as far as it was run: to its score.
  [[nodiscard]] Particle replay(const Particle& particle) const;
  [[nodiscard]] static double score(const Particle& particle) { return particle.score; }
  [[nodiscard]] static double work(const Particle& particle) { return particle.work; }

 private:
  [[nodiscard]] Particle begin(std::shared_ptr<const random::DrawHistory> history, std::uint64_t number) const;
  [[nodiscard]] std::shared_ptr<random::DrawHistory> proposal(const Particle& particle, const Stream& stream) const;
  void branch(Particle& particle, std::uint64_t number) const;
  void advance(Particle& particle, double target) const;
  [[nodiscard]] double score_now(const Motion& motion) const;

  const Condition* condition_;
  Settings settings_;
  Halt halt_;
  Moves moves_;
  mutable Unobserved observer_;
};

}  // namespace rocking::rare
